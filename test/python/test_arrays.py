#!/usr/bin/env python3
"""Arrays in and out: shapes, types, strides, numbers."""
from common import MeshTest, box, br, main, mesh_file, np


class ArraysTest(MeshTest):
    def test_types_and_shapes(self):
        points, triangles, _ = box()
        m = br.tetrahedralize(points, triangles, size=0.25)
        self.assertTrue(m)
        self.assertEqual(m.status, "meshed")
        self.check_mesh(m, points, triangles, 1.0)
        self.assertEqual([(a.dtype, a.ndim) for a in (m.points, m.tetrahedra, m.regions, m.triangles, m.patches,
                                                      m.triangle_numbers)],
                         [(np.float64, 2), (np.int64, 2), (np.int32, 1), (np.int64, 2), (np.int32, 1), (np.int64, 1)])
        self.assertEqual(m.points.shape[1], 3)
        self.assertEqual(m.tetrahedra.shape, (len(m.regions), 4))
        self.assertTrue((m.patches == 1).all())
        self.assertIn("meshed", repr(m))

    def test_any_strides_and_integers(self):
        points, triangles, _ = box(n=(2, 2, 2))
        expected = br.tetrahedralize(points, triangles, size=0.5)
        wide = np.zeros((len(points), 7))
        wide[:, 1:7:2] = points
        for p in (np.asfortranarray(points), wide[:, 1:7:2], points.tolist(), points[::-1][::-1]):
            for t in [triangles.astype(i) for i in (np.int8, np.uint16, np.int32, np.uint32, np.int64, np.uint64, ">i4")]:
                m = br.tetrahedralize(p, np.asfortranarray(t), size=0.5)
                self.assertEqual(m.points.tobytes(), expected.points.tobytes())
                self.assertEqual(m.tetrahedra.tobytes(), expected.tetrahedra.tobytes())

    def test_patches_come_out_again(self):
        points, triangles, sides = box()
        names = {1: "inlet", 2: "outlet"}
        m = br.tetrahedralize(points, triangles, patches=sides, patch_names=names)
        np.testing.assert_array_equal(m.patches, sides[m.triangle_numbers])
        self.assertEqual(m.patch_names, names)
        for axis in range(3):
            for side in (0, 1):
                corners = m.points[m.triangles[m.patches == 2 * axis + side + 1]]
                self.assertTrue((corners[:, :, axis] == side).all())

    def test_points_that_no_triangle_has(self):
        points, triangles, _ = box(n=(2, 2, 2))
        more = np.concatenate([[[9.0, 9, 9]], points, [[0.5, 0.51, 0.52]], [points[3]]])
        m = br.tetrahedralize(more, triangles + 1, size=0.5)
        self.check_mesh(m, more, triangles + 1, 1.0)
        self.assertNotIn(0, m.tetrahedra)
        self.assertIn(len(points) + 1, m.tetrahedra)

    def test_two_regions(self):
        s = br.read(mesh_file("two_cubes_br3.off"))
        m = br.tetrahedralize(s.points, s.triangles)
        self.check_mesh(m, s.points, s.triangles)
        self.assertEqual(sorted(set(m.regions)), [1, 2])
        self.assertEqual(m.report["number_of_regions"], 2)

    def test_edges_inside(self):
        points, triangles, _ = box(n=(2, 2, 2))
        more = np.concatenate([points, [[0.3, 0.3, 0.3], [0.7, 0.6, 0.5]]])
        edge = [len(points), len(points) + 1]
        m = br.tetrahedralize(more, triangles, size=0.4, edges=[edge])
        self.assertEqual(m.edges.tolist(), [edge])
        self.assertTrue((np.isin(m.tetrahedra, edge).sum(axis=1) == 2).any())

    def test_recovery_alone(self):
        s = br.read(mesh_file("schoenhardt_br3.off"))
        m = br.recover_boundary(s.points, s.triangles)
        self.assertEqual(m.status, "recovered")
        self.check_mesh(m, s.points, s.triangles)
        self.assertGreater(len(m.points), len(s.points))
        m = br.recover_boundary(s.points, s.triangles, mode="flips_only")
        self.assertEqual(m.status, "incomplete")
        self.assertFalse(m)
        self.assertGreater(len(m.missing), 0)
        self.assertEqual(len(m.tetrahedra), 0)
        m = br.recover_boundary(s.points, s.triangles, mode="conforming", outside=True)
        self.assertEqual(m.status, "recovered")
        self.assertEqual(set(m.triangle_numbers), set(range(len(s.triangles))))
        self.assertIn(0, m.regions)

    def test_open_surface(self):
        points, triangles, _ = box(n=(2, 2, 2))
        m = br.tetrahedralize(points, triangles[1:])
        self.assertEqual((m.status, bool(m), len(m.tetrahedra)), ("no_region", False, 0))
        m = br.recover_boundary(points, triangles[1:], outside=True)
        self.assertEqual((m.status, set(m.regions)), ("recovered", {0}))

    def test_bad_cells(self):
        s = br.read(mesh_file("gear_br3.off"))
        m = br.tetrahedralize(s.points, s.triangles)
        self.assertGreater(len(m.bad_cells), 0)
        angles = [bad.angle for bad in m.bad_cells]
        self.assertEqual(angles, sorted(angles))
        for bad in m.bad_cells:
            self.assertIn(bad.reason, ("forced", "gap", "needle", "not_improved"))
            self.assertTrue(set(bad.edge) <= set(m.tetrahedra[bad.tetrahedron]))
            for facet, number in zip(bad.facets, bad.triangles):
                self.assertEqual(sorted(facet), sorted(s.triangles[number]))
        self.assertAlmostEqual(angles[0], m.report["improvement"]["after"]["min_dihedral_angle"])


main()
