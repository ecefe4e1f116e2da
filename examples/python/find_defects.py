#!/usr/bin/env python3
"""A surface that cannot be meshed: where its defects are, and what a repair makes of it."""
import sys

try:
    import numpy as np
except ImportError:
    print("skipped: numpy (python3-numpy) is not there")
    sys.exit(77)

import boundary_recovery as br

CORNERS = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], dtype=float)
CUBE = np.array([[0, 2, 1], [1, 2, 3], [4, 5, 6], [5, 7, 6], [0, 1, 4], [1, 5, 4],
                 [2, 6, 3], [3, 6, 7], [0, 4, 2], [2, 4, 6], [1, 3, 5], [3, 7, 5]])


def main():
    # Two cubes, of which one sticks in the other: no mesh has all these triangles.
    points = np.concatenate([CORNERS, CORNERS + [0.5, 0.3, 0.2]])
    triangles = np.concatenate([CUBE, CUBE + len(CORNERS)])
    try:
        br.tetrahedralize(points, triangles)
        assert False
    except br.InvalidSurface as error:
        print(error)
        for (first, second), place in zip(error.defects[:3], error.points):
            print("  triangles %d and %d intersect at" % (first, second), place.round(3))
        assert error.kind == "intersecting_constraints"
        assert (error.defects.min(axis=1) < len(CUBE)).all() and (error.defects.max(axis=1) >= len(CUBE)).all()
        assert ((error.points >= 0) & (error.points <= 1.5)).all()

    # Each triangle with points of its own, rounded as single precision does: gaps everywhere.
    points = (CORNERS[CUBE] / 3).astype(np.float32).astype(float).reshape(-1, 3)
    points += np.random.default_rng(1).uniform(-1e-8, 1e-8, points.shape)
    triangles = np.arange(len(points)).reshape(-1, 3)
    open_mesh = None
    try:
        open_mesh = br.tetrahedralize(points, triangles)
        print("without a repair:", open_mesh.status)
    except br.InvalidSurface as error:
        print("without a repair:", error)
    assert not open_mesh
    mesh = br.tetrahedralize(points, triangles, repair=True)
    print("with a repair:", mesh, {k: v for k, v in mesh.report["repair"].items() if v})
    assert mesh and len(mesh.triangles) == len(CUBE)


main()
