"""What the tests of the Python module have in common. Without numpy, they skip themselves."""
import os
import sys
import unittest

try:
    import numpy as np
except ImportError:
    print("skipped: numpy (python3-numpy) is not there")
    sys.exit(77)

import boundary_recovery as br

DATA = os.path.join(os.environ.get("CGAL_DATA_DIR", os.path.join(os.path.dirname(__file__), "../../data")), "meshes")


def mesh_file(name):
    return os.path.join(DATA, name)


def box(low=(0, 0, 0), high=(1, 1, 1), n=(4, 4, 4)):
    """A box with a grid of triangles on it, turned outward: points, triangles, and the number of its side, from 1, as
    x low, x high, y low, ..."""
    number, triangles, sides = {}, [], []

    def vertex(p):
        return number.setdefault(tuple(p), len(number))

    for axis in range(3):
        j, k = (axis + 1) % 3, (axis + 2) % 3
        for side in (0, 1):
            for u in range(n[j]):
                for v in range(n[k]):
                    square = []
                    for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        p = [0, 0, 0]
                        p[axis], p[j], p[k] = side * n[axis], u + du, v + dv
                        square.append(vertex(p))
                    if side == 0:
                        square.reverse()
                    a, b, c, d = square
                    triangles += [(a, b, c), (a, c, d)] if (u + v) % 2 else [(a, b, d), (b, c, d)]
                    sides += [2 * axis + side + 1] * 2
    low, high = np.asarray(low, dtype=float), np.asarray(high, dtype=float)
    points = low + np.array(list(number)) / np.array(n) * (high - low)
    return points, np.array(triangles), np.array(sides, dtype=np.int32)


def volumes(points, tetrahedra):
    p = points[tetrahedra]
    return np.einsum("ij,ij->i", np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), p[:, 3] - p[:, 0]) / 6


def facets_of(tetrahedra):
    """Each facet once: sorted, and how many tetrahedra have it."""
    corners = np.concatenate([np.delete(tetrahedra, i, axis=1) for i in range(4)])
    return np.unique(np.sort(corners, axis=1), axis=0, return_counts=True)


class MeshTest(unittest.TestCase):
    def check_mesh(self, mesh, points, triangles, volume=None):
        """It is a mesh, it has the input first, bit for bit, and each triangle of it."""
        self.assertEqual(mesh.points[:len(points)].tobytes(), np.ascontiguousarray(points).tobytes())
        self.assertTrue((volumes(mesh.points, mesh.tetrahedra) > 0).all())
        facets, counts = facets_of(mesh.tetrahedra)
        self.assertLessEqual(counts.max(), 2)
        there = set(map(tuple, facets.tolist()))
        for t in np.sort(mesh.triangles, axis=1).tolist():
            self.assertIn(tuple(t), there)
        order = np.argsort(mesh.triangle_numbers)
        np.testing.assert_array_equal(mesh.triangles[order], triangles)
        np.testing.assert_array_equal(mesh.triangle_numbers[order], np.arange(len(triangles)))
        if volume is not None:
            self.assertAlmostEqual(volumes(mesh.points, mesh.tetrahedra).sum(), volume, delta=1e-9 * volume)


def main():
    unittest.main(verbosity=2)
