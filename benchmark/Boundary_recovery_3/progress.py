#!/usr/bin/env python3
"""Measures how true the share is that the progress bar of mesh_surface shows: runs it in a pseudo terminal, and compares
each share, from when it is drawn until another one is, with the share of the time of the whole run.

usage: progress.py [--repeat N] [--verbose] PROGRAM SURFACE... [-- OPTION...]

A line for each surface: the seconds, the largest share that the bar was ahead, and behind, in the median run of N (3).
"""
import argparse
import os
import pty
import re
import subprocess
import sys
import tempfile
import time


def run(command):
    """the seconds it took, and the pairs (seconds, share) of the bar; the share is None where it is taken away"""
    master, slave = pty.openpty()
    start = time.monotonic()
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=slave, stderr=subprocess.DEVNULL)
    os.close(slave)
    shown = []
    while True:
        try:
            data = os.read(master, 65536)
        except OSError:  # what Linux tells when the other end is closed
            break
        if not data:
            break
        seconds = time.monotonic() - start
        for line in data.decode(errors="replace").split("\r"):
            share = re.search(r"\] (\d+) %", line)
            if share:
                shown.append((seconds, int(share.group(1)) / 100, line.split()[0]))
            elif line and not line.strip() and "\n" not in line:
                shown.append((seconds, None, ""))
    os.close(master)
    process.wait()
    return time.monotonic() - start, shown


def deviations(seconds, shown):
    """the largest shares that the bar was ahead, and behind"""
    ahead = behind = 0
    for (begin, share, _), (end, _, _) in zip(shown, shown[1:] + [(seconds, None, "")]):
        if share is not None:
            ahead, behind = max(ahead, share - begin / seconds), max(behind, end / seconds - share)
    return ahead, behind


def main():
    arguments, options = sys.argv[1:], []
    if "--" in arguments:
        k = arguments.index("--")
        arguments, options = arguments[:k], arguments[k + 1:]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--verbose", action="store_true")
    parser.add_argument("program")
    parser.add_argument("surface", nargs="+")
    given = parser.parse_args(arguments)
    print("%-30s %8s %7s %7s" % ("surface", "seconds", "ahead", "behind"))
    with tempfile.TemporaryDirectory() as folder:
        for surface in given.surface:
            runs = []
            for _ in range(given.repeat):
                seconds, shown = run([given.program, surface, "-o", os.path.join(folder, "mesh.msh")] + options)
                runs.append((max(deviations(seconds, shown)), seconds, shown))
            _, seconds, shown = sorted(runs, key=lambda r: r[0])[len(runs) // 2]
            print("%-30s %8.2f %7.2f %7.2f" % ((os.path.basename(surface), seconds) + deviations(seconds, shown)),
                  flush=True)
            if given.verbose:
                for when, share, words in shown:
                    print("    %5.2f %s %s" % (when / seconds, "-" if share is None else "%.2f" % share, words))
    return 0


if __name__ == "__main__":
    sys.exit(main())
