#!/usr/bin/env python3
"""A model of runs of mesh_surface_mpi with more ranks and cells than one has: events, one after the other.

usage: scaling_model.py --check REPORT...          compare the model with measured runs: reports of mesh_surface_mpi
       scaling_model.py --draw REPORT CHART.svg    10^9 tetrahedra on up to 1,024 ranks, from the times of a report
       scaling_model.py --self-test                cases whose result is known

The parameters of the machine are options, see --help. The run is the program's:
- rank 0 recovers the boundary of the surface and divides what it bounds; the others wait;
- in each round, each rank asks rank 0 for work, and gets the heaviest task that is left. Rank 0 answers one rank after
  the other, and works as well. A report or an answer takes the latency, and its bytes the bandwidth;
- what is told of all tasks is sent to all ranks, along a binary tree;
- between rounds, each rank looks for seams in its share of the parts, and all are told which vertices are shared;
- all that is read and written takes at least the time that the file system needs for it.
"""
import argparse
import heapq
import json
import math
import random

BYTES_OF_REPORT, BYTES_OF_ANSWER = 352, 8       # struct Task_report, and a number
BYTES_OF_SHARED_VERTEX = 16 + 3 * 8             # in a list of all, and then for each of three layers
GATHERINGS = 8                                  # of the ranks, between two rounds
CELLS_PER_VERTEX = 5.7
COARSENESS, CELLS_OF_BACKGROUND = 8, 1000       # of the mesh that is divided: see "Tuning constants" in the manual
PASSES = 5                                      # a task reads and writes its cells; a part is read twice, and written
PAPER_TRIANGLES, PAPER_CELLS = 2.3e6, 122.5e6   # Table 5 of the paper: how many triangles a surface has for the cells


class Machine:
    def __init__(self, options):
        self.latency, self.bandwidth = options.latency, options.bandwidth
        self.answer, self.disks = options.answer, options.file_system

    def message(self, size):
        return self.latency + size / self.bandwidth


class Round:
    """the seconds of each task, what they weigh, the bytes of their results; the seconds of all seams, for one rank"""
    def __init__(self, seconds, weights, sizes, seams=0., parts=1, shared=0.):
        self.order = sorted(range(len(seconds)), key=lambda i: -weights[i])  # the same as the program's: it is stable
        self.seconds, self.sizes, self.seams, self.parts, self.shared = seconds, sizes, seams, parts, shared

    def work(self, ranks, machine):
        """how long the tasks take, and the seconds that each rank worked"""
        todo = iter(self.order)
        busy, worked = 0., [0.] * ranks
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
            heapq.heappush(events, (time + self.seconds[task] + (machine.message(BYTES_OF_REPORT) if rank else 0.), rank))
        return end, worked

    def phases(self, ranks, machine):
        """seconds of the tasks, the seams, and the messages between rounds"""
        levels = math.ceil(math.log2(ranks)) if ranks > 1 else 0
        tasks = max(self.work(ranks, machine)[0], 2 * sum(self.sizes) / machine.disks)
        seams = max(self.seams / min(ranks, self.parts), (PASSES - 2) * sum(self.sizes) / machine.disks)
        told = BYTES_OF_REPORT * len(self.seconds) + BYTES_OF_SHARED_VERTEX * self.shared
        exchange = levels * GATHERINGS * 2 * machine.latency + (told / machine.bandwidth if ranks > 1 else 0.)
        return tasks, seams, exchange


class Run:
    def __init__(self, division, rounds):
        self.division, self.rounds = division, rounds

    def phases(self, ranks, machine):
        """seconds of the division, the tasks, the seams and the messages"""
        sums = [sum(p) for p in zip(*(r.phases(ranks, machine) for r in self.rounds))]
        return [self.division] + sums

    def imbalance(self, ranks, machine):
        """how much longer the tasks take than if all ranks worked all the time"""
        runs = [r.work(ranks, machine) for r in self.rounds]
        return sum(end for end, _ in runs) / (sum(sum(worked) for _, worked in runs) / ranks) - 1


def shared_vertices(cells, parts):
    """about how many vertices parts share, each counted once for each part: those of the surfaces of balls"""
    return parts * 4.84 * (cells / parts / CELLS_PER_VERTEX) ** (2. / 3)


def number_of_parts(report):
    return len(report["rounds"][0]["tasks"])


def run_of(report):
    parts = number_of_parts(report)
    shared = shared_vertices(report["number_of_tetrahedra"], parts)
    return Run(report["seconds_division"],
               [Round([t["seconds"] for t in r["tasks"]], [t["weight"] for t in r["tasks"]],
                      [t["bytes"] for t in r["tasks"]], r["seconds_seams"] * report["number_of_ranks"], parts, shared)
                for r in report["rounds"]])


def division(cells, number, options):
    """rank 0 recovers a surface with the triangles that the paper has for so many cells, and fills coarsely"""
    background = max(cells / COARSENESS ** 3, CELLS_OF_BACKGROUND * number)
    return options.division * PAPER_TRIANGLES * (cells / PAPER_CELLS) ** (2. / 3) + options.background * background


def larger_run(report, cells, number, seconds_of_division):
    """a run with a number of sub-domains of equal weight, whose times scatter as those of the report do"""
    chance = random.Random(1)
    parts, old_cells = number_of_parts(report), report["number_of_tetrahedra"]
    smaller = (old_cells / parts / (cells / number)) ** (1. / 3)  # seams are a smaller share of larger parts
    rounds = []
    for r in report["rounds"]:
        tasks = [t for t in r["tasks"] if t["tetrahedra"]]
        if not tasks:
            continue
        share = sum(t["tetrahedra"] for t in tasks) / old_cells
        if r["number_of_parts_that_meet"] != 1:
            share = min(1., share * smaller)
        n = max(1, min(round(len(tasks) / parts * number), 4 * number))  # of many small ones, some are taken together
        typical = [chance.choice(tasks) for _ in range(n)]
        scale = share * cells / sum(t["tetrahedra"] for t in typical)
        rounds.append(Round([scale * t["seconds"] for t in typical], [scale * t["weight"] for t in typical],
                            [scale * t["bytes"] for t in typical],
                            r["seconds_seams"] * report["number_of_ranks"] * cells / old_cells, number,
                            shared_vertices(cells, number)))
    return Run(seconds_of_division, rounds)


def check(reports, machine):
    """with the times of the tasks in each report, and with those of the first one"""
    first = run_of(reports[0])
    worst = 0.
    for report in reports:
        ranks = report["number_of_ranks"]
        measured = sum(r["seconds_tasks"] + r["seconds_seams"] for r in report["rounds"])
        for name, run in (("its own times", run_of(report)), ("times of the first", first)):
            foretold = sum(run.phases(ranks, machine)[1:])
            error = foretold / measured - 1
            print("%4d ranks, %s: meshing %.3f s, measured %.3f s (%+.1f %%); imbalance %.1f %%"
                  % (ranks, name, foretold, measured, 100 * error, 100 * run.imbalance(ranks, machine)))
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
    lines = ['<svg xmlns="http://www.w3.org/2000/svg" width="680" height="390" viewBox="0 0 680 390" font-family="sans-serif" font-size="12">',
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
        run = larger_run(report, options.cells, number, division(options.cells, number, options))
        alone = sum(run.phases(1, machine))
        print("%d sub-domains; one rank: %.0f s" % (number, alone))
        points = []
        for k in range(11):
            phases = run.phases(2 ** k, machine)
            points.append((2 ** k, alone / sum(phases)))
            print("%5d ranks: %9.1f s: division %.1f, tasks %.1f, seams %.1f, messages %.3f; speed-up %.1f, imbalance %.1f %%"
                  % (2 ** k, sum(phases), *phases, points[-1][1], 100 * run.imbalance(2 ** k, machine)))
        curves.append(("%s sub-domains" % format(number, ","), points))
    if options.free_division:
        run = larger_run(report, options.cells, options.subdomains[-1], 0.)
        alone = sum(run.phases(1, machine))
        curves.append(("the same, division free", [(2 ** k, alone / sum(run.phases(2 ** k, machine))) for k in range(11)]))
    draw(curves, format(int(options.cells), ","), path)


def self_test(machine):
    machine.latency = machine.answer = 0.
    machine.bandwidth = machine.disks = math.inf
    def tasks(seconds, ranks):
        return Round(seconds, seconds, [0] * len(seconds)).work(ranks, machine)[0]
    assert tasks([1., 2., 3.], 1) == 6 and tasks([1., 2., 3.], 2) == 3 and tasks([1., 2., 3.], 8) == 3
    assert tasks([3., 3., 2., 2., 2.], 2) == 7  # the heaviest first is not the best: that would be 6
    two = Run(5., [Round([1., 1.], [1., 1.], [0, 0], 4., 2), Round([3.], [1.], [0], 0., 2)])
    assert two.phases(1, machine) == [5., 5., 4., 0.] and two.phases(8, machine) == [5., 4., 2., 0.]
    assert two.imbalance(2, machine) == 4 / 2.5 - 1
    machine.disks = 2.
    assert Round([1.], [1.], [10], 1.).phases(1, machine) == (10., 15., 0.)
    machine.answer = 1.  # rank 0 answers at 1, 2 and 3; the work takes 10, and then all are told that there is no more
    assert Round([10.] * 4, [1.] * 4, [0] * 4).work(4, machine)[0] == 14
    machine.latency = .5
    assert Round([10.] * 2, [1.] * 2, [0] * 2).work(2, machine)[0] == .5 + 1 + .5 + 10 + .5 + 1 + .5
    print("done")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", nargs="+", metavar="REPORT")
    parser.add_argument("--draw", nargs=2, metavar=("REPORT", "CHART"))
    parser.add_argument("--self-test", action="store_true")
    parser.add_argument("--latency", type=float, default=2e-6, help="seconds that a message takes at least")
    parser.add_argument("--bandwidth", type=float, default=1e10, help="bytes per second of a message")
    parser.add_argument("--answer", type=float, default=1e-5, help="seconds that rank 0 takes for an answer")
    parser.add_argument("--file-system", type=float, default=1e11, help="bytes per second that all ranks read and write")
    parser.add_argument("--cells", type=float, default=1e9)
    parser.add_argument("--subdomains", type=int, nargs="+", default=[242, 4096, 32768])
    parser.add_argument("--division", type=float, default=1.5e-5, help="seconds of the division per triangle of the surface")
    parser.add_argument("--background", type=float, default=2e-6, help="seconds of the division per coarse cell")
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
