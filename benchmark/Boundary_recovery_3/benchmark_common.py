"""What the drivers robustness.py, quality.py, performance.py and meshing.py share: finding surfaces, running programs with limits,
and a file of records that a later run goes on with."""
import argparse
import concurrent.futures
import json
import os
import re
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAMS = os.path.join(ROOT, "build", "benchmark", "benchmark", "Boundary_recovery_3")
BUILD = ("  cmake -S %s -B %s -DBUILD_TESTING=OFF -DBR3_BUILD_BENCHMARK=ON && cmake --build %s --target benchmark_recovery\n"
         "  cmake --build %s --target benchmark_tetgen   # where TetGen's library is")
CGAL_DEMO_DATA = os.path.join(ROOT, "build", "cgal_demo_meshes")  # see get_cgal_demo_data
RESULTS = os.path.join(ROOT, "build", "benchmark_results")
FORMATS = (".off", ".ply", ".stl", ".obj")


def parser_of(doc, timeout):
    parser = argparse.ArgumentParser(description=doc.splitlines()[0])
    parser.add_argument("places", nargs="*", metavar="FOLDER_OR_FILE",
                        help="surfaces: .off .ply .stl .obj; default: data/meshes, and what get_cgal_demo_data has unpacked")
    parser.add_argument("--out", default=RESULTS, metavar="FOLDER", help="for the figures; build/benchmark_results")
    parser.add_argument("--fresh", action="store_true", help="forget what an earlier run has left in the folder")
    parser.add_argument("--timeout", type=float, default=timeout,
                        help="seconds after which a program is stopped, default %(default)g")
    parser.add_argument("--max-triangles", type=int, default=None, help="leave larger surfaces out")
    parser.add_argument("--programs", default=PROGRAMS, metavar="FOLDER", help="where the compiled benchmarks are")
    return parser


def surfaces_of(arguments):
    """the files, small ones first"""
    places = list(arguments.places)
    if not places:
        places = [os.path.join(ROOT, "data", "meshes")]
        if os.path.isdir(CGAL_DEMO_DATA):
            places.append(CGAL_DEMO_DATA)
        else:
            print("only data/meshes is run: get_cgal_demo_data beside this script brings CGAL's surfaces", file=sys.stderr)
    files = []
    for place in places:
        if os.path.isdir(place):
            files += [os.path.join(place, name) for name in os.listdir(place) if name.lower().endswith(FORMATS)]
        elif os.path.isfile(place):
            files.append(place)
        else:
            sys.exit("no such file: " + place)
    return sorted(set(files), key=lambda file: (os.path.getsize(file), file))


def model_of(file):
    return os.path.splitext(os.path.basename(file))[0]


def run(command, timeout):
    """runs a program; returns its exit status (negative: signal; None: stopped at the timeout), output and errors"""
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        start = time.monotonic()
        child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out, stderr=err)
        try:
            status = child.wait(timeout)
        except subprocess.TimeoutExpired:
            child.kill()
            child.wait()
            status = None
        seconds = time.monotonic() - start
        out.seek(0)
        err.seek(0)
        return status, out.read().decode("utf-8", "replace"), err.read().decode("utf-8", "replace"), seconds


class Programs:
    def __init__(self, arguments):
        self.timeout = arguments.timeout
        self.recovery = os.path.join(arguments.programs, "benchmark_recovery")
        self.tetgen = os.path.join(arguments.programs, "benchmark_tetgen")
        self.angles = os.path.join(arguments.programs, "benchmark_angles")
        if not os.access(self.recovery, os.X_OK):
            folder = os.path.join(ROOT, "build", "benchmark")
            sys.exit("there is no %s; build it:\n%s" % (self.recovery, BUILD % (ROOT, folder, folder, folder)))
        self.has_tetgen = os.access(self.tetgen, os.X_OK)
        if not self.has_tetgen:
            print("TetGen is skipped: there is no " + self.tetgen, file=sys.stderr)

    def recover(self, file, *options, limit=None):
        """our figures; `outcome` is the status of the result, or why there is none"""
        command = [self.recovery, file] + list(options)
        if limit is not None:
            command += ["--time-limit", str(limit)]
        status, output, errors, seconds = run(command, self.timeout)
        if status == 0:
            result = json.loads(output)
            result["outcome"] = result["status"]
        else:
            result = {"outcome": {None: "timeout", 1: "unreadable"}.get(status, "crash"),
                      "note": ((errors.strip().splitlines() or [""])[-1] + " (status %s)" % status)}
        result["wall_seconds"] = seconds
        return result

    def mesh_by_tetgen(self, surface, switches, ours, *size):
        """TetGen's figures, with the seconds of its steps; a surface that bounds nothing is meshed in its hull by both"""
        if ours.get("domain_is_hull"):
            switches += "c"
        if not self.has_tetgen:
            return {"outcome": "skipped"}
        status, output, errors, seconds = run([self.tetgen, switches + "V", surface, *size], self.timeout)
        if status != 0:
            return {"outcome": "timeout" if status is None else "error", "wall_seconds": seconds,
                    "note": (errors.strip().splitlines() or [""])[-1]}
        result = json.loads(output.strip().splitlines()[-1])
        steps = {}
        for name, number in re.findall(r"^ *([A-Z][A-Za-z ]+?) seconds:\s+([0-9.eE+-]+)", output, re.M):
            steps[name] = float(number)
        kept = "Y" not in switches or result["split_triangles"] == 0
        result.update(outcome="ok" if kept else "split", wall_seconds=seconds, steps=steps)
        recovery = steps.get("Boundary recovery", steps.get("Constrained Delaunay", 0.0))
        result["phases_seconds"] = recovery + steps.get("Steiner suppression", 0.0)
        # ours, too, has the checks of the input and the tables of the constraints
        result["recovery_seconds"] = steps.get("Surface mesh", 0.0) + result["phases_seconds"]
        result["total_seconds"] = steps.get("Delaunay", 0.0) + result["recovery_seconds"]
        return result


class Records:
    """One record a line, in a file that grows as the figures come; those of an earlier run are not measured again."""

    def __init__(self, arguments, name, keys):
        os.makedirs(arguments.out, exist_ok=True)
        self.path, self.keys = os.path.join(arguments.out, name), keys
        if arguments.fresh and os.path.exists(self.path):
            os.remove(self.path)
        self.rows = read_records(self.path)
        self.known = {self.key(row) for row in self.rows}

    def key(self, row):
        return tuple(row[k] for k in self.keys)

    def has(self, **row):
        return self.key(row) in self.known

    def add(self, row):
        self.rows.append(row)
        self.known.add(self.key(row))
        with open(self.path, "a", encoding="utf-8") as file:
            file.write(json.dumps(row) + "\n")

    def measure(self, jobs, function, tasks, describe):
        """adds what the function returns for each task, so many at a time, in the order of the tasks"""
        with concurrent.futures.ThreadPoolExecutor(max(1, jobs)) as pool:
            for row in pool.map(function, tasks):
                self.add(row)
                print(describe(row), file=sys.stderr, flush=True)


def read_records(path):
    if not os.path.exists(path):
        return []
    rows = []
    with open(path, encoding="utf-8") as file:
        for line in file:
            try:
                rows.append(json.loads(line))
            except ValueError:
                pass  # the last line of a run that was killed
    return rows


def triangles_of(file):
    """from the header of an OFF file, else estimated from the size"""
    if file.lower().endswith(".off"):
        with open(file, encoding="utf-8", errors="replace") as lines:
            words = []
            for line in lines:
                words += line.split("#")[0].split()
                if len(words) >= 3:
                    break
        numbers = [w for w in words if w.isdigit()]
        if len(numbers) >= 2:
            return int(numbers[1])
    return os.path.getsize(file) // 50


def wanted(arguments, files):
    if arguments.max_triangles is None:
        return files
    return [file for file in files if triangles_of(file) <= arguments.max_triangles]
