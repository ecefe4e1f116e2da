"""Tetrahedral meshes that keep every triangle of a surface as it is.

    import boundary_recovery as br
    surface = br.read("part.stl")
    mesh = br.tetrahedralize(surface.points, surface.triangles, size=2.0)
    mesh.write("part.vtu")

Lengths are in the unit of the coordinates, angles in degrees, numbers of points, triangles and tetrahedra count from 0,
regions from 1. While the work is going on, other threads of Python run; Ctrl-C ends it, in the main thread.
"""
from ._core import version as __version__
from ._files import Surface, read
from ._functions import improve, recover_boundary, remesh_holes, repair, tetrahedralize
from ._results import BadCell, InvalidSurface, Mesh, RemeshedMesh
from ._sizes import Source

for _class in (BadCell, InvalidSurface, Mesh, RemeshedMesh, Source, Surface):
    _class.__module__ = __name__  # where users find it

__all__ = ["BadCell", "InvalidSurface", "Mesh", "RemeshedMesh", "Source", "Surface", "improve", "read",
           "recover_boundary", "remesh_holes", "repair", "tetrahedralize"]
