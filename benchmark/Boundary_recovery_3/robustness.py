#!/usr/bin/env python3
"""Recovers every surface in every mode with both kernels, and has each result judged by an exact checker.

The checker (test/Boundary_recovery_3/oracles/exact_mesh_checker_br3.h) is written from the definition, and looks at the final
triangulation only: all cells positive, the convex hull tiled, every triangle there or listed as missing, no Steiner
point where none may be. README.md in this folder tells how to build the programs.
"""
import collections
import sys

from benchmark_common import Programs, Records, model_of, parser_of, surfaces_of, wanted

MODES, KERNELS = ("flips_only", "constrained", "conforming"), ("epick", "epeck")
GOOD = ("exact", "rounded")


def measure(programs, arguments, task):
    file, mode, kernel = task
    result = programs.recover(file, "--check", "--mode", mode, "--kernel", kernel, limit=arguments.time_limit)
    keep = ("outcome", "verdict", "note", "vertices", "facets", "lost_edges", "lost_facets", "steiner_points", "defects", "deviation",
            "is_valid", "tds_is_valid", "recount_agrees", "recovery_seconds", "wall_seconds")
    row = {"model": model_of(file), "mode": mode, "kernel": kernel}
    row.update((k, result[k]) for k in keep if k in result)
    return row


def print_summary(rows):
    print("\n| mode | kernel | surfaces | recovered | incomplete | refused as invalid | stopped or timeout | unreadable | "
          "crash | judged | exact | rounded | faults |")
    print("|---|---|" + 11 * "---:|")
    for mode in MODES:
        for kernel in KERNELS:
            some = [r for r in rows if (r["mode"], r["kernel"]) == (mode, kernel)]
            if not some:
                continue
            n = collections.Counter(r["outcome"] for r in some)
            v = collections.Counter(r["verdict"] for r in some if "verdict" in r)
            print("| %s | %s | " % (mode, kernel) + " | ".join(str(x) for x in (
                len(some), n["recovered"], n["incomplete"], n["invalid_input"], n["stopped"] + n["timeout"],
                n["unreadable"], n["crash"], sum(v.values()), v["exact"], v["rounded"],
                sum(v[k] for k in v if k not in GOOD))) + " |")
    bad = [r for r in rows if r["outcome"] == "crash" or r.get("verdict", "exact") not in GOOD]
    for r in bad:
        print("%s, %s, %s: %s %s %s" % (r["model"], r["mode"], r["kernel"], r["outcome"], r.get("verdict", ""),
                                        r.get("note", "")))
    for r in rows:
        if r["mode"] != "flips_only" and r["outcome"] in ("incomplete", "stopped", "timeout"):
            print("%s, %s, %s: %s" % (r["model"], r["mode"], r["kernel"], r["outcome"]))
    return not bad


def main():
    parser = parser_of(__doc__, 120)
    parser.add_argument("--jobs", type=int, default=2, help="runs at a time, default 2")
    parser.add_argument("--time-limit", type=float, default=30, help="maximum_running_time of the recovery, default 30")
    arguments = parser.parse_args()
    programs = Programs(arguments)
    records = Records(arguments, "robustness.jsonl", ("model", "mode", "kernel"))
    tasks = [(file, mode, kernel) for file in wanted(arguments, surfaces_of(arguments)) for mode in MODES
             for kernel in KERNELS if not records.has(model=model_of(file), mode=mode, kernel=kernel)]
    records.measure(arguments.jobs, lambda task: measure(programs, arguments, task), tasks,
                    lambda row: "%s %s %s: %s, %s" % (row["model"], row["mode"], row["kernel"], row["outcome"],
                                                      row.get("verdict", "-")))
    return 0 if print_summary(records.rows) else 1


if __name__ == "__main__":
    sys.exit(main())
