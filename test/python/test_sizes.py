#!/usr/bin/env python3
"""Sizes of all kinds."""
import os
import tempfile

from common import MeshTest, box, br, main, np

POINTS, TRIANGLES, _ = box()


def mean_length(m, center, radius):
    """That of the edges inside near a place."""
    edges = np.concatenate([m.tetrahedra[:, [i, j]] for i in range(4) for j in range(i)])
    edges = np.unique(np.sort(edges, axis=1), axis=0)
    edges = edges[(edges >= len(POINTS)).any(axis=1)]
    ends = m.points[edges]
    near = np.linalg.norm(ends.mean(axis=1) - center, axis=1) < radius
    return np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1)[near].mean()


class SizesTest(MeshTest):
    def mesh(self, **options):
        m = br.tetrahedralize(POINTS, TRIANGLES, **options)
        self.assertTrue(m, m.status)
        self.check_mesh(m, POINTS, TRIANGLES, 1.0)
        return m

    def test_the_surface(self):
        fine, coarse = self.mesh(grading=0.0), self.mesh(grading=1.0)
        self.assertGreater(len(fine.tetrahedra), len(coarse.tetrahedra))

    def test_a_number(self):
        numbers = [len(self.mesh(size=h).tetrahedra) for h in (0.2, 0.1)]
        self.assertTrue(4 < numbers[1] / numbers[0] < 12)
        self.assertEqual(self.mesh(size=0.1).points.tobytes(), self.mesh(size=np.float64(0.1)).points.tobytes())

    def test_sizes_at_points(self):
        sizes = np.where(POINTS[:, 0] == 0, 0.05, 0.3)
        m = self.mesh(size=sizes, grading=0.3)
        self.assertLess(mean_length(m, [0.1, 0.5, 0.5], 0.2), 0.6 * mean_length(m, [0.8, 0.5, 0.5], 0.2))
        self.assertEqual(m.points.tobytes(), self.mesh(size=sizes.tolist(), grading=0.3).points.tobytes())

    def test_a_function(self):
        asked = []

        def size(p):
            asked.append(p.shape)
            return 0.08 + 0.2 * p[:, 0]

        m = self.mesh(size=size)
        self.assertEqual(asked[0], (len(POINTS), 3))
        self.assertTrue(all(len(shape) == 2 and shape[1] == 3 for shape in asked))
        self.assertLess(mean_length(m, [0.1, 0.5, 0.5], 0.2), 0.8 * mean_length(m, [0.8, 0.5, 0.5], 0.2))
        self.assertLess(len(asked), len(m.points))
        places = np.array([shape[0] for shape in asked])
        self.assertTrue((places[1:] == 125).all())
        again = self.mesh(size=lambda p: 0.08 + 0.2 * p[:, 0])
        self.assertEqual(m.tetrahedra.tobytes(), again.tetrahedra.tobytes())
        number = self.mesh(size=lambda p: 0.2)
        self.assertLess(len(number.tetrahedra), len(m.tetrahedra))

    def test_a_function_that_is_not_defined_outside(self):
        points, triangles, _ = box(high=(1, 1, 0.3), n=(4, 4, 2))
        m = br.tetrahedralize(points, triangles, size=lambda p: np.where((p[:, 2] >= 0) & (p[:, 2] <= 0.3), 0.1, np.nan))
        self.assertTrue(m)
        self.check_mesh(m, points, triangles, 0.3)
        with self.assertRaises(ValueError):
            br.tetrahedralize(points, triangles, size=lambda p: np.where(p[:, 0] < 0.5, 0.1, np.nan))

    def test_a_function_that_jumps(self):
        def size(p):
            return np.where(np.linalg.norm(p - 0.5, axis=1) < 0.2, 0.03, 0.2)

        m = self.mesh(size=size)
        self.assertLess(mean_length(m, [0.5, 0.5, 0.5], 0.15), 0.04)

    def test_sources(self):
        for source in (br.Source((0.5, 0.5, 0.5), 0.04), br.Source([(0.5, 0.5, 0.4), (0.5, 0.5, 0.6)], 0.04, radius=0.05),
                       br.Source([(0.5, 0.5, 0.4), (0.5, 0.5, 0.6), (0.5, 0.6, 0.5)], 0.04, doubling=0.2),
                       br.Source([(0.45, 0.45, 0.45), (0.55, 0.55, 0.55)], 0.04, box=True)):
            m = self.mesh(size=0.3, sources=[source])
            self.assertLess(mean_length(m, [0.5, 0.5, 0.5], 0.1), 0.08)
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "sources.txt")
            with open(file, "w") as stream:
                stream.write("point 0.5 0.5 0.5 0.04 0 0.2\n")
            m = self.mesh(size=0.3, sources=file)
            other = self.mesh(size=0.3, sources=[br.Source((0.5, 0.5, 0.5), 0.04, grading=0.2)])
            self.assertEqual(m.points.tobytes(), other.points.tobytes())

    def test_background(self):
        coarse = br.recover_boundary(POINTS, TRIANGLES)
        sizes = 0.06 + 0.2 * coarse.points[:, 0]
        m = self.mesh(size=1.0, background=(coarse.points, coarse.tetrahedra, sizes), grading=np.inf)
        self.assertLess(mean_length(m, [0.1, 0.5, 0.5], 0.2), 0.8 * mean_length(m, [0.8, 0.5, 0.5], 0.2))

    def test_limits(self):
        m = br.tetrahedralize(POINTS, TRIANGLES, size=0.05, max_vertices=200)
        self.assertEqual((m.status, bool(m)), ("too_large", False))
        self.assertGreater(m.report["filling"]["forecast_of_vertices"], 200)
        m = br.tetrahedralize(POINTS, TRIANGLES, size=0.02, time_limit=0.05)
        self.assertEqual(m.status, "stopped")

    def test_what_is_no_size(self):
        for size in (0, -1.0, float("nan"), float("inf"), np.full(3, 0.1), np.zeros(len(POINTS)), lambda p: -1.0,
                     lambda p: np.zeros(5), lambda p: float("nan")):
            with self.assertRaises(ValueError):
                br.tetrahedralize(POINTS, TRIANGLES, size=size)
        for options in ({"grading": -1}, {"sources": [br.Source((0, 0, 0), -1.0)]}, {"grading": np.inf},
                        {"background": (POINTS, [[0, 1, 2, 99999]], np.ones(len(POINTS)))}):
            with self.assertRaises(ValueError):
                br.tetrahedralize(POINTS, TRIANGLES, **options)
        with self.assertRaises(FileNotFoundError):
            br.tetrahedralize(POINTS, TRIANGLES, sources="/no/such/file")
        with self.assertRaises(ValueError):
            br.tetrahedralize(POINTS, TRIANGLES, background="/no/such/file")


main()
