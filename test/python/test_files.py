#!/usr/bin/env python3
"""Files in and out, and the meshes of meshio and VTK, where these are there."""
import os
import tempfile
import unittest

from common import MeshTest, box, br, main, mesh_file, np

try:
    import meshio
except ImportError:
    meshio = None
try:
    import vtkmodules
except ImportError:
    vtkmodules = None

POINTS, TRIANGLES, SIDES = box(n=(2, 2, 2))
NAMES = {1: "inlet", 2: "outlet", 3: "wall"}


def write_stl(file, points, triangles, patches, names):
    with open(file, "w") as stream:
        for patch in sorted(set(patches)):
            stream.write("solid %s\n" % names[patch])
            for t in triangles[patches == patch]:
                stream.write("facet normal 0 0 0\nouter loop\n")
                stream.writelines("vertex %.17g %.17g %.17g\n" % tuple(points[v]) for v in t)
                stream.write("endloop\nendfacet\n")
            stream.write("endsolid %s\n" % names[patch])


class FilesTest(MeshTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.patches = np.minimum(SIDES, 3)

    def file(self, name):
        return os.path.join(self.folder, name)

    def mesh(self):
        return br.tetrahedralize(POINTS, TRIANGLES, size=0.4, patches=self.patches, patch_names=NAMES)

    def test_surfaces_of_the_package(self):
        for name, points, triangles in (("cube_br3.off", 8, 12), ("washer_br3.off", None, None), ("gear_br3.off", 206, 412)):
            s = br.read(mesh_file(name))
            if points is not None:
                self.assertEqual((s.points.shape, s.triangles.shape), ((points, 3), (triangles, 3)))
            self.assertTrue((s.patches > 0).all() and s.patch_names == {})
            if name == "cube_br3.off":
                self.assertEqual(sorted(np.bincount(s.patches)), [0] + 6 * [2])
            self.assertTrue(br.tetrahedralize(s.points, s.triangles))

    def test_names_in_stl(self):
        write_stl(self.file("a.stl"), POINTS, TRIANGLES, self.patches, NAMES)
        s = br.read(self.file("a.stl"))
        self.assertEqual((len(s.points), len(s.triangles)), (len(POINTS), len(TRIANGLES)))
        self.assertEqual(s.patch_names, NAMES)
        self.assertTrue((s.points[s.triangles[s.patches == 1]][:, :, 0] == 0).all())
        self.assertTrue((s.points[s.triangles[s.patches == 2]][:, :, 0] == 1).all())

    def test_names_in_obj(self):
        with open(self.file("a.obj"), "w") as stream:
            stream.writelines("v %.17g %.17g %.17g\n" % tuple(p) for p in POINTS)
            for patch, name in NAMES.items():
                stream.write("g %s\n" % name)
                stream.writelines("f %d %d %d\n" % tuple(t + 1) for t in TRIANGLES[self.patches == patch])
        s = br.read(self.file("a.obj"))
        self.assertEqual(s.patch_names, NAMES)
        self.assertEqual([(s.patches == p).sum() for p in (1, 2, 3)], [(self.patches == p).sum() for p in (1, 2, 3)])

    def test_files_that_are_none(self):
        with self.assertRaises(FileNotFoundError):
            br.read(self.file("none.off"))
        with open(self.file("bad.off"), "w") as stream:
            stream.write("OFF\n1 2")
        with self.assertRaises(ValueError):
            br.read(self.file("bad.off"))

    def test_gmsh_without_meshio(self):
        self.mesh().write(self.file("a.msh"))
        with open(self.file("a.msh"), "rb") as stream:
            text = stream.read()
        self.assertTrue(text.startswith(b"$MeshFormat\n4.1 1 8\n"))
        for name in ('2 1 "inlet"', '2 2 "outlet"', '2 3 "wall"', '3 1 "region_1"'):
            self.assertIn(name.encode(), text)

    @unittest.skipIf(meshio is None, "meshio (python3-meshio) is not there")
    def test_meshio_reads_what_was_written(self):
        m = self.mesh()
        for extension in (".msh", ".msh2", ".vtu", ".vtk", ".mesh", ".inp"):
            name = self.file("a" + extension)
            m.write(name)
            if extension == ".msh2":
                os.rename(name, self.file("b.msh"))
                name = self.file("b.msh")
            r = meshio.read(name)
            tetrahedra = np.concatenate([c.data for c in r.cells if c.type == "tetra"])
            triangles = np.concatenate([c.data for c in r.cells if c.type == "triangle"])
            self.assertEqual((len(tetrahedra), len(triangles)), (len(m.tetrahedra), len(m.triangles)), extension)
            np.testing.assert_allclose(np.sort(r.points[tetrahedra].sum(axis=(1, 2))),
                                       np.sort(m.points[m.tetrahedra].sum(axis=(1, 2))), rtol=1e-12)
            if extension in (".msh", ".msh2"):
                self.assertEqual({k: v.tolist() for k, v in r.field_data.items()},
                                 {"inlet": [1, 2], "outlet": [2, 2], "wall": [3, 2], "region_1": [1, 3]})
                s = br.read(name)
                self.assertEqual(s.patch_names, NAMES)
                self.assertEqual(len(s.points), len(POINTS))
                self.assertEqual(sorted(s.patches), sorted(m.patches))
        r = m.to_meshio()
        self.assertEqual(set(r.cell_data), {"region", "patch", "triangle"})
        self.assertEqual(len(r.cell_sets["inlet"][1]), (m.patches == 1).sum())

    @unittest.skipIf(vtkmodules is None, "VTK (python3-vtk9) is not there")
    def test_vtk(self):
        from vtkmodules.util.numpy_support import vtk_to_numpy
        m = self.mesh()
        grid = m.to_vtk()
        self.assertEqual(grid.GetNumberOfCells(), len(m.tetrahedra) + len(m.triangles))
        self.assertEqual(grid.GetNumberOfPoints(), len(m.points))
        np.testing.assert_array_equal(vtk_to_numpy(grid.GetCellData().GetArray("patch"))[len(m.tetrahedra):], m.patches)
        self.assertEqual(vtk_to_numpy(grid.GetFieldData().GetArray("outlet")).ravel().tolist(), [2, 2])
        self.assertEqual(m.to_vtk(surface=False).GetNumberOfCells(), len(m.tetrahedra))
        ids = grid.GetCell(0).GetPointIds()
        self.assertEqual([ids.GetId(i) for i in range(4)], m.tetrahedra[0].tolist())


main()
