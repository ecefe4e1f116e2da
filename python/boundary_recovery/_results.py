"""What the functions return, and what they raise."""
import os
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

Path = Union[str, "os.PathLike[str]"]


class BadCell(NamedTuple):
    """A tetrahedron with a dihedral angle below the target, and why it has it.

    tetrahedron    its number
    angle          its smallest dihedral angle, in degrees
    edge           the numbers of the two points where that angle is
    reason         "forced": by two triangles that meet at a small angle; "gap": between two triangles that are too near
                   each other; "needle": by a triangle with a small plane angle; "not_improved": none of these
    facets         the triangles that make it so, each the numbers of three points
    triangles      their numbers in the input, -1 for what is no triangle of it
    surface_angle  the angle between two such triangles, or that a gap allows, or the smallest one of a needle; NaN: none
    distance       how wide a gap is, else NaN
    """
    tetrahedron: int
    angle: float
    edge: Tuple[int, int]
    reason: str
    facets: Sequence[Sequence[int]]
    triangles: Sequence[int]
    surface_angle: float
    distance: float


class InvalidSurface(ValueError):
    """The input cannot be meshed by anybody: it intersects itself, for instance.

    kind               what is wrong, as "intersecting_constraints", "duplicate_facet", "degenerate_facet",
                       "index_out_of_range", "coincident_vertices", "non_finite_coordinate"
    defects            (k, 2) int64, a row for each defect of that kind: the numbers of the two triangles that intersect,
                       for instance, or of the only one and -1. An edge or a point is named by the first triangle that
                       has it; where all that is wrong are points, as for "coincident_vertices", these are their numbers;
                       of a mesh that was moved, those of its tetrahedra.
    points             (k, 3) float64: a place where that is, NaN if it has none
    simplices          for each defect a list of dictionaries, with all that is known: the dimension, the number (-1: an
                       edge that was given as that of a triangle), the numbers of points, and their coordinates
    number_of_defects  larger than k if not all of them are listed, and then a lower bound
    """

    def __init__(self, kind: str, defects: np.ndarray, points: np.ndarray, simplices: Sequence[Any] = (),
                 number_of_defects: Optional[int] = None) -> None:
        self.kind, self.defects, self.points, self.simplices = kind, defects, points, simplices
        self.number_of_defects = len(defects) if number_of_defects is None else number_of_defects
        more = "at least " if self.number_of_defects > len(defects) else ""
        first = ""
        if len(defects) > 0:
            numbers = " and ".join(str(n) for n in defects[0] if n >= 0)
            first = ", the first one: %s at (%g, %g, %g)" % ((numbers or "no number",) + tuple(points[0]))
        super().__init__("invalid surface, %s: %s%d%s" % (kind, more, self.number_of_defects, first))

    def __reduce__(self) -> Any:
        return InvalidSurface, (self.kind, self.defects, self.points, self.simplices, self.number_of_defects)


class Mesh:
    """A tetrahedral mesh with the surface in it.

    points            (N, 3) float64: those of the input first, in their order, used or not; then those that were added
    tetrahedra        (T, 4) int64: numbers of points, positively oriented, as VTK and Gmsh have them: seen from the last
                      one, the first three turn counterclockwise
    regions           (T,) int32: the region of each tetrahedron, from 1
    triangles         (F, 3) int64: the surface in the mesh, each triangle of the input once
    triangle_numbers  (F,) int64: their numbers in the input
    patches           (F,) int32: as they were given, 1 if they were not
    patch_names       the names of patches, as they were given
    edges             (E, 2) int64: the edges of `edges` in the mesh
    status            "meshed"; "no_region": the surface bounds nothing; "incomplete": it could not be recovered;
                      "too_large": more points would be needed than are allowed; "stopped": by `progress`, or the time
    report            a dictionary: what the steps did, and how long they took
    bad_cells         a list of `BadCell`, the worst ones first
    missing           the edges and triangles that are missing if it is "incomplete", as `InvalidSurface.simplices`

    It is true if all is done, that is if the status is "meshed".
    """

    def __init__(self, data: Dict[str, Any], patches: Optional[np.ndarray], patch_names: Optional[Dict[int, str]],
                 status: Optional[str] = None) -> None:
        self.points: np.ndarray = data["points"]
        self.tetrahedra: np.ndarray = data["tetrahedra"]
        self.regions: np.ndarray = data["regions"]
        self.triangles: np.ndarray = data["triangles"]
        self.edges: np.ndarray = data["edges"]
        numbers = data["triangle_numbers"]
        self.triangle_numbers: np.ndarray = numbers if len(numbers) else np.arange(len(self.triangles))
        if patches is None:
            self.patches = np.ones(len(self.triangles), dtype=np.int32)
        else:
            self.patches = patches[self.triangle_numbers]
        self.patch_names: Dict[int, str] = dict(patch_names or {})
        self.status: str = status or data["status"]
        self.report: Dict[str, Any] = _report(data["report"])
        self.bad_cells: List[BadCell] = [BadCell(**bad) for bad in data["bad_cells"]]
        self.missing: List[Dict[str, Any]] = data["missing"]

    def __bool__(self) -> bool:
        return self.status in ("meshed", "recovered")

    def __repr__(self) -> str:
        return "<%s: %s, %d points, %d tetrahedra, %d triangles>" % (
            type(self).__name__, self.status, len(self.points), len(self.tetrahedra), len(self.triangles))

    def to_meshio(self) -> Any:
        """Returns a `meshio.Mesh`, with the cell data `region`, `patch` and `triangle`, and named cell sets."""
        from . import _files
        return _files.to_meshio(self)

    def to_vtk(self, surface: bool = True) -> Any:
        """Returns a `vtkUnstructuredGrid`: the tetrahedra, then, unless `surface` is false, the triangles.

        The cell data are `region` (of a triangle 0), `patch` and `triangle` (of a tetrahedron 0 and -1). For each patch
        there is an array of the field data that has its name: its number, and 2, as meshio and Gmsh have it; for each
        region its number, and 3. `pyvista.wrap()` takes the grid as it is.
        """
        from . import _files
        return _files.to_vtk(self, surface)

    def write(self, file: Path, order: int = 1) -> None:
        """Writes a file in the format that its name ends with.

        file   .msh (Gmsh 4.1) and .msh2 (Gmsh 2.2), with a physical group for each region and each patch that have
               their names; .vtu and .vtk, with the cell data `region` (of a triangle, that beside it), `patch` and
               `triangle`, and the names as `to_vtk()` has them; .mesh, with regions and patches as references, but
               without names; and by meshio what that writes: .inp, .xdmf, ...
        order  2: of second order, with a node in the middle of each edge, which is straight; not by meshio

        Points that no tetrahedron and no triangle has are left out. Triangles of patch 0, which is none, are in groups
        by the regions beside them in .msh and .msh2. But for what meshio writes, the file is there as a whole, or as it
        was before.

        Raises OSError if the file cannot be written, ValueError if the order is none, and what meshio raises.
        """
        from . import _files
        _files.write(self, os.fsdecode(file), order)


class RemeshedMesh(Mesh):
    """A mesh with new cells in its holes.

    It is a `Mesh`, whose `triangles` are the constrained ones, and has besides:

    old_points        (N,) int64: the old number of each point, -1 if it is new; the first ones stayed
    old_tetrahedra    (T,) int64: the old number of each tetrahedron, -1 if it is new; the first ones stayed
    location_cells    (K,) int64: for each new point, the old tetrahedron where it is
    location_weights  (K, 4) float64: the weights of the four points of that one
    """

    def __init__(self, data: Dict[str, Any], old_tetrahedra: np.ndarray, patches: Optional[np.ndarray],
                 patch_names: Optional[Dict[int, str]]) -> None:
        super().__init__(data, patches, patch_names)
        self.old_points: np.ndarray = data["point_numbers"]
        self.old_tetrahedra: np.ndarray = data["tetrahedron_numbers"]
        self.location_cells: np.ndarray = data["location_cells"]
        self.location_weights: np.ndarray = data["location_weights"]
        self._old = old_tetrahedra

    def transfer(self, values: Any) -> np.ndarray:
        """Returns values at the points, from values at the old ones: (n,) or (n, k). New points interpolate linearly."""
        values = np.asarray(values)
        kept = len(self.points) - len(self.location_cells)
        corners = values[self._old[self.location_cells]]
        new = np.einsum("ij,ij...->i...", self.location_weights, corners)
        return np.concatenate([values[self.old_points[:kept]], new])


def _report(report: Dict[str, Any]) -> Dict[str, Any]:
    """The compiled half writes a dictionary in a dictionary as a list of one."""
    flat = {}
    for key, value in report.items():
        if key in ("recovery", "filling", "improvement", "before", "after"):
            value = _report(value[0])
        flat[key] = value
    return flat


def refuse(data: Dict[str, Any], triangles: np.ndarray) -> None:
    """Raises what is to be raised if the input is invalid."""
    defects = data["defects"]
    if not defects:
        raise ValueError(data["message"] or "invalid input")
    kind = defects[0][0]
    defects = [simplices for name, simplices in defects if name == kind]
    are_points = all(s["dimension"] == 0 for simplices in defects for s in simplices)
    number_of: Callable[[Dict[str, Any]], int] = _Triangle_finder(triangles)
    if are_points:
        number_of = _point_number
    numbers = np.full((len(defects), 2), -1, dtype=np.int64)
    points = np.full((len(defects), 3), np.nan)
    for i, simplices in enumerate(defects):
        for j, simplex in enumerate(simplices[:2]):
            numbers[i, j] = number_of(simplex)
        points[i] = _place_of(simplices)
    raise InvalidSurface(kind, numbers, points, defects, data["number_of_defects"])


def _point_number(simplex: Dict[str, Any]) -> int:
    return simplex["vertices"][0] if simplex["vertices"] else simplex["index"]


class _Triangle_finder:
    """Finds the first triangle that has an edge or a point."""

    def __init__(self, triangles: np.ndarray) -> None:
        self._triangles = triangles
        self._first: Optional[Dict[Any, int]] = None

    def __call__(self, simplex: Dict[str, Any]) -> int:
        if simplex["dimension"] >= 2:
            return simplex["index"]  # of a tetrahedron, too, of a mesh that was moved
        if self._first is None:
            self._first = {}
            for number, (a, b, c) in enumerate(self._triangles.tolist()):
                for key in (a, b, c, frozenset((a, b)), frozenset((b, c)), frozenset((a, c))):
                    self._first.setdefault(key, number)
        vertices = simplex["vertices"]
        if not vertices:
            return -1
        return self._first.get(vertices[0] if len(vertices) == 1 else frozenset(vertices), -1)


def _place_of(simplices: Sequence[Dict[str, Any]]) -> np.ndarray:
    """Where an edge passes through a triangle, if that is what is wrong, else the middle of the smallest simplex."""
    corners = [np.reshape(s["coordinates"], (-1, 3)) for s in simplices if len(s["coordinates"]) > 0]
    if not corners:
        return np.full(3, np.nan)
    corners.sort(key=len)
    if [len(c) for c in corners] == [2, 3]:
        (a, b), (p, q, r) = corners
        normal = np.cross(q - p, r - p)
        height, other = np.dot(normal, a - p), np.dot(normal, b - p)
        if height * other < 0:
            return a + height / (height - other) * (b - a)
    return corners[0].mean(axis=0)
