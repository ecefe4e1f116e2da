#!/usr/bin/env python3
"""Meshes a surface in sub-domains by mesh_surface_mpi with several numbers of ranks, and as a whole by mesh_surface: Table 5.

A row for each run, with the columns of Table 5 of the article [CZZ+17] as far as they have a meaning here: the seconds of
the decomposition, of the filling, of what is between the rounds (repartitioning), of the improvement, of the output, and of
all; then the peak memory of a rank, how much longer the tasks took than if all ranks had worked all the time, and angles.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile
import time

ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
COLUMNS = ("ranks", "cells", "decomposition", "filling", "between", "improvement", "output", "all", "MB", "imbalance",
           "smallest angle", "below 10, 15, 20")


def run(command, folder):
    """the report of the program, the seconds that it took, and its peak memory in MB"""
    report = os.path.join(folder, "report.json")
    begin = time.time()
    process = subprocess.Popen(command + ["--quiet", "--report", report], env=ENVIRONMENT, stdin=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit("subdomains.py: %s failed" % " ".join(command))
    seconds = time.time() - begin
    with open(report) as file:
        return json.load(file), seconds, usage.ru_maxrss / 1024.


def angles(report):
    below = report["tetrahedra_with_angle_below"]
    return "%.1f" % report["min_dihedral_angle"], ", ".join(str(below[k]) for k in ("10", "15", "20"))


def row_of_ranks(report, seconds):
    rounds, ranks = report["rounds"], report["number_of_ranks"]
    tasks = {improves: sum(r["seconds_tasks"] for r in rounds if r["improves"] == improves) for improves in (False, True)}
    worked = sum(t["seconds"] for r in rounds for t in r["tasks"])
    return (ranks, report["number_of_tetrahedra"], report["seconds_division"], tasks[False],
            sum(r["seconds_seams"] for r in rounds), tasks[True], report["seconds_output"], seconds,
            max(report["peak_memory_of_ranks"]) / 1e6, "%.1f %%" % (100 * (sum(tasks.values()) * ranks / worked - 1)),
            *angles(report))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surface")
    parser.add_argument("--mesher", required=True, metavar="PROGRAM", help="mesh_surface")
    parser.add_argument("--mpi-mesher", required=True, metavar="PROGRAM", help="mesh_surface_mpi")
    parser.add_argument("--mpiexec", default="mpirun")
    parser.add_argument("--size", type=float, required=True)
    parser.add_argument("--subdomains", type=int, default=242)
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2])
    options = parser.parse_args()
    print("| %s |\n|%s" % (" | ".join(COLUMNS), "---|" * len(COLUMNS)))
    with tempfile.TemporaryDirectory() as folder:
        arguments = [options.surface, "--size", str(options.size)]
        for ranks in options.ranks:
            report, seconds, _ = run([options.mpiexec, "-n", str(ranks), "--oversubscribe", options.mpi_mesher, *arguments,
                                      "--subdomains", str(options.subdomains), "-o", os.path.join(folder, "m.pvtu")], folder)
            print_row(row_of_ranks(report, seconds))
        report, seconds, memory = run([options.mesher, *arguments, "-o", os.path.join(folder, "m.vtu")], folder)
        print_row(("undivided", report["number_of_tetrahedra"], 0., report["seconds_field_points"], 0.,
                   report["seconds_improvement"], seconds - report["seconds"], seconds, memory, "", *angles(report)))


def print_row(row):
    print("| %s |" % " | ".join("%.1f" % x if isinstance(x, float) else str(x) for x in row), flush=True)


if __name__ == "__main__":
    main()
