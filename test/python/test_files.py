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
        self.assertTrue(text.startswith(b"$MeshFormat\n4.1 0 8\n"))
        for name in ('2 1 "inlet"', '2 2 "outlet"', '2 3 "wall"', '3 1 "region_1"'):
            self.assertIn(name.encode(), text)

    def test_files_that_cannot_be_written(self):
        m = self.mesh()
        with self.assertRaises(FileNotFoundError) as caught:
            m.write(self.file("none/a.vtu"))
        self.assertTrue(caught.exception.filename.endswith("a.vtu"))
        with self.assertRaises(IsADirectoryError):
            os.mkdir(self.file("b.msh"))
            m.write(self.file("b.msh"))
        if os.path.exists("/dev/full"):
            os.symlink("/dev/full", self.file("full.mesh"))
            with self.assertRaises(OSError):
                m.write(self.file("full.mesh"))
        for order in (0, 3, "2"):
            with self.assertRaises(ValueError):
                m.write(self.file("a.msh"), order=order)
        with self.assertRaises(ValueError):
            m.write(self.file("a.inp"), order=2)
        m.tetrahedra = m.tetrahedra + len(m.points)
        with self.assertRaises(IndexError):
            m.write(self.file("a.msh"))
        self.assertLessEqual(set(os.listdir(self.folder)), {"b.msh", "full.mesh"})

    @unittest.skipIf(meshio is None, "meshio (python3-meshio) is not there")
    def test_second_order(self):
        m = self.mesh()
        edges = np.sort(np.concatenate([m.tetrahedra[:, [i, j]] for i in range(4) for j in range(i)]), axis=1)
        number_of_edges = len(np.unique(edges, axis=0))
        for extension in (".msh", ".msh2", ".vtu", ".vtk"):
            m.write(self.file("a" + extension), order=2)
            r = meshio.read(self.file("a" + extension), file_format="gmsh" if extension == ".msh2" else None)
            self.assertEqual(len(r.points), len(m.points) + number_of_edges, extension)
            tetrahedra = np.concatenate([c.data for c in r.cells if c.type == "tetra10"])
            triangles = np.concatenate([c.data for c in r.cells if c.type == "triangle6"])
            np.testing.assert_array_equal(tetrahedra[:, :4], m.tetrahedra)
            self.assertEqual(len(triangles), len(m.triangles))
            for cells, pairs in ((triangles, ((0, 1), (1, 2), (2, 0))),
                                 (tetrahedra, ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)))):
                for k, (i, j) in enumerate(pairs, cells.shape[1] - len(pairs)):
                    middle = (r.points[cells[:, i]] + r.points[cells[:, j]]) / 2
                    np.testing.assert_array_equal(r.points[cells[:, k]], middle)
        m.write(self.file("a.mesh"), order=2)
        with open(self.file("a.mesh")) as stream:
            self.assertIn("TetrahedraP2\n%d\n" % len(m.tetrahedra), stream.read())

    @unittest.skipIf(meshio is None, "meshio (python3-meshio) is not there")
    def test_points_and_groups_that_are_none(self):
        points = np.concatenate([[[5.0, 5, 5]], POINTS])
        m = br.tetrahedralize(points, TRIANGLES + 1, size=0.4, patches=np.where(SIDES == 1, 0, SIDES),
                              patch_names={2: 'two\n"lines"'})
        for extension in (".msh", ".msh2", ".vtu", ".vtk", ".mesh"):
            m.write(self.file("a" + extension))
            r = meshio.read(self.file("a" + extension), file_format="gmsh" if extension == ".msh2" else None)
            np.testing.assert_array_equal(r.points, m.points[1:])
            tetrahedra = np.concatenate([c.data for c in r.cells if c.type == "tetra"])
            np.testing.assert_array_equal(tetrahedra + 1, m.tetrahedra)
            if extension.startswith(".msh"):
                self.assertEqual(r.field_data["two 'lines'"].tolist(), [2, 2])
                self.assertIn("boundary_of_region_1", r.field_data)
        outside = br.recover_boundary(POINTS, TRIANGLES[1:], outside=True)
        self.assertTrue((outside.regions == 0).all() and len(outside.tetrahedra) > 0)
        outside.write(self.file("b.msh"))
        self.assertEqual(meshio.read(self.file("b.msh")).field_data["outside"].tolist(), [1, 3])

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
            blocks = {kind: [i for i, c in enumerate(r.cells) if c.type == kind] for kind in ("tetra", "triangle")}
            tetrahedra, triangles = (np.concatenate([r.cells[i].data for i in blocks[kind]]) for kind in blocks)
            self.assertEqual((len(tetrahedra), len(triangles)), (len(m.tetrahedra), len(m.triangles)), extension)
            if extension == ".inp":
                np.testing.assert_allclose(r.points, m.points, rtol=1e-12)
                continue
            np.testing.assert_array_equal(r.points, m.points)
            np.testing.assert_array_equal(tetrahedra, m.tetrahedra)
            keys = {".msh": ("region", "gmsh:physical"), ".msh2": ("gmsh:physical",) * 2,
                    ".mesh": ("medit:ref",) * 2}.get(extension, ("region", "patch"))
            regions = np.concatenate([r.cell_data[keys[0]][i] for i in blocks["tetra"]]).ravel()
            patches = np.concatenate([r.cell_data[keys[1]][i] for i in blocks["triangle"]]).ravel()
            np.testing.assert_array_equal(regions, m.regions)
            if "triangle" in r.cell_data:
                numbers = np.concatenate([r.cell_data["triangle"][i] for i in blocks["triangle"]]).ravel().astype(int)
                np.testing.assert_array_equal(TRIANGLES[numbers], triangles)
                np.testing.assert_array_equal(self.patches[numbers], patches)
            else:
                self.assertNotIn(extension, (".msh", ".vtu", ".vtk"))
                self.assertEqual(sorted(patches), sorted(m.patches))
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
        from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
        for extension, reader in ((".vtu", vtkXMLUnstructuredGridReader()), (".vtk", vtkUnstructuredGridReader())):
            m.write(self.file("a" + extension))
            reader.SetFileName(self.file("a" + extension))
            reader.Update()
            names = reader.GetOutput().GetFieldData()
            self.assertEqual({names.GetArrayName(i): vtk_to_numpy(names.GetArray(i)).ravel().tolist()
                              for i in range(names.GetNumberOfArrays())},
                             {"inlet": [1, 2], "outlet": [2, 2], "wall": [3, 2], "region_1": [1, 3]})


main()
