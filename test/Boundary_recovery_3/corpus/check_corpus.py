#!/usr/bin/env python3
"""Runs the program recover_boundary on a folder of valid, closed surfaces and judges what it writes.

usage: check_corpus.py --program PROGRAM --verify VERIFIER [options] FOLDER
  --below N      take the surfaces of fewer than N triangles (5000)
  --skip NAMES   leave these out, names without .off, separated by commas (those that take too long here, see SLOW)
  --flips-only   no points are allowed
  --jobs N       surfaces at the same time (2)
  --limit S      seconds that one run may take (60)
  --budget S     seconds after which no further surface is begun; the rest counts as failed (240)

Each surface is run twice. What is demanded:
  - exit status 0: the verifier finds the class `strict`, every triangle of the surface is a facet of the mesh, and no
    other points are on the surface;
  - the report says `recovered`, and as many Steiner points in the domain as the verifier counts;
  - no other exit status, no crash, no time limit reached;
  - both runs write the same mesh and, the times aside, the same report.
With --flips-only, no point is added, and exit status 3 is right if the report names the missing constraints, at least one,
and only such as the surface has; the cells are positive and do not overlap; of the whole triangulation (a third run,
--keep-exterior) the verifier counts as many triangles missing.
Surfaces that are left out are named. Only Python's standard library is used.
"""
import argparse
import concurrent.futures
import json
import os
import subprocess
import sys
import tempfile
import time


# Chazelle's polyhedra, the larger ones, need hundreds of points and minutes.
SLOW = "chazelle_N20,chazelle_N40"


class Refused(Exception):
    """The program did something that is not allowed."""


def tokens_of(path):
    with open(path) as file:
        for line in file:
            yield from line.split("#")[0].split()


def read_off(path):
    """Number of vertices and triangles as vertex indices."""
    tokens = tokens_of(path)
    if next(tokens) != "OFF":
        raise ValueError("no OFF file: " + path)
    vertices, facets, _ = (int(next(tokens)) for _ in range(3))
    for _ in range(3 * vertices):
        next(tokens)
    return vertices, [[int(next(tokens)) for _ in range(int(next(tokens)))] for _ in range(facets)]


def number_of_triangles(path):
    tokens = tokens_of(path)
    next(tokens), next(tokens)
    return int(next(tokens))


def read_medit(path):
    """Points as tuples of exact integers, all scaled by the same power of two, and tetrahedra."""
    tokens = tokens_of(path)
    points, tetrahedra = [], []
    for word in tokens:
        if word == "Vertices":
            for _ in range(int(next(tokens))):
                points.append([float(next(tokens)).as_integer_ratio() for _ in range(3)])
                next(tokens)
        elif word == "Tetrahedra":
            for _ in range(int(next(tokens))):
                tetrahedra.append([int(next(tokens)) - 1 for _ in range(4)])
                next(tokens)
    scale = max((d for p in points for _, d in p), default=1)
    return [tuple(n * (scale // d) for n, d in p) for p in points], tetrahedra


def orientation(p, q, r, s):
    (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (tuple(x - y for x, y in zip(t, p)) for t in (q, r, s))
    return ax * (by * cz - bz * cy) - ay * (bx * cz - bz * cx) + az * (bx * cy - by * cx)


def check_cells_are_positive(path):
    points, tetrahedra = read_medit(path)
    if not tetrahedra:
        raise Refused("the mesh has no cells")
    bad = sum(orientation(*(points[v] for v in t)) <= 0 for t in tetrahedra)
    if bad:
        raise Refused("%d of %d cells are not positive" % (bad, len(tetrahedra)))


def verify(arguments, surface, mesh):
    run = subprocess.run([arguments.verify, surface, mesh], capture_output=True, text=True, timeout=120)
    try:
        return json.loads(run.stdout)
    except ValueError:
        raise Refused("the verifier failed with status %d" % run.returncode)


def without_times(report):
    if isinstance(report, dict):
        return {k: without_times(v) for k, v in report.items()
                if not any(word in k for word in ("second", "time", "output"))}
    if isinstance(report, list):
        return [without_times(v) for v in report]
    return report


def run_once(arguments, surface, folder, *options):
    """Exit status, bytes of the mesh, report; the mesh stays in `folder`."""
    mesh, report = os.path.join(folder, "out.mesh"), os.path.join(folder, "report.json")
    command = [arguments.program, surface, "--quiet", *options, "-o", mesh, "--report", report]
    if arguments.flips_only:
        command.append("--flips-only")
    for path in (mesh, report):
        if os.path.exists(path):
            os.remove(path)
    try:
        run = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=arguments.limit)
    except subprocess.TimeoutExpired:
        raise Refused("not finished after %g s" % arguments.limit)
    if run.returncode not in ((0, 3) if arguments.flips_only else (0,)):
        lines = run.stderr.strip().splitlines()
        raise Refused("exit status %d: %s" % (run.returncode, lines[-1] if lines else "no message"))
    if not (os.path.exists(mesh) and os.path.exists(report)):
        raise Refused("exit status %d, but the mesh or the report was not written" % run.returncode)
    try:
        with open(report) as file:
            content = json.load(file)
    except ValueError as error:
        raise Refused("the report is no JSON: %s" % error)
    with open(mesh, "rb") as file:
        return run.returncode, file.read(), content


def check_missing(report, triangles):
    """The number of facets and edges that the report names as missing."""
    if report["status"] != "incomplete":
        raise Refused("exit status 3, but the report's status is %r" % report["status"])
    facets, edges = report["missing_facets"], report["missing_edges"]
    if not facets and not edges:
        raise Refused("exit status 3, but the report names nothing that is missing")
    for facet in facets:
        if sorted(facet["vertices"]) != sorted(triangles[facet["index"]]):
            raise Refused("the report names the missing facet %s, which the surface does not have" % facet)
    present = {frozenset((t[i], t[i - 1])) for t in triangles for i in range(3)}
    for edge in edges:
        if frozenset(edge["vertices"]) not in present:
            raise Refused("the report names the missing edge %s, which the surface does not have" % edge)
    return len(facets), len(edges)


def check_incomplete(arguments, surface, folder, report, triangles, unused):
    facets, edges = check_missing(report, triangles)
    status = run_once(arguments, surface, folder, "--keep-exterior")[0]
    if status != 3:
        raise Refused("exit status 3, but %d with --keep-exterior" % status)
    mesh = os.path.join(folder, "out.mesh")
    check_cells_are_positive(mesh)
    verdict = verify(arguments, surface, mesh)
    for key in ("inverted", "flat", "face_over2", "face_sameorient", "in_missing_verts"):
        if verdict.get(key) != 0:
            raise Refused("exit status 3, and the verifier says %s = %s" % (key, verdict.get(key)))
    if verdict["steiner"] > unused:
        raise Refused("%d points were added" % (verdict["steiner"] - unused))
    if verdict["tri_absent"] != facets:
        raise Refused("%d facets are absent, the report names %d" % (verdict["tri_absent"], facets))
    return "incomplete: %d facets, %d edges missing" % (facets, edges)


def check_recovered(arguments, surface, folder, report, unused):
    verdict = verify(arguments, surface, os.path.join(folder, "out.mesh"))
    if verdict["class"] != "strict":
        raise Refused("exit status 0, but the verifier says %s: %s" % (verdict["class"], verdict.get("reason")))
    on_surface = verdict["steiner_seg"] + verdict["steiner_fac"]
    if on_surface > 0:
        raise Refused("%d points were added on the surface" % on_surface)
    if report["status"] != "recovered" or report["missing_facets"] or report["missing_edges"]:
        raise Refused("exit status 0, but the report says %r" % report["status"])
    added, reported = verdict["steiner"], report["number_of_steiner_points_in_domain"]
    if arguments.flips_only and (added > unused or reported > 0):
        raise Refused("%d points were added by flips alone" % max(added - unused, reported))
    if not added - unused <= reported <= added:
        raise Refused("%d points were added, the report says %d" % (added, reported))
    return reported


def judge(arguments, surface):
    """What the program made of one surface: words if constraints are missing, else the number of points in the domain."""
    vertices, triangles = read_off(surface)
    unused = vertices - len({v for t in triangles for v in t})
    with tempfile.TemporaryDirectory(prefix="check_corpus_") as folder:
        status, mesh, report = run_once(arguments, surface, folder)
        again = run_once(arguments, surface, folder)
        if (status, mesh) != again[:2]:
            raise Refused("the second run wrote another mesh")
        if without_times(report) != without_times(again[2]):
            raise Refused("the second run wrote another report")
        check_cells_are_positive(os.path.join(folder, "out.mesh"))
        if status == 0:
            return check_recovered(arguments, surface, folder, report, unused)
        return check_incomplete(arguments, surface, folder, report, triangles, unused)


def parser_of(text, below, budget):
    parser = argparse.ArgumentParser(description=text, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--verify", required=True)
    parser.add_argument("--below", type=int, default=below)
    parser.add_argument("--skip", default=SLOW)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--limit", type=float, default=60)
    parser.add_argument("--budget", type=float, default=budget)
    parser.add_argument("folder")
    parser.set_defaults(flips_only=False)
    return parser


def arguments_of(parser):
    arguments = parser.parse_args()
    # absolute, because the runs may be given relative names from anywhere
    arguments.program, arguments.verify = os.path.abspath(arguments.program), os.path.abspath(arguments.verify)
    return arguments


def choose_surfaces(arguments):
    surfaces = sorted(os.path.join(arguments.folder, n) for n in os.listdir(arguments.folder) if n.endswith(".off"))
    small = [s for s in surfaces if number_of_triangles(s) < arguments.below]
    names = arguments.skip.split(",")
    skipped = [s for s in small if os.path.basename(s)[:-len(".off")] in names]
    for surface in skipped:
        print("skipped  %-40s it takes long" % os.path.basename(surface), flush=True)
    print("skipped  %d of %d surfaces, which have %d triangles or more"
          % (len(surfaces) - len(small), len(surfaces), arguments.below), flush=True)
    return [s for s in small if s not in skipped]


def judge_all(arguments, surfaces, judge_one, describe):
    """Prints a line for each surface; returns what was found on those that are right."""
    begin = time.monotonic()

    def outcome(surface):
        if time.monotonic() - begin > arguments.budget:
            return False, "not run, the budget of %g s was used up" % arguments.budget
        try:
            return True, judge_one(arguments, surface)
        except Refused as refused:
            return False, str(refused)
        except Exception as error:  # a malformed report or mesh is the program's fault, too
            return False, "%s: %s" % (type(error).__name__, error)

    right = []
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for surface, (ok, found) in zip(surfaces, pool.map(outcome, surfaces)):
            if ok:
                right.append(found)
            print("%-8s %-40s %s" % ("ok" if ok else "FAILED", os.path.basename(surface),
                                     describe(found) if ok else found), flush=True)
    print("corpus: %.0f s" % (time.monotonic() - begin))
    return right


def finish(surfaces, passed):
    """Prints the line that .ci/run counts; returns the exit status."""
    print("corpus: %d passed, %d failed" % (passed, len(surfaces) - passed))
    return 0 if surfaces and passed == len(surfaces) else 1


def describe_recovery(found):
    return found if isinstance(found, str) else "recovered" + (", %d points" % found if found else "")


def main():
    parser = parser_of(__doc__, 5000, 240)
    parser.add_argument("--flips-only", action="store_true")
    arguments = arguments_of(parser)
    surfaces = choose_surfaces(arguments)
    found = judge_all(arguments, surfaces, judge, describe_recovery)
    points = [n for n in found if isinstance(n, int)]
    print("corpus: %d of %d surfaces recovered, %d of them without points, %d points in total"
          % (len(points), len(surfaces), points.count(0), sum(points)))
    return finish(surfaces, len(found))


if __name__ == "__main__":
    sys.exit(main())
