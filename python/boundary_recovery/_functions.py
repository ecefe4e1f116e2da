"""The functions of the module."""
import sys
from typing import Any, Callable, Dict, Optional, Sequence, Union

import numpy as np

from . import _core
from ._arrays import as_indices, as_numbers_or_none, as_points
from ._files import Surface
from ._results import InvalidSurface, Mesh, RemeshedMesh, refuse
from ._sizes import Background, Path, Size, Source, size_arguments

Progress = Optional[Callable[[str, float], Any]]


def tetrahedralize(points: Any, triangles: Any, size: Size = None, patches: Any = None,
                   patch_names: Optional[Dict[int, str]] = None, edges: Any = None, grading: float = 0.3,
                   min_angle: float = 25.0, effort: str = "normal", improve: bool = True,
                   sources: Union[Path, Sequence[Source]] = (), background: Background = None,
                   max_vertices: Optional[int] = None, time_limit: Optional[float] = None,
                   threads: Optional[int] = None, repair: Union[bool, float] = False, progress: Progress = None) -> Mesh:
    """Makes a mesh of what a surface bounds, with every triangle of the surface in it as it is.

    points       (n, 3) float64
    triangles    (m, 3) integers, from 0: closed or not, with sheets inside, non-manifold where several regions meet.
                 Arrays of float64 and of integers of 4 or 8 bytes are not copied, whatever their strides are. Do not
                 change them from another thread while the function works.
    size         the lengths that edges inside are to have:
                 None: those of the surface, which grow away from it by `grading`;
                 a number;
                 (n,) float64: sizes at the points; at a place, the smallest one of size + grading * distance;
                 a function f(P) of places P, (k, 3) float64, that returns k sizes, (k,), or a number for all of them. It
                 is called once with all the points, and then, as they are needed, with the 125 corners of a box that is
                 divided into 4 x 4 x 4. Where these are not farther from each other than the sizes there, sizes between
                 them are interpolated, else a part of the box is asked for. It is called for corners outside of the
                 surface, too, and may return NaN there; it is then asked for places beside such corners one by one.
    patches      (m,) int32: numbers of the groups that triangles are in; they come out again
    patch_names  {number: name}
    edges        (e, 2) integers: edges that have to be in the mesh besides
    grading      by how much sizes of the surface, of points and of the background may grow per length
    min_angle    tetrahedra with a smaller dihedral angle are improved, from 0 to 70.53 degrees
    effort       how much work that is worth: "low", "normal", "high"
    improve      whether tetrahedra are improved at all
    sources      `Source`s, or the name of a file with them, as the program mesh_surface reads it
    background   (points, tetrahedra, sizes at the points) of a mesh, or the name of a file with one; sizes are
                 interpolated in it. Of all sizes, the smallest one wins.
    max_vertices how many points the mesh may have; if the forecast is higher, no point is inserted ("too_large")
    time_limit   seconds after which the work stops soon ("stopped"), with a valid mesh
    threads      how many threads may work on a large mesh, which does not depend on it; default: as many as there are.
                 One does if `size` is a function, which is called by the thread that calls this.
    repair       whether a surface that intersects itself, or has gaps, is repaired first where that is possible; a
                 number is the distance below which points are the same. `points` of the result begin with those of the
                 repaired surface then, `triangle_numbers` tell of which triangles the new ones are parts, and
                 `report["repair"]` tells what was changed.
    progress     a function f(phase, share) that is called with the name of the phase, and the share of this phase that
                 is done, 20 times a second at most, and when phases begin (0) and end (1). It is not the share of the
                 whole work: that is not known, and phases take from no time to most of it. Many phases tell nothing
                 between 0 and 1. If the function returns False, the work stops soon, as by `time_limit`.

    Returns a `Mesh`. The same input gives the same mesh, bit for bit, unless time is limited.

    Raises `InvalidSurface`, a ValueError, if nobody could make a mesh with these triangles; ValueError if a size is not
    a positive number; and whatever `size` or `progress` raise, and KeyboardInterrupt, unchanged.
    """
    points = as_points(points)
    triangles = as_indices(triangles, 3, "triangles")
    patches = as_numbers_or_none(patches, np.int32, len(triangles), "patches")
    if threads is not None and not threads >= 1:
        raise ValueError("threads: a positive number is needed")
    changes = None
    if repair is not False:
        repaired = _repair(points, triangles, -1.0 if repair is True else float(repair))
        points, triangles, changes = repaired["points"], repaired["triangles"], repaired["changes"]
    options = _options(min_angle=min_angle, effort=effort, improve=bool(improve), max_vertices=max_vertices,
                       time_limit=time_limit, threads=1 if callable(size) else threads)
    sizes = size_arguments(size, len(points), grading, sources, background)
    data = _core.tetrahedralize(points, triangles, as_indices(edges, 2, "edges"), sizes, options, progress)
    if changes is not None:
        data["report"]["repair"] = changes
        data["triangle_numbers"] = repaired["triangle_numbers"][data["triangle_numbers"]]
    if data["status"] == "invalid_input":
        refuse(data, triangles)
    return Mesh(data, patches, patch_names)


def recover_boundary(points: Any, triangles: Any, mode: str = "constrained", edges: Any = None,
                     effort: str = "more_time", patches: Any = None, patch_names: Optional[Dict[int, str]] = None,
                     outside: bool = False, list_defects: bool = False, time_limit: Optional[float] = None,
                     progress: Progress = None) -> Mesh:
    """Makes a mesh that has the triangles of a surface, and no other points than are needed for that.

    mode          "constrained": points are never on the surface; "conforming": they are, and `triangles` of the result
                  are the parts; "flips_only": no point is added
    effort        what is given up, "more_time" or "more_points"
    outside       whether tetrahedra outside of the surface, up to the convex hull, come as well, as region 0: all of
                  them do if it is open
    list_defects  whether defects are searched before anything else
    For the rest, see `tetrahedralize()`.

    Returns a `Mesh` with the status "recovered"; "incomplete": what is `missing` could not be recovered; or "stopped".
    It raises what `tetrahedralize()` raises.
    """
    points = as_points(points)
    triangles = as_indices(triangles, 3, "triangles")
    patches = as_numbers_or_none(patches, np.int32, len(triangles), "patches")
    options = _options(mode=mode, recovery_effort=effort, outside=bool(outside), list_defects=bool(list_defects),
                       time_limit=time_limit, insert_field_points=False, improve=False)
    data = _core.tetrahedralize(points, triangles, as_indices(edges, 2, "edges"), {}, options, progress)
    if data["recovery_status"] == "invalid_input":
        refuse(data, triangles)
    return Mesh(data, patches, patch_names, status=data["recovery_status"])


def improve(points: Any, tetrahedra: Any, regions: Any = None, triangles: Any = None, edges: Any = None,
            patches: Any = None, patch_names: Optional[Dict[int, str]] = None, min_angle: float = 25.0,
            effort: str = "normal", time_limit: Optional[float] = None, progress: Progress = None) -> Mesh:
    """Improves the tetrahedra of a mesh until none has a dihedral angle below a target, or nothing helps.

    points      (n, 3) float64
    tetrahedra  (t, 4) integers, in any orientation; none of them flat, or over another one
    regions     (t,) integers, from 1: facets between regions stay, as those of the boundary do
    triangles   (m, 3) integers: facets of the mesh that have to stay as well; they come out again
    edges       (e, 2) integers: edges of the mesh that have to stay as well
    For the rest, see `tetrahedralize()`.

    Returns a `Mesh`: first the points that had to stay, in their order, bit for bit. Its `point_numbers`, (N,) int64,
    are the old numbers, -1 for points that are new, or that may have been moved. It raises ValueError if the arrays are
    no mesh.
    """
    points = as_points(points)
    tetrahedra = as_indices(tetrahedra, 4, "tetrahedra")
    if len(tetrahedra) == 0:
        raise ValueError("tetrahedra: there are none")
    facets = as_indices(triangles, 3, "triangles")
    patches = as_numbers_or_none(patches, np.int32, len(facets), "patches")
    options = _options(min_angle=min_angle, effort=effort, time_limit=time_limit)
    data = _core.improve(points, tetrahedra, as_numbers_or_none(regions, np.int64, len(tetrahedra), "regions"), facets,
                         as_indices(edges, 2, "edges"), options, progress)
    if data["status"] == "invalid_input":
        raise ValueError("min_angle: it has to be from 0 to 70.53 degrees")
    mesh = Mesh(data, patches, patch_names)
    mesh.point_numbers = data["point_numbers"]  # type: ignore[attr-defined]
    return mesh


def remesh_holes(points: Any, tetrahedra: Any, selected: Any = None, regions: Any = None, triangles: Any = None,
                 edges: Any = None, patches: Any = None, patch_names: Optional[Dict[int, str]] = None,
                 size: Size = None, grading: float = 0.3, sources: Union[Path, Sequence[Source]] = (),
                 background: Background = None, min_angle: Optional[float] = None, layers: int = 2,
                 improve: bool = True, time_limit: Optional[float] = None, progress: Progress = None) -> RemeshedMesh:
    """Replaces the bad cells of a mesh whose points were moved, and some cells around them; everything else stays.

    points      (n, 3) float64: where the points are now
    tetrahedra  (t, 4) integers, positively oriented where they are not inverted, as those of a `Mesh`
    selected    (t,) bool: cells that are bad whatever their shape is
    regions     (t,) integers
    triangles   (m, 3) integers: facets that have to stay, as surfaces of bodies; those between regions, and on the
                boundary, do anyway
    edges       (e, 2) integers: edges that have to stay
    size        sizes of new edges, as for `tetrahedralize()`, but None: those of the old mesh
    min_angle   cells with a smaller dihedral angle are bad; by default 10, and 0 if there is `selected`
    layers      how many layers of cells around bad ones are replaced with them
    For the rest, see `tetrahedralize()`.

    Returns a `RemeshedMesh`. If its status is not "meshed", it is the old mesh. It raises `InvalidSurface` if the arrays
    are no mesh, or surfaces that have to stay intersect.
    """
    points = as_points(points)
    tetrahedra = as_indices(tetrahedra, 4, "tetrahedra")
    facets = as_indices(triangles, 3, "triangles")
    patches = as_numbers_or_none(patches, np.int32, len(facets), "patches")
    if min_angle is None:
        min_angle = 10.0 if selected is None else 0.0
    options = _options(min_angle=min_angle, improve=bool(improve), layers=int(layers), time_limit=time_limit)
    sizes = None
    if size is not None or sources != () or background is not None:
        sizes = size_arguments(sys.float_info.max if size is None else size, len(points), grading, sources, background)
    data = _core.remesh_holes(points, tetrahedra, as_numbers_or_none(regions, np.int64, len(tetrahedra), "regions"),
                              as_numbers_or_none(selected, np.bool_, len(tetrahedra), "selected"), facets,
                              as_indices(edges, 2, "edges"), sizes, options, progress)
    if data["status"] == "invalid_input":
        refuse(data, facets)
    return RemeshedMesh(data, tetrahedra, patches, patch_names)


def repair(points: Any, triangles: Any, tolerance: Optional[float] = None, patches: Any = None,
           patch_names: Optional[Dict[int, str]] = None) -> Surface:
    """Makes a valid surface of one that has gaps or intersects itself, where that is possible.

    tolerance  the distance below which points are the same; None: four units in the last place that single precision
               has for the largest coordinate

    Returns a `Surface`, whose `changes` tell what was done. Nothing is promised: `tetrahedralize()` judges it as it judges
    any surface. Triangles that intersect are divided with CGAL 6.0 or later only.
    """
    triangles = as_indices(triangles, 3, "triangles")
    data = _repair(as_points(points), triangles, -1.0 if tolerance is None else float(tolerance))
    numbers = data["triangle_numbers"]
    patches = as_numbers_or_none(patches, np.int32, len(triangles), "patches")
    patches = np.ones(len(numbers), dtype=np.int32) if patches is None else patches[numbers]
    return Surface(data["points"], data["triangles"], patches, dict(patch_names or {}), numbers, data["point_numbers"],
                   data["changes"])


def _repair(points: np.ndarray, triangles: np.ndarray, tolerance: float) -> Dict[str, Any]:
    data = _core.repair_surface(points, triangles, tolerance)
    if data["message"]:
        raise InvalidSurface(data["message"], np.empty((0, 2), dtype=np.int64), np.empty((0, 3)))
    return data


def _options(**options: Any) -> Dict[str, Any]:
    """Those that are given, as the compiled half wants them."""
    limit = options.get("time_limit")
    if limit is not None:
        options["time_limit"] = float(limit)
    if "min_angle" in options:
        options["min_angle"] = float(options["min_angle"])
    return {name: value for name, value in options.items() if value is not None}
