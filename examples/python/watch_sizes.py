#!/usr/bin/env python3
"""Sizes from a function, and a progress bar: small tetrahedra around a curve, large ones elsewhere."""
import os
import sys

try:
    import numpy as np
except ImportError:
    print("skipped: numpy (python3-numpy) is not there")
    sys.exit(77)

import boundary_recovery as br

ANGLES = np.linspace(0, 2 * np.pi, 100)
CURVE = 0.5 + np.stack([0.25 * np.cos(ANGLES), 0.25 * np.sin(ANGLES), 0 * ANGLES], axis=1)  # a circle in the cube


def distances(places):
    return np.linalg.norm(places[:, None] - CURVE, axis=2).min(axis=1)


def sizes(places):
    """The sizes at some places, (k, 3): it is called with all points of the surface, then with 125 places each time."""
    return 0.03 + 0.4 * distances(places)


class Bar:
    """Draws a bar on a terminal, one for each phase."""

    def __init__(self):
        self.phases = []

    def __call__(self, phase, share):
        if not self.phases or self.phases[-1] != phase:
            self.phases.append(phase)
        if sys.stderr.isatty():
            print("\r%-28s [%-40s] %3d %%" % (phase, "#" * int(40 * share), 100 * share), end="", file=sys.stderr)


def main():
    data = os.environ.get("CGAL_DATA_DIR", os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../data"))
    surface = br.read(os.path.join(data, "meshes", "cube_br3.off"))
    bar = Bar()
    mesh = br.tetrahedralize(surface.points, surface.triangles, size=sizes, progress=bar)
    if sys.stderr.isatty():
        print(file=sys.stderr)
    assert mesh, mesh.status
    print(mesh)
    print("phases:", ", ".join(bar.phases))
    edges = np.concatenate([mesh.tetrahedra[:, [i, j]] for i in range(4) for j in range(i)])
    edges = np.unique(np.sort(edges, axis=1), axis=0)
    ends = mesh.points[edges[(edges >= len(surface.points)).all(axis=1)]]  # of edges without a point of the surface
    wanted, lengths = sizes(ends.mean(axis=1)), np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1)
    near = distances(ends.mean(axis=1)) < 0.05
    print("near the curve edges have %.2f of the length that is asked for, elsewhere %.2f" % (
        (lengths / wanted)[near].mean(), (lengths / wanted)[~near].mean()))
    assert 0.8 < (lengths / wanted)[near].mean() < 1.3 and "field_point_insertion" in bar.phases


main()
