#!/usr/bin/env python3
"""Invalid surfaces and arguments, exceptions of the user's functions."""
import pickle

from common import MeshTest, box, br, main, np

POINTS, TRIANGLES, _ = box(n=(2, 2, 2))


class ErrorsTest(MeshTest):
    def invalid(self, points, triangles, kind):
        with self.assertRaises(br.InvalidSurface) as raised:
            br.tetrahedralize(points, triangles)
        error = raised.exception
        self.assertIsInstance(error, ValueError)
        self.assertEqual(error.kind, kind)
        self.assertEqual(error.defects.shape, (len(error.points), 2))
        self.assertEqual(error.points.shape[1:], (3,))
        self.assertGreaterEqual(error.number_of_defects, len(error.defects))
        self.assertIn(kind, str(error))
        again = pickle.loads(pickle.dumps(error))
        self.assertEqual((again.kind, str(again)), (error.kind, str(error)))
        return error

    def test_triangles_that_intersect(self):
        points = np.concatenate([POINTS, [[0.3, 0.5, 0.2], [0.7, 0.5, 0.2], [0.5, 0.5, 2.0]]])
        n = len(POINTS)
        error = self.invalid(points, np.concatenate([TRIANGLES, [[n, n + 1, n + 2]]]), "intersecting_constraints")
        for (a, b), place in zip(error.defects, error.points):
            self.assertIn(len(TRIANGLES), (a, b))
            self.assertGreaterEqual(min(a, b), 0)
            self.assertAlmostEqual(place[2], 1.0)

    def test_other_defects(self):
        error = self.invalid(POINTS, np.concatenate([TRIANGLES, TRIANGLES[:1]]), "duplicate_facet")
        self.assertEqual(error.defects.tolist(), [[0, len(TRIANGLES)]])
        a, b, c = TRIANGLES[0]
        error = self.invalid(POINTS, np.concatenate([TRIANGLES, [[a, a, b]]]), "degenerate_facet")
        self.assertEqual(error.defects.tolist(), [[len(TRIANGLES), -1]])
        for number in (len(POINTS), -1):
            error = self.invalid(POINTS, np.concatenate([TRIANGLES, [[a, b, number]]]), "index_out_of_range")
            self.assertEqual(error.defects.tolist(), [[len(TRIANGLES), -1]])
        bad = POINTS.copy()
        bad[3, 1] = np.nan
        error = self.invalid(bad, TRIANGLES, "non_finite_coordinate")
        self.assertEqual(error.defects.tolist(), [[3, -1]])
        double = np.concatenate([POINTS, POINTS[:1]])
        moved = TRIANGLES.copy()
        moved[np.argwhere(moved == 0)[0][0]][moved[np.argwhere(moved == 0)[0][0]] == 0] = len(POINTS)
        error = self.invalid(double, moved, "coincident_vertices")
        self.assertEqual(sorted(error.defects[0]), [0, len(POINTS)])
        self.invalid(POINTS, TRIANGLES[:0], "empty_input")

    def test_arguments(self):
        for points, triangles, options in (
                (POINTS[:, :2], TRIANGLES, {}), (POINTS, TRIANGLES[:, :2], {}), (POINTS.ravel(), TRIANGLES, {}),
                (POINTS, TRIANGLES, {"patches": [1, 2]}), (POINTS, TRIANGLES, {"effort": "enormous"}),
                (POINTS, TRIANGLES, {"min_angle": 80}), (POINTS, TRIANGLES, {"threads": 0}),
                (POINTS, TRIANGLES, {"edges": [[1, 2, 3]]})):
            with self.assertRaises(ValueError):
                br.tetrahedralize(points, triangles, **options)
        with self.assertRaises(TypeError):
            br.tetrahedralize(POINTS, TRIANGLES.astype(float))
        with self.assertRaises(TypeError):
            br.tetrahedralize(POINTS, TRIANGLES, sises=1)
        with self.assertRaises(ValueError):
            br.recover_boundary(POINTS, TRIANGLES, mode="magic")

    def test_exceptions_come_out_unchanged(self):
        mine = KeyError("mine")

        def raising(*_):
            raise mine

        def raising_inside(p):
            return raising() if len(p) != len(POINTS) else np.full(len(p), 0.2)

        for options in ({"size": raising}, {"size": raising_inside}, {"progress": raising}):
            try:
                br.tetrahedralize(POINTS, TRIANGLES, **options)
            except KeyError as error:
                self.assertIs(error, mine)
                self.assertIn("raising", list(self.frames(error)))
            else:
                self.fail("nothing was raised")
        with self.assertRaises(ValueError):
            br.tetrahedralize(POINTS, TRIANGLES, size=lambda p: np.full((len(p), 2), 0.2))
        with self.assertRaises((TypeError, ValueError)):
            br.tetrahedralize(POINTS, TRIANGLES, size=lambda p: "large")

    @staticmethod
    def frames(error):
        trace = error.__traceback__
        while trace:
            yield trace.tb_frame.f_code.co_name
            trace = trace.tb_next

    def test_the_module_works_after_all_that(self):
        self.check_mesh(br.tetrahedralize(POINTS, TRIANGLES), POINTS, TRIANGLES, 1.0)

    def test_repair(self):
        # each triangle with points of its own
        points = POINTS[TRIANGLES].reshape(-1, 3)
        triangles = np.arange(len(points)).reshape(-1, 3)
        self.invalid(points, triangles, "coincident_vertices")
        m = br.tetrahedralize(points, triangles, repair=True, patches=np.arange(len(triangles)))
        self.assertTrue(m)
        np.testing.assert_array_equal(m.patches, m.triangle_numbers)
        self.assertEqual(m.report["repair"]["open_edges_after"], 0)
        s = br.repair(points + 1e-9 * np.sin(np.arange(3 * len(points))).reshape(-1, 3), triangles, tolerance=1e-6)
        self.assertEqual(len(s.points), len(POINTS))
        self.assertGreater(s.changes["number_of_merged_points"], 0)
        with self.assertRaises(br.InvalidSurface):
            br.repair(POINTS, [[0, 1, 999]])


main()
