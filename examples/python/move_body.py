#!/usr/bin/env python3
"""A cube moves through a channel, the mesh around it is deformed, and what has become bad is replaced now and then.

The solution goes along: points that stay have theirs, new ones interpolate it in the old mesh.
"""
import sys

try:
    import numpy as np
except ImportError:
    print("skipped: numpy (python3-numpy) is not there")
    sys.exit(77)

import boundary_recovery as br


def add_box(number, triangles, low, high, is_outward):
    """The sides of a box of squares, of which each is two triangles."""
    for axis in range(3):
        j, k = (axis + 1) % 3, (axis + 2) % 3
        for is_high in (False, True):
            for u in range(low[j], high[j]):
                for v in range(low[k], high[k]):
                    square = []
                    for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        p = [0, 0, 0]
                        p[axis], p[j], p[k] = (high if is_high else low)[axis], u + du, v + dv
                        square.append(number.setdefault(tuple(p), len(number)))
                    a, b, c, d = square if is_high == is_outward else square[::-1]
                    triangles += [(a, b, c), (a, c, d)]


def channel():
    number, triangles = {}, []
    add_box(number, triangles, (0, 0, 0), (16, 8, 8), True)
    outside = len(triangles)
    add_box(number, triangles, (2, 3, 3), (4, 5, 5), False)
    patches = np.where(np.arange(len(triangles)) < outside, 1, 2)
    return np.array(list(number)) / 2.0, np.array(triangles), patches


def main():
    points, triangles, patches = channel()
    mesh = br.tetrahedralize(points, triangles, patches=patches, patch_names={1: "channel", 2: "cube"})
    assert mesh
    print(mesh)
    motion, center = np.array([0.2, 0, 0]), np.array([1.5, 2, 2])
    solution = mesh.points @ [3.0, -2.0, 0.5]  # a solver would have it
    number_of_remeshings = 0
    for step in range(20):
        # The points of the cube move by `motion`, the others the less the farther they are away.
        distance = np.abs(mesh.points - center).max(axis=1) - 0.5
        share = np.clip(1 - np.maximum(0, distance), 0, 1)
        moved = mesh.points + share[:, None] * motion
        solution = solution + share * (motion @ [3.0, -2.0, 0.5])  # the solver's work, on the moved mesh
        center = center + motion

        new = br.remesh_holes(moved, mesh.tetrahedra, triangles=mesh.triangles, patches=mesh.patches,
                              patch_names=mesh.patch_names, min_angle=10)
        assert new, new.status
        solution = new.transfer(solution)
        mesh = new
        if new.report["number_of_holes"] > 0:
            number_of_remeshings += 1
            print("step %d: %d of %d tetrahedra are new, their smallest angle is %.1f degrees" % (
                step, (new.old_tetrahedra < 0).sum(), len(new.tetrahedra), new.report["smallest_new_angle"]))
    corners = mesh.points[mesh.triangles[mesh.patches == 2]].reshape(-1, 3)
    print("the cube is at", corners.mean(axis=0).round(3))
    assert number_of_remeshings > 0 and np.allclose([corners.min(axis=0), corners.max(axis=0)], [center - 0.5, center + 0.5])
    assert np.allclose(solution, mesh.points @ [3.0, -2.0, 0.5])


main()
