#!/usr/bin/env python3
"""Runs the program mesh_surface on a folder of valid, closed surfaces and judges what it writes.

usage: check_meshes.py --program PROGRAM --verify VERIFIER [options] FOLDER
  --below N      take the surfaces of fewer than N triangles (2000)
  --skip NAMES   leave these out, names without .off, separated by commas (those that take too long here)
  --cells N      no uniform size that needs more than about N tetrahedra (60000)
  --twice N      two runs of surfaces of fewer than N triangles (300)
  --jobs N       surfaces at the same time (2)
  --limit S      seconds that one run may take (60)
  --budget S     seconds after which no further surface is begun; the rest counts as failed (480)

Each surface is meshed with the sizes that it has itself, and with the mean length of its edges everywhere, or more where
that would need too many cells. What is demanded of both meshes:
  - exit status 0: the verifier finds the class `strict`, so all cells are positive and do not overlap, every triangle of
    the surface is a facet, and nothing else bounds the mesh; no point is on the surface but its own;
  - the report says `meshed`, and as many points and cells as the verifier counts;
  - what the report says of the tetrahedra that stayed bad is true, see check_certificate.py;
  - where there are two runs, both write the same bytes.
Only Python's standard library is used.
"""
import math
import os
import sys
import tempfile

from check_certificate import Certificate_checker, Wrong, read_surface, read_tetrahedra
from check_corpus import Refused, arguments_of, choose_surfaces, finish, judge_all, parser_of, read_off, run_once
from check_corpus import tokens_of, verify


# of a mesh of tetrahedra with edges of length h: cells in the volume h^3
CELLS_PER_CUBE = 9


def read_points(path):
    tokens = tokens_of(path)
    next(tokens)
    vertices, _, _ = (int(next(tokens)) for _ in range(3))
    return [tuple(float(next(tokens)) for _ in range(3)) for _ in range(vertices)]


def six_volumes(p, q, r):
    return (p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0])
            + p[2] * (q[0] * r[1] - q[1] * r[0]))


def uniform_size(surface, cells):
    """The mean length of the edges, or more."""
    points, (_, triangles) = read_points(surface), read_off(surface)
    edges = {frozenset((t[i], t[i - 1])) for t in triangles for i in range(3)}
    mean = math.fsum(math.dist(*(points[v] for v in e)) for e in edges) / len(edges)
    # from a corner of the surface, as far away points would round too much; of the box, if triangles have both directions
    origin = points[triangles[0][0]]
    moved = [tuple(x - y for x, y in zip(p, origin)) for p in points]
    volume = abs(math.fsum(six_volumes(*(moved[v] for v in t)) for t in triangles)) / 6
    return max(mean, (CELLS_PER_CUBE * volume / cells) ** (1 / 3))


def check_certificate(report, surface, mesh):
    try:
        Certificate_checker(report, read_surface(surface), read_tetrahedra(mesh))()
    except Wrong as wrong:
        raise Refused("the certificate is wrong: %s" % wrong)


def check_mesh(arguments, surface, number_of_triangles, *options):
    """The number of cells."""
    with tempfile.TemporaryDirectory(prefix="check_meshes_") as folder:
        _, mesh, report = run_once(arguments, surface, folder, *options)
        if number_of_triangles < arguments.twice and run_once(arguments, surface, folder, *options)[1] != mesh:
            raise Refused("the second run wrote another mesh")
        verdict = verify(arguments, surface, os.path.join(folder, "out.mesh"))
        check_certificate(report, surface, os.path.join(folder, "out.mesh"))
    if verdict["class"] != "strict":
        raise Refused("the verifier says %s: %s" % (verdict["class"], verdict.get("reason")))
    if verdict["steiner_seg"] + verdict["steiner_fac"] > 0:
        raise Refused("points were added on the surface")
    if report["status"] != "meshed":
        raise Refused("exit status 0, but the report says %r" % report["status"])
    if (report["number_of_points"], report["number_of_tetrahedra"]) != (verdict["nv_file"], verdict["nt"]):
        raise Refused("the report counts other points or cells than the verifier")
    return verdict["nt"]


def judge(arguments, surface):
    """The numbers of cells of both meshes."""
    n = len(read_off(surface)[1])
    size = uniform_size(surface, arguments.cells)
    return [check_mesh(arguments, surface, n, *options) for options in ((), ("--size", repr(size)))]


def main():
    parser = parser_of(__doc__, 2000, 480)
    parser.add_argument("--cells", type=int, default=60000)
    parser.add_argument("--twice", type=int, default=300)
    arguments = arguments_of(parser)
    surfaces = choose_surfaces(arguments)
    found = judge_all(arguments, surfaces, judge, lambda cells: "meshed, %d and %d cells" % tuple(cells))
    return finish(surfaces, len(found))


if __name__ == "__main__":
    sys.exit(main())
