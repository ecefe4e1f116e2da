#!/usr/bin/env python3
"""Measures mesh_surface beside TetGen and Gmsh: the time of each phase, memory, sizes and angles, with one size.

The size is the mean length of the surface's edges, or more where that would need more cells than --cells. TetGen gets
-pYq1.414 with the volume 0.14 size^3, Gmsh a size that is the same everywhere, with both of its algorithms, Delaunay
and HXT, and its optimization. --growth meshes one shape with smaller and smaller sizes. --aircraft meshes one surface
around grid sources, as in Table 4 of the article. Each run is a process of its own; the shortest time of --runs counts,
and the largest memory. README.md in this folder tells how to build the programs.
"""
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time

from benchmark_common import PROGRAMS, Programs, Records, model_of, parser_of, surfaces_of, wanted
from performance import exponent, geometric_mean

BUILD = os.path.dirname(os.path.dirname(PROGRAMS))
MESHER = os.path.join(BUILD, "program", "mesh_surface")
CELLS_PER_CUBE = 9  # of tetrahedra with edges of length h: cells in the volume h^3, about
VOLUME_PER_CUBE = 0.14  # TetGen's limit of volumes that gives edges of such lengths
ALGORITHMS_OF_GMSH = {"Gmsh Delaunay": 1, "Gmsh HXT": 10}  # Mesh.Algorithm3D
LARGEST_OF_TETGEN = 1.5e6  # cells; more are ours only in --growth


def run_measured(command, timeout):
    """exit status (None: stopped at the timeout), output, peak memory in bytes, or NaN where the system does not tell.
    The system's account of ended children would count this process, too, so the running one is looked at."""
    memory = 0
    with tempfile.TemporaryFile() as out:
        begin = time.monotonic()
        child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.STDOUT)
        while child.poll() is None:
            memory = max(memory, peak_memory_of(child.pid, command[0]))
            if time.monotonic() - begin > timeout:
                child.kill()
                child.wait()
                break
            time.sleep(0.002)
        stopped = time.monotonic() - begin > timeout
        out.seek(0)
        return None if stopped else child.returncode, out.read().decode("utf-8", "replace"), memory or float("nan")


def peak_memory_of(process, program):
    try:
        with open("/proc/%d/status" % process) as status:
            text = status.read()
    except OSError:
        return 0
    name, memory = re.search(r"^Name:\s+(\S+)", text, re.M), re.search(r"^VmHWM:\s+(\d+)", text, re.M)
    is_begun = name and os.path.basename(program).startswith(name.group(1))
    return 1024 * int(memory.group(1)) if is_begun and memory else 0


def outcome_of(status):
    if status is not None and status < 0:
        return "crash"
    return {None: "timeout", 0: "ok"}.get(status, "status %d" % (status or 0))


def number_after(pattern, text):
    found = re.findall(pattern, text)
    return float(found[-1]) if found else float("nan")


def mesh_by_us(arguments, surface, options):
    """Times and memory are those of runs that measure no quality."""
    rows = []
    for _ in range(arguments.runs):
        status, output, memory = run_measured([arguments.mesher, surface, "--quiet", "--timing"] + options,
                                              arguments.timeout)
        if status != 0:  # 2: the surface is refused
            return {"outcome": "invalid_input" if status == 2 else outcome_of(status),
                    "note": (output.strip().splitlines() or [""])[-1]}
        rows.append(dict({name: number_after("@@%s (.+)" % word, output) for name, word in
                          (("recovery", "rec"), ("filling", "fill"), ("improvement", "improve"), ("total", "tmesh"))},
                         memory=memory))
    row = best(rows)
    report = report_of(arguments, surface, options)
    edges = report["number_of_edges_inside"]
    row.update(outcome="ok", cells=report["number_of_tetrahedra"], points=report["number_of_points"],
               field_points=report["number_of_field_points"],
               share=report["number_of_edges_in_size"] / edges if edges else 1,
               longest=report["max_length_by_size"], smallest_angle=report["min_dihedral_angle"],
               largest_angle=report["max_dihedral_angle"],
               below=[report["tetrahedra_with_angle_below"][angle] for angle in ("5", "10", "15", "20")])
    return row


def report_of(arguments, surface, options):
    with tempfile.TemporaryDirectory(prefix="br3_") as folder:
        report = os.path.join(folder, "report.json")
        run_measured([arguments.mesher, surface, "--quiet", "--report", report] + options, arguments.timeout)
        with open(report, encoding="utf-8") as file:
            return json.load(file)


def best(rows):
    row = {name: min(r[name] for r in rows) for name in rows[0]}
    row["memory"] = max(r["memory"] for r in rows)
    return row


def mesh_by_tetgen(arguments, programs, surface, size):
    rows = []
    switches = "pYq1.414a%.17g" % (VOLUME_PER_CUBE * size ** 3)
    for _ in range(arguments.runs):
        found = programs.mesh_by_tetgen(surface, switches, {}, repr(size))
        if found["outcome"] not in ("ok", "split"):
            return {"outcome": found["outcome"], "note": found.get("note", "")}
        rows.append({"recovery": found["phases_seconds"], "filling": found["steps"].get("Refinement", float("nan")),
                     "improvement": found["steps"].get("Optimization", float("nan")),
                     "total": found["steps"].get("Total running", found["seconds"]),
                     "memory": found["peak_memory_mb"] * 2 ** 20})
    # a mesh that lacks triangles of the surface is told, not hidden
    return dict(best(rows), outcome=found["outcome"], cells=found["tetrahedra"], points=found["vertices"],
                share=found["share_in_size"], **angles_in(found))


def angles_in(found):
    return {"smallest_angle": found["smallest_angle"], "largest_angle": found["largest_angle"],
            "below": found["cells_below_5_10_15_20"]}


def mesh_by_gmsh(arguments, programs, surface, size, algorithm):
    """HXT's time has its optimization in it, that of the other algorithm has not."""
    if arguments.no_gmsh:
        return {"outcome": "skipped"}
    rows = []
    with tempfile.TemporaryDirectory(prefix="br3_") as folder:
        mesh = os.path.join(folder, "out.mesh")
        write_for_gmsh(surface, size, ALGORITHMS_OF_GMSH[algorithm], folder)
        for _ in range(arguments.runs):
            status, output, memory = run_measured(["gmsh", os.path.join(folder, "in.geo"), "-3", "-nt", "1", "-v", "5",
                                                   "-o", mesh], arguments.timeout)
            if status != 0:
                return {"outcome": outcome_of(status)}
            apart = number_or_0(r"Done optimizing mesh \(Wall ([0-9.eE+-]+)s", output)
            rows.append({"improvement": apart + number_or_0(r"tOptimize\s+=\s+([0-9.eE+-]+)", output),
                         "total": apart + number_after(r"Done meshing 3D \(Wall ([0-9.eE+-]+)s", output),
                         "memory": memory})
        status, output = run_measured([programs.angles, mesh], arguments.timeout)[:2]
    if status != 0:
        return {"outcome": "no cells"}
    found = json.loads(output)
    return dict(best(rows), outcome="ok", points=found["vertices"], cells=found["tetrahedra"], **angles_in(found))


def number_or_0(pattern, text):
    return 0 if re.search(pattern, text) is None else number_after(pattern, text)


def write_for_gmsh(surface, size, algorithm, folder):
    points, triangles = read_off(surface)
    with open(os.path.join(folder, "in.msh"), "w", encoding="utf-8") as file:
        file.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n%d\n" % len(points))
        file.writelines("%d %r %r %r\n" % (i + 1, *p) for i, p in enumerate(points))
        file.write("$EndNodes\n$Elements\n%d\n" % len(triangles))
        file.writelines("%d 2 2 1 1 %d %d %d\n" % (i + 1, *(v + 1 for v in t)) for i, t in enumerate(triangles))
        file.write("$EndElements\n")
    with open(os.path.join(folder, "in.geo"), "w", encoding="utf-8") as file:
        file.write('Merge "in.msh";\nSurface Loop(1) = {1};\nVolume(1) = {1};\nPhysical Volume(1) = {1};\n'
                   "Mesh.Algorithm3D = %d;\nMesh.MeshSizeExtendFromBoundary = 0;\nMesh.MeshSizeFromPoints = 0;\n"
                   "Mesh.Optimize = 1;\nMesh.MeshSizeMin = %r;\nMesh.MeshSizeMax = %r;\n" % (algorithm, size, size))


def read_off(surface):
    """of the form that benchmark_recovery writes"""
    with open(surface, encoding="utf-8") as file:
        words = file.read().split()
    n, m = int(words[1]), int(words[2])
    x, v = [float(w) for w in words[4:4 + 3 * n]], [int(w) for w in words[4 + 3 * n:]]
    return ([tuple(x[3 * i:3 * i + 3]) for i in range(n)], [tuple(v[4 * i + 1:4 * i + 4]) for i in range(m)])


def six_volumes(p, q, r):
    return (p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0])
            + p[2] * (q[0] * r[1] - q[1] * r[0]))


def measures_of(surface):
    """mean length of the edges, and the volume inside, as far as triangles are oriented"""
    points, triangles = read_off(surface)
    edges = {(min(t[i], t[i - 1]), max(t[i], t[i - 1])) for t in triangles for i in range(3)}
    moved = [tuple(x - y for x, y in zip(p, points[0])) for p in points]
    return (math.fsum(math.dist(points[u], points[v]) for u, v in edges) / len(edges),
            abs(math.fsum(six_volumes(*(moved[v] for v in t)) for t in triangles)) / 6)


def size_for(volume, cells):
    return (CELLS_PER_CUBE * volume / cells) ** (1 / 3)


class Surface_files:
    """the surface as every program reads it"""

    def __init__(self, programs, file):
        self.folder = tempfile.TemporaryDirectory(prefix="br3_")
        self.path = os.path.join(self.folder.name, "in.off")
        programs.recover(file, "--write-surface", self.path)
        if not os.path.exists(self.path):
            sys.exit(file + ": no surface that can be read")

    def __enter__(self):
        return self.path

    def __exit__(self, *_):
        self.folder.cleanup()


def measure_all(arguments, programs, records, kind, model, surface, size, others):
    for program in ["ours", "TetGen", *ALGORITHMS_OF_GMSH][:None if others == "all" else 2 if others else 1]:
        key = dict(kind=kind, model=model, program=program, size=size)
        if records.has(**key):
            continue
        if program == "ours":
            row = mesh_by_us(arguments, surface, ["--size", repr(size)])
        elif program == "TetGen":
            row = mesh_by_tetgen(arguments, programs, surface, size)
        else:
            row = mesh_by_gmsh(arguments, programs, surface, size, program)
        records.add(dict(key, **row))
        print("%s, size %.4g, %s: %s" % (model, size, program, row["outcome"]), file=sys.stderr, flush=True)
        if row["outcome"] == "invalid_input":
            break


def measure_surfaces(arguments, programs, records):
    for file in wanted(arguments, surfaces_of(arguments)):
        with Surface_files(programs, file) as surface:
            mean, volume = measures_of(surface)
            size = max(mean, size_for(volume, arguments.cells))
            measure_all(arguments, programs, records, "surface", model_of(file), surface, size, "all")


def measure_growth(arguments, programs, records):
    file = surfaces_of(arguments)[0] if arguments.places else arguments.shape
    with Surface_files(programs, file) as surface:
        volume = measures_of(surface)[1]
        for step in range(int(2 * math.log10(arguments.growth / 1e4) + 1e-9) + 1):
            cells = 1e4 * 10 ** (step / 2)
            measure_all(arguments, programs, records, "growth", model_of(file), surface, size_for(volume, cells),
                        cells <= LARGEST_OF_TETGEN)


def aircraft_sources(surface, scale):
    """Around nose and tail, along the fuselage, and at the wing tips; `scale` 1: a hundredth of the length."""
    points = read_off(surface)[0]
    low, high = ([f(p[i] for p in points) for i in range(3)] for f in (min, max))
    long, wide = sorted(range(3), key=lambda i: low[i] - high[i])[:2]
    length = high[long] - low[long]

    def place(along, across):
        p = [(low[i] + high[i]) / 2 for i in range(3)]
        p[long], p[wide] = low[long] + along * length, low[wide] + across * (high[wide] - low[wide])
        return "%r %r %r" % tuple(p)

    size, radius = scale * length / 100, length / 50
    lines = ["segment %s %s %r %r 0.05" % (place(0.1, 0.5), place(0.9, 0.5), size, radius)]
    lines += ["point %s %r %r 0.05" % (place(*p), size / 2, radius) for p in ((0, 0.5), (1, 0.5), (0.5, 0), (0.5, 1))]
    return "\n".join(lines) + "\n"


def measure_aircraft(arguments, programs, records):
    """The scale is chosen by forecasts, of meshes that are refused because of their size."""
    key = dict(kind="aircraft", model=model_of(arguments.aircraft), program="ours", size=arguments.aircraft_cells)
    if records.has(**key):
        return
    with Surface_files(programs, arguments.aircraft) as surface, tempfile.TemporaryDirectory(prefix="br3_") as folder:
        sources = os.path.join(folder, "sources")
        scale = 1.0
        for _ in range(8):
            with open(sources, "w", encoding="utf-8") as file:
                file.write(aircraft_sources(surface, scale))
            forecast = report_of(arguments, surface, ["--sources", sources, "--max-vertices", "1"])[
                "forecast_of_tetrahedra"]
            print("sources of scale %.3f: %.0f cells are forecast" % (scale, forecast), file=sys.stderr)
            if abs(math.log(forecast / arguments.aircraft_cells)) < 0.05:
                break
            scale *= min(4, max(0.25, forecast / arguments.aircraft_cells)) ** (1 / 2.5)
        row = mesh_by_us(arguments, surface, ["--sources", sources])
        records.add(dict(key, scale=scale, **row))


HEAD = "%-28s %-13s %9s %9s %9s %9s %11s %9s %10s %10s %7s %8s  %s" % (
    "surface", "program", "points", "cells", "recovery", "filling", "improvement", "total", "points/s", "cells/s",
    "B/cell", "in size", "angles; cells below 5, 10, 15, 20")


def line_of(r):
    def text(key, form):
        value = r.get(key)
        return "-" if value is None or value != value else form % value

    begin = "%-28.28s %-13s " % (r["model"], r["program"])
    if "cells" not in r:
        return begin + r["outcome"]
    seconds = r.get("filling", float("nan"))
    rates = ["%.0f" % (r[k] / seconds) if seconds > 0 else "-" for k in ("points", "cells")]
    return begin + "%9d %9d %9s %9s %11s %9s %10s %10s %7.0f %8s  %s; %s%s" % (
        r["points"], r["cells"], text("recovery", "%.3f"), text("filling", "%.3f"), text("improvement", "%.3f"),
        text("total", "%.3f"), *rates, r["memory"] / r["cells"], text("share", "%.3f"),
        text("smallest_angle", "%.2f") + " to " + text("largest_angle", "%.1f"), " ".join(map(str, r["below"])),
        "" if r["outcome"] == "ok" else "  " + r["outcome"])


def print_ratios(rows):
    ours = {(r["model"], r["size"]): r for r in rows if r["program"] == "ours" and r["outcome"] == "ok"}
    for peer in ("TetGen", *ALGORITHMS_OF_GMSH):
        pairs = [(ours[r["model"], r["size"]], r) for r in rows if r["program"] == peer and r["outcome"] == "ok"
                 and (r["model"], r["size"]) in ours]
        for key in ("filling", "improvement", "total", "memory"):
            some = [(x[key] / x["cells"]) / (y[key] / y["cells"]) for x, y in pairs
                    if x.get(key, 0) > 0 and y.get(key, 0) > 0]
            if some:
                print("ours / %s on %d surfaces, %s per cell: %.3f (geometric mean)" % (peer, len(some), key,
                                                                                       geometric_mean(some)))


def print_summary(rows):
    print("seconds; points and cells per second of the filling; peak memory; share of the edges inside from 0.71 to 1.41 "
          "times the size; smallest and largest dihedral angle in degrees, and the numbers of cells with one below 5, 10, "
          "15 and 20")
    for kind in ("surface", "growth", "aircraft"):
        some = [r for r in rows if r["kind"] == kind]
        if not some:
            continue
        print("\n%s\n%s" % (kind, HEAD))
        for r in some:
            print(line_of(r))
        if kind == "surface":
            print_ratios(some)
        for program in ("ours", "TetGen") if kind == "growth" else ():
            for key in ("filling", "improvement", "total", "memory"):
                points = [(r["cells"], r[key]) for r in some if r["program"] == program and "cells" in r and key in r]
                print("exponent of %s, %s: %.3f" % (key, program, exponent(points)))


def main():
    parser = parser_of(__doc__, 600)
    parser.add_argument("--runs", type=int, default=2, help="runs of each program, default 2")
    parser.add_argument("--cells", type=float, default=800000, help="no size that needs more, about, default 800000")
    parser.add_argument("--mesher", default=MESHER, metavar="PROGRAM", help="mesh_surface")
    parser.add_argument("--no-gmsh", action="store_true", help="leave Gmsh out")
    parser.add_argument("--no-models", action="store_true", help="only what --growth and --aircraft ask for")
    parser.add_argument("--growth", type=float, default=0, metavar="CELLS",
                        help="mesh the first surface with 10^4 cells, 10^4.5 ..., up to about so many, e.g. 1e7")
    parser.add_argument("--aircraft", default=None, metavar="FILE", help="a surface that is meshed around grid sources")
    parser.add_argument("--aircraft-cells", type=float, default=4e6, help="about so many, default 4e6")
    arguments = parser.parse_args()
    arguments.shape = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "data", "meshes", "wing_br3.off")
    if not os.access(arguments.mesher, os.X_OK):
        sys.exit("there is no %s; build the target mesh_surface" % arguments.mesher)
    programs = Programs(arguments)
    if shutil.which("gmsh") is None:
        arguments.no_gmsh = True
    if not arguments.no_gmsh and not os.access(programs.angles, os.X_OK):
        sys.exit("there is no %s; build the target benchmark_angles, or give --no-gmsh" % programs.angles)
    records = Records(arguments, "meshing.jsonl", ("kind", "model", "program", "size"))
    if not arguments.no_models:
        measure_surfaces(arguments, programs, records)
    if arguments.growth:
        measure_growth(arguments, programs, records)
    if arguments.aircraft:
        measure_aircraft(arguments, programs, records)
    print_summary(records.rows)
    return 1 if any(r["program"] == "ours" and r["outcome"] not in ("ok", "invalid_input") for r in records.rows) else 0


if __name__ == "__main__":
    sys.exit(main())
