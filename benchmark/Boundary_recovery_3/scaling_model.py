#!/usr/bin/env python3
"""A model of runs of mesh_surface_mpi with more ranks and cells than one has: events, one after the other.

usage: scaling_model.py --check REPORT...          compare the model with measured runs: reports of mesh_surface_mpi
       scaling_model.py --draw REPORT CHART.svg    10^9 tetrahedra on up to 1,024 ranks, from the times of a report
       scaling_model.py --self-test                cases whose result is known

The parameters of the machine are options, see --help. The run is the program's:
- all ranks read and divide the surface at the same time, each for itself;
- each rank asks rank 0 for work, and gets the heaviest sub-domain that is left. Rank 0 answers one rank after the other,
  and works as well. A report or an answer takes the latency, and its bytes the bandwidth;
- what is told of all sub-domains is sent to all ranks, along a binary tree;
- each rank writes its pieces; the file system has a bandwidth of its own.
"""
import argparse
import heapq
import json
import math
import random

BYTES_OF_REPORT, BYTES_OF_ANSWER = 352, 8       # struct Task_report, and a number
PAPER_TRIANGLES, PAPER_CELLS = 2.3e6, 122.5e6   # Table 5 of the paper: how many triangles a surface has for the cells


class Machine:
    def __init__(self, options):
        self.latency, self.bandwidth = options.latency, options.bandwidth
        self.answer, self.disk, self.disks = options.answer, options.disk, options.file_system

    def message(self, size):
        return self.latency + size / self.bandwidth


class Run:
    """the seconds of each sub-domain, what they weigh, and what is written of them"""
    def __init__(self, seconds, weights, sizes, division):
        self.order = sorted(range(len(seconds)), key=lambda i: -weights[i])  # the same as the program's: it is stable
        self.seconds, self.sizes, self.division = seconds, sizes, division

    def mesh(self, ranks, machine):
        """how long the meshing takes, and the seconds that each rank worked"""
        todo = iter(self.order)
        busy, worked, done_by = 0., [0.] * ranks, [0] * ranks
        # (when a request reaches rank 0, rank); rank 0 asks itself
        events = [(machine.message(BYTES_OF_REPORT) if r else 0., r) for r in range(ranks)]
        heapq.heapify(events)
        end = 0.
        while events:
            time, rank = heapq.heappop(events)
            if rank:
                busy = max(busy, time) + machine.answer
                time = busy + machine.message(BYTES_OF_ANSWER)
            task = next(todo, None)
            if task is None:
                end = max(end, time)
                continue
            worked[rank] += self.seconds[task]
            done_by[rank] += self.sizes[task]
            heapq.heappush(events, (time + self.seconds[task] + (machine.message(BYTES_OF_REPORT) if rank else 0.), rank))
        return end, worked, done_by

    def phases(self, ranks, machine):
        """seconds of the division, the meshing, the exchange of numbers and the output"""
        meshing, worked, written = self.mesh(ranks, machine)
        levels = math.ceil(math.log2(ranks)) if ranks > 1 else 0
        exchange = levels * (2 * machine.latency + machine.message(BYTES_OF_REPORT * len(self.seconds)))
        output = max(max(written) / machine.disk, sum(written) / machine.disks)
        return self.division, meshing, exchange, output

    def imbalance(self, ranks, machine):
        """how much longer the meshing takes than if all ranks worked all the time"""
        meshing, worked, _ = self.mesh(ranks, machine)
        return meshing / (sum(worked) / ranks) - 1


def run_of(report):
    some = report["subdomains"]
    return Run([s["seconds"] for s in some], [s["weight"] for s in some], [s["bytes"] for s in some],
               report["seconds_division"])


def larger_run(report, cells, number, division_per_triangle):
    """a run with a number of sub-domains of equal weight, whose times scatter as those of the report do"""
    seconds_per_cell = [s["seconds"] / s["tetrahedra"] for s in report["subdomains"] if s["tetrahedra"]]
    bytes_per_cell = sum(s["bytes"] for s in report["subdomains"]) / report["number_of_tetrahedra"]
    chance = random.Random(1)
    n = cells / number
    triangles = PAPER_TRIANGLES * (cells / PAPER_CELLS) ** (2. / 3)
    return Run([n * chance.choice(seconds_per_cell) for _ in range(number)], [1.] * number,
               [n * bytes_per_cell] * number, division_per_triangle * triangles)


def check(reports, machine):
    """with the times of the sub-domains in each report, and with those of the first one"""
    first = run_of(reports[0])
    worst = 0.
    for report in reports:
        ranks = report["number_of_ranks"]
        for name, run in (("its own times", run_of(report)), ("times of the first", first)):
            foretold = run.mesh(ranks, machine)[0]
            error = foretold / report["seconds_meshing"] - 1
            print("%4d ranks, %s: meshing %.3f s, measured %.3f s (%+.1f %%)"
                  % (ranks, name, foretold, report["seconds_meshing"], 100 * error))
            if name == "its own times":
                worst = max(worst, abs(error))
    return worst


# ---------------------------------------------------------------- the chart

COLORS = ("#2e6da4", "#c0392b", "#7f8c2b", "#555555")  # those of make_charts.py


def draw(curves, cells, path):
    """speed-up over ranks, both in logarithmic scales; `curves` has for each name a list of pairs"""
    left, top, width, height, largest = 62, 34, 420, 300, 10
    def x(ranks): return left + width * math.log2(ranks) / largest
    def y(factor): return top + height * (1 - math.log2(factor) / largest)
    lines = ['<svg xmlns="http://www.w3.org/2000/svg" width="680" height="390" font-family="sans-serif" font-size="12">',
             '<rect width="680" height="390" fill="white"/>',
             '<text x="%d" y="20">%s tetrahedra, speed-up against one rank (model)</text>' % (left, cells)]
    for k in range(0, largest + 1, 2):
        lines += ['<path d="M%.1f %d v%d M%d %.1f h%d" stroke="#dddddd"/>' % (x(2 ** k), top, height, left, y(2 ** k), width),
                  '<text x="%.1f" y="%d" text-anchor="middle">%d</text>' % (x(2 ** k), top + height + 18, 2 ** k),
                  '<text x="%d" y="%.1f" text-anchor="end">%d</text>' % (left - 8, y(2 ** k) + 4, 2 ** k)]
    lines += ['<text x="%d" y="%d" text-anchor="middle">ranks</text>' % (left + width // 2, top + height + 40),
              '<path d="M%.1f %.1f L%.1f %.1f" stroke="#999999" stroke-dasharray="4 4"/>' % (x(1), y(1), x(1024), y(1024))]
    for color, (name, points) in zip(COLORS, curves):
        path_of_curve = " L".join("%.1f %.1f" % (x(ranks), y(max(1., factor))) for ranks, factor in points)
        lines += ['<path d="M%s" fill="none" stroke="%s" stroke-width="2"/>' % (path_of_curve, color),
                  '<text x="%d" y="%.1f" fill="%s">%s</text>' % (left + width + 8, y(max(1., points[-1][1])) + 4, color, name)]
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        file.write("\n".join(lines + ["</svg>"]) + "\n")


def draw_scaling(report, path, machine, options):
    curves = []
    for number in options.subdomains:
        run = larger_run(report, options.cells, number, options.division)
        alone = sum(run.phases(1, machine))
        print("%d sub-domains; one rank: %.0f s" % (number, alone))
        points = []
        for k in range(11):
            phases = run.phases(2 ** k, machine)
            points.append((2 ** k, alone / sum(phases)))
            print("%5d ranks: %9.1f s: division %.1f, meshing %.1f, exchange %.4f, output %.1f; speed-up %.1f, imbalance %.1f %%"
                  % (2 ** k, sum(phases), *phases, points[-1][1], 100 * run.imbalance(2 ** k, machine)))
        curves.append(("%s sub-domains" % format(number, ","), points))
    if options.free_division:
        run = larger_run(report, options.cells, options.subdomains[-1], 0.)
        alone = sum(run.phases(1, machine))
        curves.append(("the same, division free", [(2 ** k, alone / sum(run.phases(2 ** k, machine))) for k in range(11)]))
    draw(curves, format(int(options.cells), ","), path)


def self_test(machine):
    machine.latency = machine.answer = 0.
    machine.bandwidth = machine.disk = machine.disks = math.inf
    def meshing(seconds, ranks):
        return Run(seconds, seconds, [0] * len(seconds), 0.).mesh(ranks, machine)[0]
    assert meshing([1., 2., 3.], 1) == 6 and meshing([1., 2., 3.], 2) == 3 and meshing([1., 2., 3.], 8) == 3
    assert meshing([3., 3., 2., 2., 2.], 2) == 7  # the heaviest first is not the best: that would be 6
    machine.answer = 1.  # rank 0 answers at 1, 2 and 3; the work takes 10, and then all are told that there is no more
    assert Run([10.] * 4, [1.] * 4, [0] * 4, 0.).mesh(4, machine)[0] == 14
    machine.latency = .5
    assert Run([10.] * 2, [1.] * 2, [0] * 2, 0.).mesh(2, machine)[0] == .5 + 1 + .5 + 10 + .5 + 1 + .5
    print("done")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", nargs="+", metavar="REPORT")
    parser.add_argument("--draw", nargs=2, metavar=("REPORT", "CHART"))
    parser.add_argument("--self-test", action="store_true")
    parser.add_argument("--latency", type=float, default=2e-6, help="seconds that a message takes at least")
    parser.add_argument("--bandwidth", type=float, default=1e10, help="bytes per second of a message")
    parser.add_argument("--answer", type=float, default=1e-5, help="seconds that rank 0 takes for an answer")
    parser.add_argument("--disk", type=float, default=1e9, help="bytes per second that a rank writes")
    parser.add_argument("--file-system", type=float, default=1e11, help="bytes per second that all ranks write")
    parser.add_argument("--cells", type=float, default=1e9)
    parser.add_argument("--subdomains", type=int, nargs="+", default=[242, 4096, 32768])
    parser.add_argument("--division", type=float, default=5.3e-5, help="seconds of the division per triangle of the surface")
    parser.add_argument("--free-division", action="store_true", help="draw as well what it would be without that time")
    options = parser.parse_args()
    machine = Machine(options)
    if options.self_test:
        self_test(machine)
    if options.check:
        check([json.load(open(name)) for name in options.check], machine)
    if options.draw:
        draw_scaling(json.load(open(options.draw[0])), options.draw[1], machine, options)


if __name__ == "__main__":
    main()
