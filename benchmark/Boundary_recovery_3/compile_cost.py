#!/usr/bin/env python3
"""Measures what it costs to compile a file that includes recover_boundary.h, beside Delaunay_triangulation_3.h alone.

Two pairs of files are compiled in turn: those that only include, and those that also use what they include (an insertion,
and for us the recovery). The shortest processor time of --runs compilations and their largest memory are printed, with
the ratios. ctest only checks that this script runs.
"""
import argparse
import json
import os
import shlex
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
KERNEL = "#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>\n"
DELAUNAY = "#include <CGAL/Delaunay_triangulation_3.h>\n"
RECOVERY = "#include <CGAL/recover_boundary.h>\n"
TYPES = ("#include <array>\n#include <cstddef>\n#include <vector>\n"
         "typedef CGAL::Exact_predicates_inexact_constructions_kernel K;\ntypedef CGAL::Delaunay_triangulation_3<K> Tr;\n"
         "std::vector<K::Point_3> points;\nstd::vector<std::array<std::size_t, 3> > faces;\n")
INSERT = "int main() { Tr tr; tr.insert(points.begin(), points.end()); return int(tr.number_of_vertices()); }\n"
RECOVER = "int main() { Tr tr; return int(CGAL::recover_boundary(tr, points, faces).status); }\n"
PAIRS = {  # what: without us, with us
    "included": (KERNEL + DELAUNAY, KERNEL + DELAUNAY + RECOVERY),
    "included, used": (KERNEL + DELAUNAY + TYPES + INSERT, KERNEL + DELAUNAY + RECOVERY + TYPES + RECOVER),
}


def compile_once(command, code, folder):
    """seconds (user and system) and MB of one compilation"""
    source = os.path.join(folder, "x.cpp")
    with open(source, "w", encoding="ascii") as file:
        file.write(code)
    child = subprocess.Popen(command + ["-c", source, "-o", os.path.join(folder, "x.o")])
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = status
    if status != 0:
        sys.exit("compile_cost.py: the compiler failed")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024.


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--compiler", default=os.environ.get("CXX", "g++"))
    parser.add_argument("--flags", default="-std=c++17 -frounding-math -O2 -DNDEBUG", help="default: %(default)s")
    parser.add_argument("--include", nargs="*", metavar="DIR", default=[], help="where the headers of other libraries are")
    parser.add_argument("--runs", type=int, default=3, help="compilations of each file, default 3")
    parser.add_argument("--only", choices=list(PAIRS), help="one pair only")
    parser.add_argument("--out", metavar="FILE.json")
    arguments = parser.parse_args()
    command = [arguments.compiler] + shlex.split(arguments.flags) + ["-I" + folder for folder in arguments.include]
    command.append("-I" + os.path.join(ROOT, "include"))
    rows, start = [], time.strftime("%Y-%m-%d")
    print("| compilation with %s %s | Delaunay_triangulation_3.h | recover_boundary.h | ratio |\n|---|---|---|---|"
          % (os.path.basename(arguments.compiler), arguments.flags))
    with tempfile.TemporaryDirectory(prefix="br3_") as folder:
        for what, codes in PAIRS.items():
            if arguments.only not in (None, what):
                continue
            runs = [[compile_once(command, code, folder) for code in codes] for _ in range(arguments.runs)]
            seconds = [min(run[i][0] for run in runs) for i in (0, 1)]
            memory = [max(run[i][1] for run in runs) for i in (0, 1)]
            rows.append({"what": what, "seconds": seconds, "memory_mb": memory})
            print("| %s: seconds | %.2f | %.2f | %.2f |" % (what, seconds[0], seconds[1], seconds[1] / seconds[0]))
            print("| %s: MB | %.0f | %.0f | %.2f |" % (what, memory[0], memory[1], memory[1] / memory[0]), flush=True)
    if arguments.out:
        with open(arguments.out, "w", encoding="ascii") as file:
            json.dump({"date": start, "command": shlex.join(command), "rows": rows}, file, indent=1)
            file.write("\n")


if __name__ == "__main__":
    main()
