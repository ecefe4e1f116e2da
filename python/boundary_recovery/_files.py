"""Files, and the meshes of other modules."""
import os
from typing import TYPE_CHECKING, Any, Dict, NamedTuple, Union

import numpy as np

from . import _core
from ._arrays import as_indices, as_numbers, as_points

if TYPE_CHECKING:
    from ._results import Mesh


class Surface(NamedTuple):
    """A surface: what `read()` and `repair()` return.

    points            (n, 3) float64
    triangles         (m, 3) int64
    patches           (m,) int32, from 1; 0 is no patch
    patch_names       {number: name}
    triangle_numbers  (m,) int64: the number in the file, or before the repair, of each triangle
    point_numbers     (n,) int64: the same of each point
    changes           what a repair changed, and notes about the file
    """
    points: np.ndarray
    triangles: np.ndarray
    patches: np.ndarray
    patch_names: Dict[int, str]
    triangle_numbers: np.ndarray
    point_numbers: np.ndarray
    changes: Dict[str, Any]


def read(file: Union[str, "os.PathLike[str]"]) -> Surface:
    """Reads a surface: .off, .ply, .stl, .obj, .mesh, .poly, .smesh; and by meshio, if that is there, the triangles of
    .msh, .vtu, ...

    Equal points become one, as .stl needs it, points that no triangle has are left out, and polygons that are flat are
    divided. Patches are the solids of a textual .stl, the objects, groups and materials of .obj, an integer property of
    the faces of .ply, the physical groups of .msh, the references of .mesh, the markers of .poly and .smesh. Without
    any, they end at edges where neighboring triangles meet at an angle that differs from 180 degrees by 40 or more.

    Raises OSError if there is no such file, ValueError if it is damaged, has no triangles, or is of a format that nobody
    knows.
    """
    name = os.fspath(file)
    with open(name, "rb"):
        pass  # raises what says why it cannot be read
    extension = os.path.splitext(name)[1].lower()
    if extension not in (".off", ".ply", ".stl", ".obj", ".mesh", ".poly", ".smesh"):
        return _read_by_meshio(name)
    data = _core.read_surface(name)
    if data["message"]:
        raise ValueError(data["message"])
    return Surface(data["points"], data["triangles"], data["patches"], data["patch_names"], data["triangle_numbers"],
                   data["point_numbers"], {"notes": data["notes"]})


def _read_by_meshio(name: str) -> Surface:
    import meshio
    try:
        mesh = meshio.read(name)
    except (meshio.ReadError, SystemExit) as error:
        raise ValueError("cannot read %s: %s" % (name, error)) from error
    blocks = [i for i, block in enumerate(mesh.cells) if block.type == "triangle"]
    if not blocks:
        raise ValueError("cannot read %s: it has no triangles" % name)
    triangles = np.concatenate([mesh.cells[i].data for i in blocks]).astype(np.int64)
    patches = np.ones(len(triangles), dtype=np.int32)
    for key in ("gmsh:physical", "medit:ref", "patch"):
        if key in mesh.cell_data:
            patches = np.concatenate([mesh.cell_data[key][i] for i in blocks]).astype(np.int32)
            break
    names = {int(number): key for key, (number, dimension) in mesh.field_data.items() if dimension == 2}
    used, flat = np.unique(triangles, return_inverse=True)
    points = np.ascontiguousarray(mesh.points[used], dtype=np.float64)
    return Surface(points, flat.reshape(-1, 3), patches, names, np.arange(len(triangles)), used, {"notes": []})


def region_names(mesh: "Mesh") -> Dict[int, str]:
    return {int(r): "region_%d" % r if r > 0 else "outside" for r in np.unique(mesh.regions)}


def names_of_patches(mesh: "Mesh") -> Dict[int, str]:
    return {int(p): mesh.patch_names.get(int(p), "patch_%d" % p) for p in np.unique(mesh.patches)}


def _field_data(mesh: "Mesh") -> Dict[str, np.ndarray]:
    """The names, as meshio has them: with the number of the region or patch, and the dimension."""
    data = {name: np.array([number, 3]) for number, name in region_names(mesh).items()}
    data.update({name: np.array([number, 2]) for number, name in names_of_patches(mesh).items()})
    return data


def to_meshio(mesh: "Mesh") -> Any:
    import meshio
    cells = [("tetra", mesh.tetrahedra), ("triangle", mesh.triangles)]
    none = np.zeros(len(mesh.tetrahedra), dtype=np.int32)
    data = {"region": [mesh.regions, np.zeros(len(mesh.triangles), dtype=np.int32)], "patch": [none, mesh.patches],
            "triangle": [none.astype(np.int64) - 1, mesh.triangle_numbers]}
    sets = {name: [np.flatnonzero(mesh.regions == number), np.empty(0, dtype=np.int64)]
            for number, name in region_names(mesh).items()}
    sets.update({name: [np.empty(0, dtype=np.int64), np.flatnonzero(mesh.patches == number)]
                 for number, name in names_of_patches(mesh).items()})
    return meshio.Mesh(mesh.points, cells, cell_data=data, cell_sets=sets)


def to_vtk(mesh: "Mesh", surface: bool) -> Any:
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkUnstructuredGrid
    triangles = mesh.triangles if surface else mesh.triangles[:0]
    number_of_tetrahedra, number_of_triangles = len(mesh.tetrahedra), len(triangles)
    grid = vtkUnstructuredGrid()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(mesh.points, deep=True))
    grid.SetPoints(points)
    connectivity = np.concatenate([mesh.tetrahedra.ravel(), triangles.ravel()])
    offsets = np.concatenate([[0], np.repeat([4, 3], [number_of_tetrahedra, number_of_triangles])]).cumsum()
    types = np.repeat(np.array([10, 5], dtype=np.uint8), [number_of_tetrahedra, number_of_triangles])
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(offsets.astype(np.int64), deep=True),
                  numpy_to_vtkIdTypeArray(connectivity, deep=True))
    grid.SetCells(numpy_to_vtk(types, deep=True), cells)

    def add(name: str, of_tetrahedra: np.ndarray, of_triangles: np.ndarray) -> None:
        array = numpy_to_vtk(np.concatenate([of_tetrahedra, of_triangles[:number_of_triangles]]), deep=True)
        array.SetName(name)
        grid.GetCellData().AddArray(array)

    none = np.zeros(number_of_tetrahedra, dtype=np.int32)
    add("region", mesh.regions, np.zeros(number_of_triangles, dtype=np.int32))
    add("patch", none, mesh.patches)
    add("triangle", none.astype(np.int64) - 1, mesh.triangle_numbers)
    for label, pair in _field_data(mesh).items():
        array = numpy_to_vtk(pair, deep=True)
        array.SetName(label)
        grid.GetFieldData().AddArray(array)
    return grid


def write(mesh: "Mesh", name: str, order: int) -> None:
    extension = os.path.splitext(name)[1].lower()
    if order not in (1, 2):
        raise ValueError("order: 1 or 2 is needed, not %r" % (order,))
    if _core.writes_mesh_files(extension):
        _core.write_mesh(os.fsencode(name), _used_mesh(mesh), order)
    elif order == 2:
        raise ValueError("order: files %s are written with 1 only" % (extension or "without an extension"))
    else:
        result = to_meshio(mesh)
        result.cell_sets = {}  # which meshio would write as arrays of its own, or refuse
        result.write(name)


def _used_mesh(mesh: "Mesh") -> Dict[str, Any]:
    """What is written: without points that nothing has, of which solvers would make equations without a solution."""
    points = as_points(mesh.points)
    tetrahedra = as_indices(mesh.tetrahedra, 4, "tetrahedra")
    triangles = as_indices(mesh.triangles, 3, "triangles")
    is_used = np.zeros(len(points), dtype=bool)
    is_used[tetrahedra] = True
    is_used[triangles] = True
    numbers = is_used.cumsum() - 1
    return {"points": points[is_used], "tetrahedra": numbers[tetrahedra], "triangles": numbers[triangles],
            "regions": as_numbers(mesh.regions, np.int32, len(tetrahedra), "regions"),
            "patches": as_numbers(mesh.patches, np.int32, len(triangles), "patches"),
            "triangle_numbers": as_numbers(mesh.triangle_numbers, np.int64, len(triangles), "triangle_numbers"),
            "patch_names": _names_of_one_line(names_of_patches(mesh)), "region_names": region_names(mesh)}


def _names_of_one_line(names: Dict[int, str]) -> Dict[int, str]:
    return {number: "".join(c if c.isprintable() else " " for c in name) for number, name in names.items()}
