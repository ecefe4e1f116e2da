#!/usr/bin/env python3
"""improve() and remesh_holes(): meshes that come as arrays."""
from common import MeshTest, box, br, facets_of, main, mesh_file, np, volumes


def boundary(tetrahedra):
    facets, counts = facets_of(tetrahedra)
    return facets[counts == 1]


class ImprovementTest(MeshTest):
    def check_improved(self, m, points, tetrahedra):
        """The boundary stays, and so does the volume; the first points are old ones, bit for bit."""
        kept = m.point_numbers[m.point_numbers >= 0]
        self.assertTrue((m.point_numbers[:len(kept)] == kept).all())
        self.assertEqual(m.points[:len(kept)].tobytes(), points[kept].tobytes())
        self.assertEqual(set(map(tuple, np.sort(m.point_numbers[boundary(m.tetrahedra)], axis=1).tolist())),
                         set(map(tuple, boundary(tetrahedra).tolist())))
        self.assertTrue((volumes(m.points, m.tetrahedra) > 0).all())
        before, after = (np.abs(volumes(p, t)).sum() for p, t in ((points, tetrahedra), (m.points, m.tetrahedra)))
        self.assertAlmostEqual(before, after, delta=1e-9 * before)
        report = m.report
        self.assertGreaterEqual(report["after"]["min_dihedral_angle"], min(25, report["before"]["min_dihedral_angle"]))

    def test_improve(self):
        for name in ("gear_br3.off", "nested_cubes_br3.off", "two_cubes_br3.off", "washer_br3.off"):
            s = br.read(mesh_file(name))
            raw = br.recover_boundary(s.points, s.triangles)
            m = br.improve(raw.points, raw.tetrahedra, raw.regions, raw.triangles, patches=np.arange(len(raw.triangles)))
            self.assertTrue(m)
            self.check_improved(m, raw.points, raw.tetrahedra)
            self.assertEqual(sorted(set(m.regions)), sorted(set(raw.regions)))
            np.testing.assert_array_equal(m.point_numbers[m.triangles], raw.triangles)
            np.testing.assert_array_equal(m.patches, np.arange(len(raw.triangles)))

    def test_the_other_orientation(self):
        points, triangles, _ = box(n=(3, 3, 3))
        raw = br.tetrahedralize(points, triangles, size=0.2, improve=False)
        turned = raw.tetrahedra[:, [1, 0, 2, 3]]
        m = br.improve(raw.points, turned)
        self.check_improved(m, raw.points, raw.tetrahedra)
        self.assertGreater(m.report["after"]["min_dihedral_angle"], 15)

    def test_parts_that_meet_in_an_edge(self):
        """Two cubes with one common edge, and a third one at a corner."""
        points, cells = [], []
        for low in ((0, 0, 0), (1, 1, 0), (2, 2, 1)):
            p, t, _ = box(low, np.add(low, 1), (2, 2, 2))
            m = br.tetrahedralize(p, t, size=0.4, improve=False)
            cells.append(m.tetrahedra + sum(map(len, points)))
            points.append(m.points)
        points, number = np.unique(np.concatenate(points), axis=0, return_inverse=True)
        cells = number.reshape(-1)[np.concatenate(cells)]
        m = br.improve(points, cells)
        self.check_improved(m, points, cells)
        self.assertAlmostEqual(volumes(m.points, m.tetrahedra).sum(), 3.0)

    def test_what_is_no_mesh(self):
        points = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, -1], [0, 0, 2], [1, 1, 0]])
        for cells in ([[0, 1, 2, 9]], [[0, 1, 2, -1]], [[0, 1, 2, 6]], [[0, 1, 2, 3], [0, 1, 2, 5]],
                      [[0, 1, 2, 3], [0, 1, 2, 4], [0, 1, 2, 5]], np.empty((0, 4), dtype=int)):
            with self.assertRaises(ValueError):
                br.improve(points, cells)
        for options in ({"triangles": [[0, 1, 6]]}, {"edges": [[0, 6]]}, {"regions": [0]}, {"min_angle": 75}):
            with self.assertRaises(ValueError):
                br.improve(points, [[0, 1, 2, 3]], **options)

    def test_remesh_holes(self):
        points, triangles, _ = box(n=(6, 6, 6))
        m = br.tetrahedralize(points, triangles, size=0.15)
        moved = m.points.copy()
        inner = np.arange(len(points), len(moved))
        near = inner[np.linalg.norm(moved[inner] - 0.5, axis=1) < 0.25]
        moved[near] += [0.12, 0.0, 0.0]
        r = br.remesh_holes(moved, m.tetrahedra, triangles=m.triangles, patches=np.arange(len(m.triangles)))
        self.assertTrue(r)
        self.assertGreater(r.report["number_of_holes"], 0)
        self.assertTrue((volumes(r.points, r.tetrahedra) > 0).all())
        self.assertAlmostEqual(volumes(r.points, r.tetrahedra).sum(), 1.0)
        kept = r.old_points >= 0
        self.assertEqual(r.points[kept].tobytes(), moved[r.old_points[kept]].tobytes())
        np.testing.assert_array_equal(r.old_points[r.triangles], m.triangles)
        old = r.old_tetrahedra >= 0
        np.testing.assert_array_equal(r.old_points[r.tetrahedra[old]], m.tetrahedra[r.old_tetrahedra[old]])
        linear = moved @ [1.0, -2.0, 3.0]
        np.testing.assert_allclose(r.transfer(linear), r.points @ [1.0, -2.0, 3.0], atol=1e-12)
        np.testing.assert_allclose(r.transfer(moved), r.points, atol=1e-12)

    def test_remesh_selected_cells(self):
        points, triangles, _ = box(n=(4, 4, 4))
        m = br.tetrahedralize(points, triangles, size=0.25)
        selected = np.linalg.norm(m.points[m.tetrahedra].mean(axis=1) - 0.5, axis=1) < 0.2
        r = br.remesh_holes(m.points, m.tetrahedra, selected=selected, layers=1, size=0.1)
        self.assertTrue(r)
        self.assertGreater(len(r.tetrahedra), len(m.tetrahedra))
        self.assertFalse(np.isin(np.flatnonzero(selected), r.old_tetrahedra).any())
        near = br.Source((0.5, 0.5, 0.5), 0.06, grading=0.5)
        r = br.remesh_holes(m.points, m.tetrahedra, selected=selected, layers=1, sources=[near])
        self.assertGreater(len(r.tetrahedra), len(m.tetrahedra))
        same = br.remesh_holes(m.points, m.tetrahedra, min_angle=0)
        self.assertEqual((bool(same), same.tetrahedra.tobytes()), (True, m.tetrahedra.tobytes()))
        with self.assertRaises(br.InvalidSurface) as raised:
            br.remesh_holes(m.points, np.concatenate([m.tetrahedra, m.tetrahedra[:1]]))
        self.assertTrue((raised.exception.defects[:, 0] == 0).all())  # the tetrahedron that is there twice


main()
