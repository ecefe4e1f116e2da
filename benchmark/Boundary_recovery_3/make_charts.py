#!/usr/bin/env python3
"""Makes the charts and tables of the manual from what robustness.py, quality.py and performance.py have measured.

The tables have the columns of Tables 1 to 3 of the paper [CZZ+17], with other models. They are written into the folder of
the results, in Markdown and HTML. Charts need gnuplot (Debian: gnuplot-nox). README.md in this folder tells more.
"""
import argparse
import collections
import html
import os
import shutil
import subprocess
import sys

from benchmark_common import RESULTS, read_records
from performance import exponent, geometric_mean, ratios
from quality import domain_points
from robustness import GOOD, KERNELS, MODES

TABLE_3 = ("boeing_part_cgal", "boeing", "boeing_part_cdt", "rotor", "cgal_rotor")
COLORS = ("#2e6da4", "#c0392b", "#7f8c2b", "#555555")


class Table:
    def __init__(self, title, header, rows):
        self.title, self.header, self.rows = title, [str(x) for x in header], [[text(x) for x in row] for row in rows]

    def markdown(self):
        lines = ["**%s**" % self.title, "", "| %s |" % " | ".join(self.header),
                 "|---|" + (len(self.header) - 1) * "---:|"]
        return "\n".join(lines + ["| %s |" % " | ".join(row) for row in self.rows]) + "\n"

    def html(self):
        def line(tag, cells):
            return "<tr>%s</tr>" % "".join(
                "<%s%s>%s</%s>" % (tag, ' align="right"' if i else "", html.escape(c, quote=False), tag) for i, c in enumerate(cells))
        return "\n".join(["<b>%s</b>" % html.escape(self.title, quote=False), '<table border="1" cellspacing="0" cellpadding="3">',
                          line("th", self.header)] + [line("td", row) for row in self.rows] + ["</table>"]) + "\n"


def text(x):
    if not isinstance(x, float):
        return str(x)
    return "%.0f" % x if x >= 100 else "%.3g" % x if x >= 0.001 else "%.1e" % x if x > 0 else "0"


def table_of_robustness(rows):
    lines = []
    for mode in MODES:
        for kernel in KERNELS:
            some = [r for r in rows if (r["mode"], r["kernel"]) == (mode, kernel)]
            n = collections.Counter(r["outcome"] for r in some)
            v = collections.Counter(r["verdict"] for r in some if "verdict" in r)
            if some:
                lines.append([mode, kernel.capitalize(), len(some), n["invalid_input"] + n["unreadable"], n["recovered"],
                              n["incomplete"], n["stopped"] + n["timeout"], n["crash"], v["exact"], v["rounded"],
                              sum(v[k] for k in v if k not in GOOD)])
    return Table("Every surface in every mode, judged by the exact checker",
                 ["Mode", "Kernel", "Surfaces", "Refused", "Recovered", "Incomplete", "Out of time", "Crash",
                  "Judged exact", "Judged exact up to rounding", "Judged wrong"], lines)


def points_of(row):
    """ours, with those outside of the domain in parentheses, and TetGen's"""
    ours, theirs = row["ours"], row["tetgen"]
    mine = "-"
    if ours["outcome"] == "recovered":
        mine = "%d" % domain_points(ours)
        if ours["steiner_points_outside"]:
            mine += " (+%d)" % ours["steiner_points_outside"]
    else:
        mine = ours["outcome"]
    return mine, theirs["points"] if theirs["outcome"] == "ok" else "Fail" if theirs["outcome"] != "skipped" else "-"


def models_of_table_1(quality, limit):
    """those where somebody needs points, the larger ones first; the same in Table 2"""
    some = [r for r in quality if r["mode"] == "constrained" and r["ours"]["outcome"] not in ("unreadable", "invalid_input")]

    def interest(row):
        ours, theirs = row["ours"], row["tetgen"]
        return max(ours.get("constraint_points", 0), theirs.get("points", 0),
                   1 if ours["outcome"] != "recovered" or theirs["outcome"] not in ("ok", "skipped") else 0)
    some = [r for r in some if interest(r) > 0]
    some.sort(key=lambda r: (-interest(r), r["model"]))
    return sorted(some[:limit], key=lambda r: r["ours"].get("facets", 0))


def table_1(models):
    return Table("Table 1. Steiner points inserted in constrained boundary recovery; in parentheses, those outside of the domain",
                 ["Examples", "Boundary faces", "Boundary nodes", "Our algorithm", "TetGen 1.5"],
                 [[r["model"], r["ours"].get("facets", "-"), r["ours"].get("vertices", "-")] + list(points_of(r))
                  for r in models])


def table_2(models, performance):
    by_name = {r["model"]: r for r in performance if r["family"] == ""}
    found = [by_name[r["model"]] for r in models if r["model"] in by_name]

    def seconds(result):
        return result["recovery_seconds"] if result["outcome"] in ("ok", "recovered") else "Fail"
    return Table("Table 2. Timing data of boundary recovery with suppression (unit: second)",
                 ["Algorithms"] + [r["model"] for r in found],
                 [["Our algorithm"] + [seconds(r["ours"]) for r in found],
                  ["TetGen 1.5"] + [seconds(r["tetgen"]) for r in found]])


def table_3(row):
    """n1 to n4 by recursion level, for both callings on edges"""
    levels = [x for x in row["ours"].get("levels", []) if x["phase"].startswith("edge_recovery")]
    columns = sorted({x["level"] for x in levels})
    lines = []
    for phase, name in (("edge_recovery_brc1", "1st calling"), ("edge_recovery_brc3", "2nd calling")):
        by_level = {x["level"]: x for x in levels if x["phase"] == phase}
        for n in ("n1", "n2", "n3", "n4") if phase.endswith("3") else ("n1", "n2", "n3"):
            if by_level:
                lines.append(["%s: %s" % (name, n)] + [by_level[c][n] if c in by_level else "" for c in columns])
    return Table("Table 3. The mesh indices in the main loops of edge recovery: %s" % row["model"],
                 ["Maximal recursion level"] + columns, lines)


def tables_of_growth(performance):
    for family in sorted({r["family"] for r in performance} - {""}):
        some = sorted((r for r in performance if r["family"] == family), key=lambda r: r["ours"].get("facets", 0))
        some = [r for r in some if r["ours"]["outcome"] == "recovered"]
        keys = ("insertion_seconds", "shell_transformations", "recovery_seconds", "peak_memory_mb")
        lines = [[r["ours"]["facets"]] + [r["ours"][k] for k in keys]
                 + [float(r["tetgen"][k]) if r["tetgen"]["outcome"] == "ok" else "-"
                    for k in ("recovery_seconds", "peak_memory_mb")] for r in some]
        if len(some) > 1:
            good = [r for r in some if r["tetgen"]["outcome"] == "ok"]
            lines.append(["exponent"] + ["%.2f" % exponent([(r["ours"]["facets"], r["ours"][k]) for r in some]) for k in keys]
                         + ["%.2f" % exponent([(r["ours"]["facets"], r["tetgen"][k]) for r in good]) if len(good) > 1 else "-"
                            for k in ("recovery_seconds", "peak_memory_mb")])
        yield Table("Growth of the family %s" % family,
                    ["Triangles", "Insertion, s", "Shell transformations", "Recovery, s", "Memory, MB",
                     "TetGen: recovery, s", "TetGen: memory, MB"],
                    lines)


def table_of_ratios(performance, quality):
    pairs = list(ratios([r for r in performance if r["family"] == ""]))
    long = [p for p in pairs if p[0]["tetgen"]["recovery_seconds"] >= 0.01]
    lines = [[name] + [geometric_mean([p[i] for p in some]) if some else "-" for i in (1, 2, 3)] + [len(some)]
             for name, some in (("all surfaces", pairs), ("TetGen's recovery takes 0.01 s or more", long))]
    return Table("Ours / TetGen 1.5 -pY, geometric means of pairwise ratios",
                 ["Surfaces", "Recovery", "Delaunay and recovery", "Peak memory", "Number"], lines)


def table_of_quality(quality):
    lines = []
    for mode, switches in (("constrained", "-pY"), ("conforming", "-p")):
        both = [r for r in quality if r["mode"] == mode and r["ours"]["outcome"] == "recovered" and r["tetgen"]["outcome"] == "ok"]
        for name, who, prefix in (("Ours, " + mode, "ours", "steiner_points_"), ("TetGen 1.5 " + switches, "tetgen", "points_")):
            angles = [sorted(r[who]["smallest_angle"] for r in both), sorted(180 - r[who]["largest_angle"] for r in both)]
            lines.append([name, len(both)] + [sum(r[who][prefix + kind] for r in both)
                                              for kind in ("inside", "on_edges", "on_facets")]
                         + [sum(r[who].get("steiner_points_outside", 0) for r in both)]
                         + [float(a[len(a) // 2]) if a else "-" for a in angles])
    return Table("Steiner points by kind and dihedral angles, on the surfaces where both succeed",
                 ["Program", "Surfaces", "In the domain", "On edges", "On facets", "Outside", "Smallest angle, median",
                  "180 - largest angle, median"], lines)


def gnuplot(folder, name, title, commands, data, width=620):
    """draws one chart; `data` are blocks that the commands name as $NAME"""
    lines = ["set encoding utf8", "set terminal svg size %d,400 font 'DejaVu Sans,13' background '#ffffff'" % width,
             "set output '%s'" % os.path.join(folder, name + ".svg"), "set title '%s'" % title, "set border 3",
             "set tics nomirror", 'set datafile separator "\t"', "set grid linecolor '#dddddd'"]
    for block, rows in data.items():
        lines += ["$%s << EOD" % block] + ["\t".join(str(x) for x in row) for row in rows] + ["EOD"]
    done = subprocess.run(["gnuplot"], input="\n".join(lines + commands) + "\n", text=True, check=False,
                          stderr=subprocess.PIPE)
    if done.returncode != 0:  # what else it says is about ranges, where there is but one point
        sys.exit("gnuplot: " + done.stderr)
    normalize(os.path.join(folder, name + ".svg"))


def normalize(path):
    """neither blanks at line ends nor tabs"""
    with open(path, encoding="utf-8") as file:
        lines = [line.replace("\t", " ").rstrip() for line in file.read().splitlines()]
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(line for line in lines if line) + "\n")


LOG = ["set logscale xy", "set format xy '10^{%L}'", "set key left top"]


def chart_times(folder, performance):
    points = [("%.6g" % r["tetgen"]["recovery_seconds"], "%.6g" % r["ours"]["recovery_seconds"])
              for r, *_ in ratios([r for r in performance if r["family"] == ""]) if r["tetgen"]["recovery_seconds"] > 0]
    if points:
        gnuplot(folder, "benchmark_times", "Recovery of a surface",
                LOG + ["set xlabel 'TetGen 1.5 -pY, seconds'", "set ylabel 'recover\\_boundary(), seconds'",
                       "plot x title 'equal' lc rgb '#888888', 3*x title '3 times' dt 2 lc rgb '#888888', "
                       "$points using 1:2 with points pt 7 ps 0.4 lc rgb '%s' notitle" % COLORS[0]], {"points": points})


def chart_growth(folder, performance):
    plots, data = [], {}
    for family, dash in zip(sorted({r["family"] for r in performance} - {""}), (1, 2, 4)):
        some = sorted((r for r in performance if r["family"] == family and r["ours"]["outcome"] == "recovered"),
                      key=lambda r: r["ours"]["facets"])
        for i, (name, who, key) in enumerate((("recovery", "ours", "recovery_seconds"),
                                              ("Delaunay insertion", "ours", "insertion_seconds"),
                                              ("TetGen 1.5, recovery", "tetgen", "recovery_seconds"))):
            rows = [(r["ours"]["facets"], "%.6g" % r[who][key]) for r in some if key in r[who]]
            if rows:
                data["%s%d" % (family, i)] = rows
                plots.append("$%s%d using 1:2 with linespoints pt 7 ps 0.4 dt %d lc rgb '%s' title '%s: %s'"
                             % (family, i, dash, COLORS[i], family, name))
    if plots:
        gnuplot(folder, "benchmark_growth", "One shape refined",
                LOG + ["set key outside right center", "set xlabel 'triangles'", "set ylabel 'seconds'", "plot " + ", ".join(plots)], data, width=800)


def chart_points(folder, quality):
    both = [r for r in quality if r["mode"] == "constrained" and r["ours"]["outcome"] == "recovered"
            and r["tetgen"]["outcome"] == "ok"]
    classes = [(1, 1), (2, 2), (3, 4), (5, 8), (9, 16), (17, 32), (33, 10**9)]
    if both:
        rows = []
        for low, high in classes:
            name = str(low) if low == high else "%d-%d" % (low, high) if high < 10**9 else "more"
            rows.append([name, sum(low <= domain_points(r["ours"]) <= high for r in both),
                         sum(low <= r["tetgen"]["points"] <= high for r in both)])
        none = [sum(domain_points(r["ours"]) == 0 for r in both), sum(r["tetgen"]["points"] == 0 for r in both)]
        gnuplot(folder, "benchmark_points", "Surfaces that need Steiner points in the domain",
                ["set style data histogram", "set style histogram clustered gap 1", "set style fill solid 0.9 border -1",
                 "set xlabel 'Steiner points'", "set ylabel 'surfaces'", "set yrange [0:*]", "set key above",
                 "plot $rows using 2:xtic(1) lc rgb '%s' title 'recover\\_boundary(); none: %d', "
                 "$rows using 3 lc rgb '%s' title 'TetGen 1.5 -pY; none: %d'" % (COLORS[0], none[0], COLORS[1], none[1])],
                {"rows": rows})


def chart_phases(folder, performance):
    totals = collections.OrderedDict()
    for r in performance:
        if r["family"] == "" and r["ours"]["outcome"] == "recovered":
            for phase in r["ours"]["phases"]:
                totals[phase["phase"]] = totals.get(phase["phase"], 0) + phase["seconds"]
    if totals:
        totals["recount"] = totals.pop("recount", 0)  # it runs after the flips, too; shown in the end
        rows = [(name.replace("_", " ").replace("brc", "BRC"), "%.6g" % seconds) for name, seconds in totals.items()]
        gnuplot(folder, "benchmark_phases", "Seconds per phase, sum over the surfaces",
                ["set style data histogram", "set style fill solid 0.9 border -1", "set style histogram clustered gap 0.3", "unset key",
                 "set xtics rotate by -35", "set rmargin 8", "set yrange [0:*]",
                 "plot $rows using 2:xtic(1) lc rgb '%s'" % COLORS[0]], {"rows": rows})


def write_into_manual(path, tables):
    """replaces what is between the comments BENCHMARK_TABLE name and END_OF_BENCHMARK_TABLE"""
    with open(path, encoding="utf-8") as file:
        manual = file.read()
    end = "<!-- END_OF_BENCHMARK_TABLE -->"
    for name, table in tables.items():
        start = "<!-- BENCHMARK_TABLE %s -->\n" % name
        if start in manual:
            head, rest = manual.split(start, 1)
            manual = head + start + table.html() + end + rest.split(end, 1)[1]
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        file.write(manual)


def tables_of(robustness, quality, performance, models_for_table_3, limit):
    tables = collections.OrderedDict()
    if robustness:
        tables["robustness"] = table_of_robustness(robustness)
    if quality:
        models = models_of_table_1(quality, limit)
        tables["quality"] = table_of_quality(quality)
        tables["1"] = table_1(models)
        if performance:
            tables["2"] = table_2(models[-8:], performance)
        by_name = {r["model"]: r for r in quality if r["mode"] == "constrained"}
        found = [by_name[name] for name in models_for_table_3 if name in by_name and by_name[name]["ours"].get("levels")]
        for i, row in enumerate(found[:2]):
            tables["3" + "ab"[i]] = table_3(row)
    if performance:
        tables["ratios"] = table_of_ratios(performance, quality)
        for table in tables_of_growth(performance):
            tables[table.title.split()[-1]] = table
    return tables


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results", nargs="?", default=RESULTS,
                        help="the folder that the drivers got as --out; default: theirs, build/benchmark_results")
    parser.add_argument("--figures", metavar="FOLDER", help="for the charts; default: the folder of the results")
    parser.add_argument("--manual", metavar="FILE", help="put the tables between the comments there that name them")
    parser.add_argument("--tables-only", action="store_true", help="no charts, so no gnuplot")
    parser.add_argument("--table-3", nargs="+", default=TABLE_3, metavar="MODEL", help="the first two that were measured")
    parser.add_argument("--rows", type=int, default=16, help="most rows of Table 1, default 16")
    arguments = parser.parse_args()
    names = ("robustness", "quality", "performance")
    records = [read_records(os.path.join(arguments.results, name + ".jsonl")) for name in names]
    if not any(records):
        sys.exit("make_charts.py: nothing was measured in " + arguments.results)
    tables = tables_of(*records, arguments.table_3, arguments.rows)
    with open(os.path.join(arguments.results, "tables.md"), "w", encoding="utf-8") as file:
        file.write("\n".join(table.markdown() for table in tables.values()))
    with open(os.path.join(arguments.results, "tables.html"), "w", encoding="utf-8") as file:
        file.write("\n".join(table.html() for table in tables.values()))
    if arguments.manual:
        write_into_manual(arguments.manual, tables)
    if arguments.tables_only:
        return
    if not shutil.which("gnuplot"):
        sys.exit("make_charts.py: the charts need gnuplot (Debian: gnuplot-nox); the tables are written")
    folder = arguments.figures or arguments.results
    _, quality, performance = records
    chart_times(folder, performance)
    chart_growth(folder, performance)
    chart_points(folder, quality)
    chart_phases(folder, performance)


if __name__ == "__main__":
    main()
