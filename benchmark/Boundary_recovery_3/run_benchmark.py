#!/usr/bin/env python3
"""Recovers many surfaces in one mode, beside TetGen if it is there, and prints the figures that tell how it went.

README.md in this folder tells how to build the program that is run here, and what the columns of the table mean.
"""
import argparse
import concurrent.futures
import json
import math
import os
import re
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
DRIVER = os.path.join(ROOT, "build", "benchmark", "benchmark", "Boundary_recovery_3", "benchmark_recovery")
BUILD = ("cmake -S %s -B %s -DBUILD_TESTING=OFF -DBR3_BUILD_BENCHMARK=ON"
         " && cmake --build %s --target benchmark_recovery")
FORMATS = (".off", ".ply", ".stl", ".obj")
RESOLUTION = 1e-6  # seconds; TetGen's clock() counts microseconds
LONG = 0.01        # seconds; what takes TetGen longer is more than noise
SECOND_RUN = 20.0  # seconds; a surface that took longer is run once only
CHECKS = ("is_valid", "tds_is_valid", "cells_are_positive", "hull_is_convex", "recount_agrees")


class Table:
    """the phases that the program knows, the first one being the insertion, and the columns that follow from them"""

    def __init__(self, driver):
        status, output, _, _ = run([driver, "--phases"], 60)
        if status != 0 or not output.split():
            sys.exit("run_benchmark.py: %s does not tell its phases" % driver)
        self.phases = output.split()
        self.middle = self.phases[2:-1]  # neither the insertion, nor the search, nor the recount
        self.columns = (["model", "vertices", "facets", "edges", "outcome"]
                        + ["lost_edges_at_start", "lost_facets_at_start"]
                        + [kind + "_after_" + phase for kind in ("edges", "facets") for phase in self.middle]
                        + ["lost_edges", "lost_facets", "shell_transformations", "valid", "verdict", "same_output",
                           "constraint_points", "steiner_points_after_splitting", "steiner_points",
                           "steiner_points_in_domain", "insertion_seconds", "recovery_seconds", "phases_seconds"]
                        + ["seconds_" + phase for phase in self.phases[1:]]
                        + ["peak_memory_mb", "wall_seconds", "tetgen", "tetgen_seconds", "tetgen_points", "ratio",
                           "checksum", "note", "file"])


def surfaces_of(arguments):
    files = []
    for place in arguments.places:
        if os.path.isdir(place):
            files += [os.path.join(place, name) for name in os.listdir(place) if name.lower().endswith(FORMATS)]
        else:
            files.append(place)
    if arguments.list:
        with open(arguments.list, encoding="utf-8") as lines:
            wanted = [line.strip() for line in lines if line.strip() and not line.startswith("#")]
        by_name = {os.path.basename(file): file for file in files}
        files = [by_name.get(os.path.basename(line), line) for line in wanted]
    missing = [file for file in files if not os.path.isfile(file)]
    if missing:
        sys.exit("run_benchmark.py: no such file: " + ", ".join(missing[:10]))
    return sorted(set(files), key=lambda file: (os.path.getsize(file), file))  # a crash shows up early


def run(command, timeout):
    """runs a program; returns its exit status (negative: signal; None: stopped at the timeout), output and seconds"""
    start = time.monotonic()
    try:
        done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              timeout=timeout, check=False)
    except subprocess.TimeoutExpired:
        return None, "", "", time.monotonic() - start
    texts = [text.decode("utf-8", "replace") for text in (done.stdout, done.stderr)]
    return done.returncode, texts[0], texts[1], time.monotonic() - start


def without_measurements(value):
    """the result without what may differ between two runs: times and memory"""
    if isinstance(value, dict):
        return {k: without_measurements(v) for k, v in value.items() if "seconds" not in k and k != "peak_memory_mb"}
    if isinstance(value, list):
        return [without_measurements(v) for v in value]
    return value


def run_ours(arguments, file, surface, mesh):
    command = [arguments.driver, file, "--table", "--mode", arguments.mode, "--kernel", arguments.kernel]
    if surface:
        command += ["--write-surface", surface]
    if mesh:
        command += ["--write-mesh", mesh]
    if arguments.time_limit is not None:
        command += ["--time-limit", str(arguments.time_limit)]
    status, output, errors, seconds = run(command, arguments.timeout)
    if status == 0:
        try:
            return {"result": json.loads(output), "wall": seconds}
        except ValueError:
            return {"outcome": "crash", "note": "the output is not JSON", "wall": seconds}
    outcome = {None: "timeout", 1: "unreadable", 2: "crash"}.get(status, "crash")
    note = (errors.strip().splitlines() or [""])[-1]
    if status is not None and status < 0:
        note = "signal %d %s" % (-status, note)
    return {"outcome": outcome, "note": note, "wall": seconds}


def seconds_of_step(step, log):
    found = re.findall(step + r" seconds:\s+([0-9.eE+-]+)", log)
    return float(found[-1]) if found else 0.0


def verdict(arguments, surface, mesh):
    """the class that the verifier finds"""
    status, output, _, _ = run([arguments.verify, surface, mesh], arguments.timeout)
    try:
        found = json.loads(output)
    except ValueError:
        return "verifier failed" if status is not None else "verifier timeout"
    if found["class"] == "strict" and found.get("steiner_seg", 0) + found.get("steiner_fac", 0) > 0:
        return "points on the surface"
    return found["class"]


def run_tetgen(arguments, surface, output):
    status, log, _, _ = run([arguments.tetgen, "pYV", surface, output], arguments.timeout)
    if status != 0:
        return {"tetgen": "timeout" if status is None else "error %d" % status}
    seconds = seconds_of_step("Boundary recovery", log)
    if arguments.mode == "constrained":  # ours has removed what it could of the points then
        seconds += seconds_of_step("Steiner suppression", log)
    try:
        with open(output, encoding="ascii") as file:
            header = file.readline().split()
        os.remove(output)
        points = int(header[1]) if header[:1] == ["vtet"] else None
    except (OSError, ValueError, IndexError):
        points = None
    return {"tetgen": "ok", "seconds": seconds, "points": points}


def fill(row, result, table):
    """enters the numbers of one run"""
    for key in ("vertices", "facets", "edges", "lost_edges_at_start", "lost_facets_at_start", "lost_edges",
                "lost_facets", "shell_transformations", "constraint_points", "steiner_points_after_splitting",
                "steiner_points", "peak_memory_mb"):
        row[key] = result[key]
    row["steiner_points_in_domain"] = result.get("steiner_points_in_domain", "")
    row["outcome"] = result["status"]
    row["checksum"] = result.get("checksum", "")
    fill_times(row, result)
    lost = {phase["phase"]: phase for phase in result["phases"]}
    state = {"lost_edges": result["lost_edges_at_start"], "lost_facets": result["lost_facets_at_start"]}
    for phase in table.middle:
        state = lost.get(phase, state)  # a phase that had nothing to do changes nothing
        row["edges_after_" + phase], row["facets_after_" + phase] = state["lost_edges"], state["lost_facets"]
    failed = [check for check in CHECKS if result.get(check) is False]
    row["valid"] = "no: " + ", ".join(failed) if failed else "yes"


def fill_times(row, result):
    for key in ("recovery_seconds", "phases_seconds", "insertion_seconds"):
        row[key] = result[key]
    for phase in result["phases"]:
        row["seconds_" + phase["phase"]] = 0
    for phase in result["phases"]:  # the recount runs twice: after the flips, and in the end
        row["seconds_" + phase["phase"]] += phase["seconds"]


def second_run_verdict(first, second):
    if "result" not in second:
        return "no: " + second["outcome"]
    if "stopped" in (first["result"]["status"], second["result"]["status"]):
        return "stopped"  # at a time, not at a state
    equal = without_measurements(first["result"]) == without_measurements(second["result"])
    return "yes" if equal else "no"


def measure(arguments, table, file):
    """runs one surface, ours and TetGen in turn; both times are the shorter ones of equally many runs"""
    row = dict.fromkeys(table.columns, "")
    row["model"], row["file"] = os.path.splitext(os.path.basename(file))[0], file
    with tempfile.TemporaryDirectory(prefix="br3_") as folder:
        surface, output = os.path.join(folder, "in.off"), os.path.join(folder, "out.vtet")
        mesh = os.path.join(folder, "out.mesh") if arguments.verify else None
        first = run_ours(arguments, file, surface if arguments.tetgen or arguments.verify else None, mesh)
        row["wall_seconds"] = first["wall"]
        peers = []
        if arguments.tetgen and os.path.exists(surface):
            peers.append(run_tetgen(arguments, surface, output))
        if "result" in first:
            fill(row, first["result"], table)
            if arguments.verify and row["outcome"] == "recovered":
                row["verdict"] = verdict(arguments, surface, mesh)
            if first["wall"] > SECOND_RUN:
                row["same_output"] = "skipped"
            else:
                second = run_ours(arguments, file, None, None)
                row["same_output"] = second_run_verdict(first, second)
                if "result" in second and second["result"]["recovery_seconds"] < row["recovery_seconds"]:
                    fill_times(row, second["result"])
                if peers and peers[0]["tetgen"] == "ok":
                    peers.append(run_tetgen(arguments, surface, output))
        else:
            row["outcome"], row["note"] = first["outcome"], first["note"]
        fill_peer(row, peers)
    return row


def fill_peer(row, peers):
    if not peers:
        return
    row["tetgen"] = next((p["tetgen"] for p in peers if p["tetgen"] != "ok"), "ok")
    if row["tetgen"] != "ok":
        return
    row["tetgen_seconds"] = min(p["seconds"] for p in peers)
    if peers[0]["points"] is not None and row["vertices"] != "":
        row["tetgen_points"] = peers[0]["points"] - row["vertices"]
    if row["recovery_seconds"] != "" and row["tetgen_seconds"] > 0:
        row["ratio"] = ratio(row, "recovery_seconds")


def ratio(row, key):
    return max(row[key], RESOLUTION) / max(row["tetgen_seconds"], RESOLUTION)


def text_of(value):
    if isinstance(value, float):
        return "%.6g" % value
    return re.sub(r"\s+", " ", str(value))


def percent(part, whole):
    return "%.2f %%" % (100.0 * part / whole) if whole else "-"


def names(rows, limit=12):
    shown = ", ".join(row["model"] for row in rows[:limit])
    return ": " + shown + (", ..." if len(rows) > limit else "") if rows else ""


def geometric_mean(values):
    return math.exp(sum(math.log(v) for v in values) / len(values))


def print_verdicts(rows):
    def line(text, good, whole, bad):
        print("%-29s %d of %d%s" % (text, good, whole, names(bad)))

    def with_outcome(outcome):
        return [r for r in rows if r["outcome"] == outcome]

    measured = [r for r in rows if r["valid"]]
    invalid = [r for r in measured if r["valid"] != "yes"]
    twice = [r for r in rows if r["same_output"] not in ("", "skipped", "stopped")]
    differing = [r for r in twice if r["same_output"] != "yes"]
    print("%-29s %d" % ("surfaces", len(rows)))
    for text, outcome in (("no crash", "crash"), ("no hang (within the timeout)", "timeout")):
        bad = with_outcome(outcome)
        line(text, len(rows) - len(bad), len(rows), bad)
    line("valid, of those measured", len(measured) - len(invalid), len(measured), invalid)
    line("same output, of those twice", len(twice) - len(differing), len(twice), differing)
    once = [r for r in rows if r["same_output"] == "skipped"]
    for text, found in (("run once only: over %g s" % SECOND_RUN, once), ("cannot be read", with_outcome("unreadable")),
                        ("stopped at the time limit", with_outcome("stopped")),
                        ("refused as invalid input", with_outcome("invalid_input"))):
        if found:
            print("%-29s %d%s" % (text, len(found), names(found)))
    recovered = len(with_outcome("recovered"))
    print("%-29s %d of %d = %s" % ("fully recovered", recovered, len(rows), percent(recovered, len(rows))))
    free = sum(r["outcome"] == "recovered" and r["steiner_points_in_domain"] == 0 for r in rows)
    print("%-29s %d of %d = %s" % ("  without a point inside", free, len(rows), percent(free, len(rows))))
    judged = sorted(set(r["verdict"] for r in rows if r["verdict"]))
    for found in judged:
        such = [r for r in rows if r["verdict"] == found]
        print("%-29s %d%s" % ("verifier: " + found, len(such), names(such) if found != "strict" else ""))


def total(rows, key):
    return sum(row[key] for row in rows if row[key] != "")


def print_lost(all_rows, table):
    """the sums over the surfaces of which the end is known"""
    rows = [r for r in all_rows if r["lost_edges"] != ""]
    for kind in ("edges", "facets"):
        start, end = total(rows, "lost_%s_at_start" % kind), total(rows, "lost_" + kind)
        print("%-7s lost after the insertion %d, still lost %d = %s" % (kind, start, end, percent(end, start)))
    if len(rows) < len(all_rows):
        print("  (without %d surfaces that came to no end)" % (len(all_rows) - len(rows)))
    line = "%-26s %12s %12s %12s"
    print("\nsums over the %d surfaces that were measured" % len(rows))
    print(line % ("phase", "lost edges", "lost facets", "seconds"))
    print(line % ("insertion", "", "", "%.3f" % total(rows, "insertion_seconds")))
    for phase in table.phases[1:]:
        if all(row["seconds_" + phase] == "" for row in rows):
            continue  # it never ran
        suffix = None if phase in table.middle else "_at_start" if phase == "search" else ""
        keys = [kind + "_after_" + phase if suffix is None else "lost_" + kind + suffix for kind in ("edges", "facets")]
        print(line % (phase, total(rows, keys[0]), total(rows, keys[1]), "%.3f" % total(rows, "seconds_" + phase)))
    beside = total(rows, "recovery_seconds") - total(rows, "phases_seconds")
    print(line % ("beside the phases", "", "", "%.3f" % beside))


POINT_COLUMNS = ["constraint_points", "steiner_points_after_splitting", "steiner_points", "steiner_points_in_domain"]


def print_points(rows, has_peer):
    """Steiner points, in total and beside TetGen's"""
    done = [r for r in rows if r["outcome"] == "recovered"]
    print("Steiner points on the %d surfaces that were recovered: %d put on constraints, %d after splitting, %d left, %d in the domain"
          % ((len(done),) + tuple(total(done, column) for column in POINT_COLUMNS)))
    both = [r for r in done if r["tetgen_points"] != "" and r["steiner_points_in_domain"] != ""]
    if both:
        more = [r for r in both if r["steiner_points_in_domain"] > r["tetgen_points"]]
        print("  in the domain, on the %d of them where TetGen succeeds: %d, TetGen %d"
              % (len(both), total(both, "steiner_points_in_domain"), total(both, "tetgen_points")))
        print("  more than TetGen: %d of %d%s" % (len(more), len(both), names(more)))
    most = sorted((r for r in rows if r["steiner_points"] not in ("", 0)),
                  key=lambda r: (-(r["steiner_points_in_domain"] or 0), -r["steiner_points"], r["model"]))[:10]
    if most:
        print_worst("the ten with the most Steiner points in the domain", most,
                    ["facets"] + POINT_COLUMNS + (["tetgen_points"] if has_peer else []) + ["recovery_seconds"])


def print_peer(rows, mode):
    tried = [r for r in rows if r["tetgen"]]
    good = [r for r in tried if r["tetgen"] == "ok"]
    free = [r for r in good if r["tetgen_points"] == 0]
    print("%-29s %d of %d" % ("TetGen -pY succeeds", len(good), len(tried)))
    print("%-29s %d of %d = %s" % ("  without a point", len(free), len(tried), percent(len(free), len(tried))))
    both = [r for r in good if r["ratio"] != ""]
    if not both:
        return
    print("recovery time / TetGen's \"Boundary recovery seconds\"%s on %d surfaces"
          % (" + \"Steiner suppression seconds\"" if mode == "constrained" else "", len(both)))
    print("  (%d left out: no time of ours, or 0 s of TetGen)" % (len(good) - len(both)))
    slow = [r for r in both if r["tetgen_seconds"] >= LONG]
    for key, name in (("recovery_seconds", "whole call but insertion"), ("phases_seconds", "phases alone")):
        ours, theirs = total(both, key), total(both, "tetgen_seconds")
        print("  %s: geometric mean %.3f; totals %.3f s / %.3f s = %.3f"
              % (name, geometric_mean([ratio(r, key) for r in both]), ours, theirs, ours / theirs))
        if slow:
            print("    where TetGen takes %g s or more (%d surfaces): geometric mean %.3f"
                  % (LONG, len(slow), geometric_mean([ratio(r, key) for r in slow])))
    print("  (times below the resolution of TetGen's clock, %g s, count as that: ours on %d surfaces)"
          % (RESOLUTION, sum(r["recovery_seconds"] < RESOLUTION for r in both)))


def print_worst(title, rows, columns):
    lines = [["model"] + columns] + [[text_of(row[c]) for c in ["model"] + columns] for row in rows]
    widths = [max(len(line[i]) for line in lines) for i in range(len(lines[0]))]
    print("\n" + title)
    for line in lines:
        print("  " + line[0].ljust(widths[0]) + "".join("  " + t.rjust(w) for t, w in zip(line[1:], widths[1:])))


def print_summary(rows, table, mode, has_peer):
    print("mode                          " + mode)
    print_verdicts(rows)
    print_lost(rows, table)
    print()
    print_points(rows, has_peer)
    if has_peer:
        print()
        print_peer(rows, mode)
    worst = sorted((r for r in rows if r["lost_edges"] != "" and r["lost_edges"] + r["lost_facets"] > 0),
                   key=lambda r: (-r["lost_edges"], -r["lost_facets"], r["model"]))[:10]
    if worst:
        print_worst("the ten worst by edges still lost", worst,
                    ["facets", "lost_edges_at_start", "lost_edges", "lost_facets", "recovery_seconds"])
    if has_peer:
        slowest = sorted((r for r in rows if r["ratio"] != ""), key=lambda r: -r["ratio"])[:10]
        print_worst("the ten slowest relative to TetGen", slowest,
                    ["facets", "lost_edges_at_start", "recovery_seconds", "tetgen_seconds", "ratio"])


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("places", nargs="*", metavar="FOLDER_OR_FILE", help="surfaces: .off .ply .stl .obj")
    parser.add_argument("--list", metavar="FILE",
                        help="run only these: a path, or the name of a file in a folder that is given, per line")
    parser.add_argument("--jobs", type=int, default=2, help="surfaces at a time, default 2; 1 where times matter")
    parser.add_argument("--timeout", type=float, default=120, help="seconds after which a program is stopped")
    parser.add_argument("--time-limit", type=float, help="maximum_running_time of the recovery, in seconds")
    parser.add_argument("--mode", choices=("constrained", "conforming", "flips_only"), default="constrained")
    parser.add_argument("--kernel", choices=("epick", "epeck"), default="epick")
    parser.add_argument("--driver", default=DRIVER, help="the program benchmark_recovery")
    parser.add_argument("--tetgen", metavar="PROGRAM", help="called as PROGRAM pYV in.off out.vtet")
    parser.add_argument("--verify", metavar="PROGRAM", help="called as PROGRAM in.off out.mesh on what was recovered")
    parser.add_argument("--out", metavar="FILE.tsv", help="write a table with a row per surface")
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    if not os.access(arguments.driver, os.X_OK):
        build = os.path.join(ROOT, "build", "benchmark")
        sys.exit("run_benchmark.py: there is no %s; build it:\n  %s" % (arguments.driver, BUILD % (ROOT, build, build)))
    arguments.driver = os.path.abspath(arguments.driver)
    for name in ("tetgen", "verify"):
        program = getattr(arguments, name)
        if program and not os.access(program, os.X_OK):
            sys.exit("run_benchmark.py: no such program: " + program)
        if program:
            setattr(arguments, name, os.path.abspath(program))
    if not arguments.tetgen:
        print("TetGen is skipped: no --tetgen was given", file=sys.stderr)
    files = surfaces_of(arguments)
    if not files:
        sys.exit("run_benchmark.py: no surface to run; give a folder, files, or --list")

    table = Table(arguments.driver)
    file = open(arguments.out, "w", encoding="utf-8") if arguments.out else None
    if file:
        print("\t".join(table.columns), file=file)
    rows = []
    with concurrent.futures.ThreadPoolExecutor(max(1, arguments.jobs)) as pool:
        for row in pool.map(lambda surface: measure(arguments, table, surface), files):
            rows.append(row)
            print("%d/%d %s: %s, %s edges lost, %s points%s"
                  % (len(rows), len(files), row["model"], row["outcome"], *(row[c] if row[c] != "" else "?" for c in
                     ("lost_edges", "steiner_points_in_domain")), row["verdict"] and ", " + row["verdict"]),
                  file=sys.stderr, flush=True)
            if file:
                print("\t".join(text_of(row[column]) for column in table.columns), file=file, flush=True)
    if file:
        file.close()
    print_summary(rows, table, arguments.mode, bool(arguments.tetgen))


if __name__ == "__main__":
    main()
