#!/usr/bin/env python3
"""Measures the time of each phase and the memory, beside TetGen -pY, and the growth with the number of triangles.

Each run is a process of its own; ours and TetGen's take turns, the shortest time of --runs counts, and the largest memory.
Surfaces of the families come from refined_surface.py. README.md in this folder tells how to build the programs.
"""
import math
import os
import sys
import tempfile

import refined_surface
from benchmark_common import Programs, Records, model_of, parser_of, surfaces_of, wanted

LARGE, FEW = 50000, 0.01  # triangles, part of the edges: a surface that needs little beside the insertion
SIZES = (1000, 3000, 10000, 30000, 100000, 300000, 1000000)


def measure(programs, arguments, file):
    """the best of some runs; a long one is not run again"""
    ours, theirs = [], []
    with tempfile.TemporaryDirectory(prefix="br3_") as folder:
        surface = os.path.join(folder, "in.off")
        for i in range(arguments.runs):
            ours.append(programs.recover(file, *(["--write-surface", surface] if i == 0 else []),
                                         limit=arguments.time_limit))
            if ours[0]["outcome"] in ("unreadable", "invalid_input") or not os.path.exists(surface):
                break
            theirs.append(programs.mesh_by_tetgen(surface, "pY", ours[0]))
            if ours[-1]["wall_seconds"] + theirs[-1]["wall_seconds"] > arguments.once if programs.has_tetgen \
                    else ours[-1]["wall_seconds"] > arguments.once:
                break
    return {"ours": best(ours), "tetgen": best(theirs) if theirs else {"outcome": "skipped"}}


def best(runs):
    done = [r for r in runs if "recovery_seconds" in r]
    if not done:
        return runs[0]
    row = min(done, key=lambda r: r["recovery_seconds"])
    for key in ("insertion_seconds", "phases_seconds", "total_seconds"):
        if key in row:
            row[key] = min(r[key] for r in done)
    row["peak_memory_mb"] = max(r["peak_memory_mb"] for r in done)
    row["runs"] = len(done)
    return row


def exponent(points):
    """of the power of x that fits best, by least squares of the logarithms"""
    points = [(math.log(x), math.log(y)) for x, y in points if x > 0 and y > 0]
    if len(points) < 2:
        return float("nan")
    mx, my = (sum(p[i] for p in points) / len(points) for i in (0, 1))
    return sum((x - mx) * (y - my) for x, y in points) / sum((x - mx) ** 2 for x, _ in points)


def geometric_mean(values):
    return math.exp(sum(math.log(v) for v in values) / len(values)) if values else float("nan")


def ratios(rows):
    """recovery, insertion and recovery, memory, phases alone: ours / TetGen's, where both succeed"""
    def ratio(x, y):
        tick = 1e-6  # TetGen's clock counts microseconds
        return max(x, tick) / max(y, tick)
    for r in rows:
        o, t = r["ours"], r["tetgen"]
        if o["outcome"] == "recovered" and t["outcome"] == "ok":
            yield (r, ratio(o["recovery_seconds"], t["recovery_seconds"]),
                   ratio(o["insertion_seconds"] + o["recovery_seconds"], t["total_seconds"]),
                   o["peak_memory_mb"] / t["peak_memory_mb"], ratio(o["phases_seconds"], t["phases_seconds"]))


def names(pairs, i):
    """the models with the largest i-th ratio"""
    worst = sorted(pairs, key=lambda p: -p[i])
    return ": " * bool(worst) + ", ".join("%s %.2f" % (p[0]["model"], p[i]) for p in worst[:12]) + ", ..." * (len(worst) > 12)


def print_summary(rows):
    models = [r for r in rows if r["family"] == ""]
    done = [r for r in models if r["ours"]["outcome"] == "recovered"]
    print("\n%d of %d surfaces recovered" % (len(done), len(models)))
    pairs = list(ratios(models))
    if pairs:
        print("ours / TetGen -pY on %d surfaces: recovery %.3f, insertion and recovery %.3f, memory %.3f, "
              "recovery without what comes before its phases %.3f (geometric means)"
              % ((len(pairs),) + tuple(geometric_mean([p[i] for p in pairs]) for i in (1, 2, 3, 4))))
        long = [p for p in pairs if p[0]["tetgen"]["recovery_seconds"] >= 0.01]
        print("  where TetGen's recovery takes 0.01 s or more (%d): recovery %.3f; above 3, of all: %d%s"
              % (len(long), geometric_mean([p[1] for p in long]), sum(p[1] > 3 for p in pairs),
                 names([p for p in pairs if p[1] > 3], 1)))
        more = [p for p in pairs if p[3] > 1]
        print("  more memory than TetGen: %d%s" % (len(more), names(more, 3)))
    large = sorted(r["ours"]["recovery_seconds"] / r["ours"]["insertion_seconds"] for r in done
                   if r["ours"]["facets"] > LARGE and r["ours"]["lost_edges_at_start"] < FEW * r["ours"]["edges"])
    if large:
        print("over %d triangles, less than %g %% of the edges lost (%d): recovery / insertion: median %.2f, largest %.2f"
              % (LARGE, 100 * FEW, len(large), large[len(large) // 2], large[-1]))
    totals = {}
    for r in done:
        for phase in r["ours"]["phases"]:
            totals[phase["phase"]] = totals.get(phase["phase"], 0) + phase["seconds"]
    for phase, seconds in totals.items():
        print("  %-28s %10.3f s" % (phase, seconds))
    print_growth(rows)


def print_growth(rows):
    for family in sorted({r["family"] for r in rows} - {""}):
        some = sorted((r for r in rows if r["family"] == family and r["ours"]["outcome"] == "recovered"),
                      key=lambda r: r["ours"]["facets"])
        print("\n%s: triangles, seconds of the insertion, shell transformations, seconds of the recovery, of TetGen's, "
              "MB, TetGen's MB" % family)
        for r in some:
            o, t = r["ours"], r["tetgen"]
            print("  %8d %9.3f %9d %9.3f %9s %8.0f %8s" % (
                o["facets"], o["insertion_seconds"], o["shell_transformations"], o["recovery_seconds"],
                "%.3f" % t["recovery_seconds"] if t["outcome"] == "ok" else t["outcome"], o["peak_memory_mb"],
                "%.0f" % t["peak_memory_mb"] if t["outcome"] == "ok" else "-"))
        for key in ("insertion_seconds", "shell_transformations", "recovery_seconds", "peak_memory_mb"):
            print("  exponent of %s: %.3f" % (key, exponent([(r["ours"]["facets"], r["ours"][key]) for r in some])))


def main():
    parser = parser_of(__doc__, 300)
    parser.add_argument("--runs", type=int, default=3, help="runs of each surface, default 3")
    parser.add_argument("--once", type=float, default=5, help="what takes more seconds is not run again, default 5")
    parser.add_argument("--time-limit", type=float, default=60, help="maximum_running_time of the recovery, default 60")
    parser.add_argument("--growth", type=int, default=0, metavar="TRIANGLES",
                        help="also run the families, up to so many triangles, e.g. 1000000")
    parser.add_argument("--families", nargs="+", choices=sorted(refined_surface.FAMILIES), default=["knot", "plate"])
    parser.add_argument("--no-models", action="store_true", help="run the families only")
    arguments = parser.parse_args()
    programs = Programs(arguments)
    records = Records(arguments, "performance.jsonl", ("family", "model"))
    files = [] if arguments.no_models else wanted(arguments, surfaces_of(arguments))
    for file in files:
        if not records.has(family="", model=model_of(file)):
            records.add(dict(family="", model=model_of(file), **measure(programs, arguments, file)))
            tell(records.rows[-1])
    for size in SIZES:
        for family in arguments.families:
            name = "%s_%d" % (family, size)
            if size > arguments.growth or records.has(family=family, model=name):
                continue
            with tempfile.TemporaryDirectory(prefix="br3_") as folder:
                file = os.path.join(folder, name + ".off")
                refined_surface.write(family, size, file)
                records.add(dict(family=family, model=name, **measure(programs, arguments, file)))
            tell(records.rows[-1])
    print_summary(records.rows)
    return 1 if any(r["ours"]["outcome"] == "crash" for r in records.rows) else 0


def tell(row):
    o, t = row["ours"], row["tetgen"]
    print("%s: %s %.3f s, TetGen %s %.3f s" % (row["model"], o["outcome"], o.get("recovery_seconds", 0), t["outcome"],
                                               t.get("recovery_seconds", 0)), file=sys.stderr, flush=True)


if __name__ == "__main__":
    sys.exit(main())
