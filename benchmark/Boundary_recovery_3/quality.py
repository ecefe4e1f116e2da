#!/usr/bin/env python3
"""Counts Steiner points by kind and measures dihedral angles, beside TetGen on the same surfaces in the same run.

The mode `constrained` is compared with TetGen's -pY, the mode `conforming` with its -p. README.md in this folder tells how
to build the programs.
"""
import math
import os
import sys
import tempfile

from benchmark_common import Programs, Records, model_of, parser_of, surfaces_of, wanted

SWITCHES = {"constrained": "pY", "conforming": "p"}
KINDS = ("inside", "outside", "on_edges", "on_facets")


def measure(programs, arguments, task):
    file, mode = task
    with tempfile.TemporaryDirectory(prefix="br3_") as folder:
        surface = os.path.join(folder, "in.off")
        ours = programs.recover(file, "--table", "--mode", mode, "--write-surface", surface, limit=arguments.time_limit)
        theirs = {"outcome": "skipped"}
        if ours["outcome"] not in ("unreadable", "invalid_input") and os.path.exists(surface):
            theirs = programs.mesh_by_tetgen(surface, SWITCHES[mode], ours)
    for useless in ("phases", "checksum"):
        ours.pop(useless, None)
    theirs.pop("steps", None)
    return {"model": model_of(file), "mode": mode, "ours": ours, "tetgen": theirs}


def geometric_mean(values):
    return math.exp(sum(math.log(v) for v in values) / len(values)) if values else float("nan")


def print_summary(rows):
    for mode in SWITCHES:
        done = [r for r in rows if r["mode"] == mode and r["ours"]["outcome"] == "recovered"]
        both = [r for r in done if r["tetgen"]["outcome"] == "ok"]
        print("\nmode %s: %d of %d valid surfaces recovered; TetGen -%s succeeds on %d of these"
              % (mode, len(done), sum(r["mode"] == mode and r["ours"]["outcome"] not in ("invalid_input", "unreadable")
                                      for r in rows), SWITCHES[mode], len(both)))
        if not done:
            continue
        print("  Steiner points: " + ", ".join("%d %s" % (sum(r["ours"]["steiner_points_" + k] for r in done),
                                                          k.replace("_", " ")) for k in KINDS))
        if not both:
            continue
        print("  where both succeed, in the domain or on the surface: ours %d, TetGen's %d (%d inside, %d on edges, %d on facets)"
              % ((sum(domain_points(r["ours"]) for r in both),)
                 + tuple(sum(r["tetgen"][k] for r in both)
                         for k in ("points", "points_inside", "points_on_edges", "points_on_facets"))))
        fewer = sum(domain_points(r["ours"]) < r["tetgen"]["points"] for r in both)
        more = [r for r in both if domain_points(r["ours"]) > r["tetgen"]["points"]]
        print("  fewer than TetGen on %d, as many on %d, more on %d: %s"
              % (fewer, len(both) - fewer - len(more), len(more), ", ".join(r["model"] for r in more[:12])))
        print("  pairwise ratio (points + 1): geometric mean %.3f"
              % geometric_mean([(domain_points(r["ours"]) + 1) / (r["tetgen"]["points"] + 1) for r in both]))
        # slivers of the input's own flat regions have no angle worth a ratio
        for key, value in (("smallest_angle", lambda x: x), ("largest_angle", lambda x: 180 - x)):
            pairs = [(value(r["ours"][key]), value(r["tetgen"][key])) for r in both]
            pairs = [p for p in pairs if min(p) > 1e-6]
            print("  %s: ratio of %s, geometric mean %.3f (on %d surfaces, where both are above 1e-6 degrees)"
                  % (key.replace("_", " "), "the angles" if key[0] == "s" else "what 180 degrees exceed it by",
                     geometric_mean([a / b for a, b in pairs]), len(pairs)))


def domain_points(ours):
    return sum(ours["steiner_points_" + k] for k in KINDS if k != "outside")


def main():
    parser = parser_of(__doc__, 120)
    parser.add_argument("--jobs", type=int, default=2, help="surfaces at a time, default 2; no times are compared here")
    parser.add_argument("--time-limit", type=float, default=60, help="maximum_running_time of the recovery, default 60")
    arguments = parser.parse_args()
    programs = Programs(arguments)
    records = Records(arguments, "quality.jsonl", ("model", "mode"))
    tasks = [(file, mode) for file in wanted(arguments, surfaces_of(arguments)) for mode in SWITCHES
             if not records.has(model=model_of(file), mode=mode)]
    records.measure(arguments.jobs, lambda task: measure(programs, arguments, task), tasks,
                    lambda row: "%s %s: %s, TetGen %s" % (row["model"], row["mode"], row["ours"]["outcome"],
                                                          row["tetgen"]["outcome"]))
    print_summary(records.rows)
    return 1 if any(r["ours"]["outcome"] == "crash" for r in records.rows) else 0


if __name__ == "__main__":
    sys.exit(main())
