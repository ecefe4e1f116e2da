#!/usr/bin/env python3
"""Checks the files of the package as CGAL's continuous integration would, and our own rules.

usage: check_conventions.py ROOT
       check_conventions.py --self-test ROOT   as if the package were broken, in many ways; each must be noticed
"""
import functools
import os
import re
import sys

PACKAGE = "Boundary_recovery_3"
TEXT = {".h", ".cpp", ".txt", ".cmake", ".md", ".py", ".sh", ".in", ".off", ".cmd", ".bib", ".svg", ""}
SKIPPED_FOLDERS = {".git", "build", "__pycache__"}
# The floors of the house, from the top: folders below include/CGAL/Boundary_recovery_3/internal/, and between them the
# public headers. Each may include what stands above it, and folders also themselves, but not in a circle.
FLOORS = [
    "license/Boundary_recovery_3.h",
    "Boundary_recovery_3/enumerations.h",
    "Boundary_recovery_3/Boundary_recovery_result_3.h",
    "Boundary_recovery_3/Quality_improvement_result_3.h",
    "Boundary_recovery_3/Boundary_constrained_mesh_result_3.h",
    "Boundary_constrained_mesh_triangulation_3.h",
    "Boundary_recovery_3/Meshing_visitor_3.h",
    "Boundary_recovery_3/parameters.h",
    "Boundary_recovery_3/Shell_3.h",
    "util",         # ranges, hashing, bits, the context of a run
    "numbers",      # exact numbers, and floating point numbers near them
    "shape",        # coordinates, circumspheres, distances, angles of tetrahedra, boxes
    "mesh",         # simplices of cells, constraints, replacement of cells and its undo, walls and regions
    "Boundary_recovery_3/Mesh_indices_keeper_3.h",
    "Boundary_recovery_3/label_regions.h",
    "Boundary_recovery_3/number_edge_nodes.h",
    "Boundary_recovery_3/write_domain_MEDIT.h",
    "mark_domain.h",
    "Boundary_recovery_3/Constrained_edge_map_3.h",
    "Boundary_recovery_3/convert_to_remeshing_triangulation.h",
    "geometry",     # exact positions, predicates of vertices, visibility, walks
    "Boundary_recovery_3/Shell_quality_3.h",
    "Boundary_recovery_3/Shell_validity_3.h",
    "shell",        # search for covering meshes
    "Shell_transformation_3.h",
    "cavity",       # cavities and their reconnection
    "operations",   # one kind of local operations in each file
    "lost",         # search for lost constraints, and their recovery without points [CZZ+17, Section 4.2]
    "steiner",      # Steiner points [CZZ+17, Sections 4.1 and 4.3, Appendix]
    "Constrained_boundary_recovery_3.h",
    "input",        # the caller's input, and what is wrong with it
    "recover_boundary.h",
    "Boundary_recovery_3/Background_mesh_3.h",
    "Boundary_recovery_3/Size_source_3.h",
    "sizing",       # size fields, what is asked of them, whose size a vertex has
    "Boundary_recovery_3/Surface_sizing_field_3.h",
    "Boundary_recovery_3/Source_sizing_field_3.h",
    "Boundary_recovery_3/Background_mesh_sizing_field_3.h",
    "Boundary_recovery_3/Combined_sizing_fields_3.h",
    "owners",       # which thread may change what, and the rounds of the parts that they work on
    "filling",      # field points [CZZ+17, Section 4.1, step 6]
    "insert_field_points.h",
    "Boundary_recovery_3/Cell_quality_3.h",
    "quality",      # angles of cells, their improvement, and what is to be said about those that stay bad
    "Boundary_recovery_3/mesh_quality.h",
    "improve_mesh_quality.h",
    "parallel",     # sub-domains that are filled and improved at the same time
    "meshing",      # all steps, one after the other
    "make_boundary_constrained_mesh_3.h",
    "Boundary_recovery_3/Hole_remeshing_result_3.h",
    "holes",        # meshes that were moved, given by arrays: cavities, and sewing
    "remesh_holes.h",
    "remesh_cells.h",
]
# Internal headers that no file of test/ has to include, by their path below include/CGAL, with the reason.
UNTESTED_HEADERS = {}
# The pages of the manual for developers; where the files are that they name; the floors of which they name each header.
DEVELOPER_PAGES = ["doc/%s/Developers_%s.txt" % (PACKAGE, name) for name in ("code", "method", "constants", "benchmarks")]
FOLDERS_OF_DEVELOPER_PAGES = ["include/CGAL/", "include/CGAL/%s/internal/" % PACKAGE, "test/%s/" % PACKAGE,
                              "test/%s/oracles/" % PACKAGE, "benchmark/%s/" % PACKAGE, "doc/%s/fig/" % PACKAGE, ""]
LISTED_FLOORS = ["shell", "operations", "lost", "steiner"]
# The manual for users: as many words as somebody reads, and a picture at the top of each page.
PAGES_FOR_USERS = ["doc/%s/%s.txt" % (PACKAGE, name) for name in
                   (PACKAGE, "meshing", "names_and_files", "sizes", "quality", "guarantees", "recovery", "moving_bodies",
                    "parallel", "python")]
MAX_NUMBER_OF_WORDS = 9000
FORBIDDEN_IN_LINES = {
    r"\t": "tab",
    r"[^\S\n]$": "trailing blank",
    r"^.{121}": "more than 120 columns",
}
FORBIDDEN_IN_HEADERS = {
    r"\bstd::(cout|cerr|clog)\b|\b(printf|fprintf|puts)\s*\(": "prints",
    r"\b(exit|abort|_Exit|quick_exit|terminate)\s*\(": "ends the program",
    r"(?<![\w:])assert\s*\(": "uses assert instead of CGAL's macros",
    r"\bNULL\b": "uses NULL",
    r"\busing\s+namespace\b": "imports a namespace",
}


def files_of(root):
    for folder, folders, names in os.walk(root):
        folders[:] = sorted(f for f in folders if f not in SKIPPED_FOLDERS)
        for name in sorted(names):
            yield os.path.relpath(os.path.join(folder, name), root)


@functools.lru_cache(maxsize=None)
def read(root, path):
    with open(os.path.join(root, path), encoding="utf-8", newline="") as file:
        return file.read()


@functools.lru_cache(maxsize=None)
def without_comments_and_strings(code):
    return re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', " ", code, flags=re.S)


def in_backticks(text):
    return re.findall(r"`([^`\n]+)`", text)


def is_file_name(name):
    """Whether a name in the pages for developers is that of a file or folder."""
    return re.fullmatch(r"[\w./]+\.(h|cpp|py|svg|md)|[\w.]+/|scripts/\w+", name) is not None


def rows_of_tables(page):
    """The rows of all tables in Markdown, each with the header of its table, as lists of cells."""
    header = None
    for line in page.split("\n"):
        if not line.startswith("|"):
            header = None
            continue
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if header is None:
            header = cells
        elif not set(line) <= set("|-: "):
            yield header, cells


def constants_of(code):
    """The names of the constants of a header that are numbers, or lists of such."""
    found = re.findall(r"\bconstexpr (?:int|double|(?:std::)?(?:size_t|ptrdiff_t|array<[^>]*>)|[\w: ]*Bounds)\s+(\w+)(?:\[\])?\s*=\s*([^;]+);", code)
    return [name for name, value in found if re.match(r"[1-9{]|N ==", value)]


def floor(name):
    """The position in FLOORS of a header, given by its path below include/CGAL, or None."""
    internal = re.fullmatch(r"%s/internal/(\w+)/\w+\.h" % PACKAGE, name)
    entry = internal.group(1) if internal else name
    return FLOORS.index(entry) if entry in FLOORS else None


class Checker:
    def __init__(self, root, changes=()):
        """As if files had the texts of the dictionary `changes`, or were not there if it has None; then only these are
        checked by themselves."""
        self.root, self.changes, self.complaints = root, dict(changes), []
        paths = set(files_of(root)) | self.changes.keys()
        self.paths = sorted(path for path in paths if self.changes.get(path, "") is not None)

    def read(self, path):
        return self.changes[path] if path in self.changes else read(self.root, path)

    def require(self, condition, path, text):
        if not condition:
            self.complaints.append("%s: %s" % (path, text))

    def check_all(self):
        changed = [path for path in self.paths if path in self.changes or not self.changes]
        for path in changed:
            self.check_text(path)
        headers = [p for p in self.paths if p.startswith("include/")]
        self.require(headers, "include", "no header")
        for path in headers:
            if path in changed:
                self.check_header(path)
        self.check_floors(headers)
        self.check_tested(headers)
        self.check_unique_names()
        self.check_programs()
        self.check_package_info()
        self.check_readme()
        self.check_pages_for_users()
        self.check_developer_pages(headers)
        self.check_sizes()
        return self.complaints

    def check_text(self, path):
        if os.path.splitext(path)[1] not in TEXT or path.endswith((".png", ".jpg")):
            return
        try:
            text = self.read(path)
        except UnicodeDecodeError:
            self.require(False, path, "not UTF-8")
            return
        if path == "LICENSE":
            return  # as the Free Software Foundation wrote it
        self.require(not text or text.endswith("\n"), path, "no newline at the end")
        self.require("\r" not in text, path, "carriage return")
        for pattern, what in FORBIDDEN_IN_LINES.items():
            if "columns" not in what or path.endswith((".h", ".cpp")):
                for found in re.finditer(pattern, text, re.M):
                    self.require(False, "%s:%d" % (path, text.count("\n", 0, found.start()) + 1), what)
        script = text.startswith("#!")
        executable = os.access(os.path.join(self.root, path), os.X_OK)
        self.require(script or not executable, path, "executable, but no script")

    def check_header(self, path):
        text = self.read(path)
        heading = text.split("#ifndef")[0]
        for item in ("// Copyright (c) ", "// $URL$", "// $Id$", "// SPDX-License-Identifier: GPL-3.0-or-later",
                     "// Author(s)     : "):
            self.require("\n" + item in "\n" + heading, path, "no '%s' in the heading" % item)

        # CGAL_FILE_NAME_H, or the same with folders before the file's name
        parts = path[len("include/CGAL/"):].split("/")
        tails = {"/".join(parts[i:]) for i in range(len(parts))}
        names = {"CGAL_" + re.sub(r"\W", "_", tail).upper() for tail in tails}
        guard = re.search(r"^#ifndef (\w+)\n#define (\w+)\n", text, re.M)
        self.require(guard and guard.group(1) == guard.group(2) and guard.group(1) in names, path,
                     "the include guard is not named after the file")
        if guard:
            self.require(text.endswith("\n#endif // %s\n" % guard.group(1)), path, "the #endif does not name the guard")

        code = without_comments_and_strings(text)
        if not path.startswith("include/CGAL/license/"):
            first = re.search(r"^#include .*$", text, re.M)
            self.require(first and first.group(0) == "#include <CGAL/license/%s.h>" % PACKAGE, path,
                         "the first include is not the one of the licence")
        for pattern, what in FORBIDDEN_IN_HEADERS.items():
            self.require(not re.search(pattern, code), path, what)
        for include in re.findall(r'^#include "(.*)"', text, re.M):
            self.require(False, path, 'includes "%s" with quotes' % include)
        internal = "/internal/" in path
        self.require(not internal or re.search(r"namespace (\w+::)*internal\b", code), path, "not in a namespace internal")

    def check_floors(self, headers):
        """Headers include only what stands above them in FLOORS."""
        includes = {}
        for path in headers:
            name = path[len("include/CGAL/"):]
            self.require(floor(name) is not None, path, "is on none of the floors")
            found = re.findall(r"^#include <CGAL/([^>]+)>", self.read(path), re.M)
            includes[name] = [i for i in found if "include/CGAL/" + i in self.paths]
        for name, included in includes.items():
            for other in included:
                if floor(name) is not None and floor(other) is not None:
                    self.require(floor(other) <= floor(name), "include/CGAL/" + name, "includes %s, which is on a lower floor" % other)
        for name in includes:
            self.require(not self.is_in_circle(name, includes), "include/CGAL/" + name, "includes itself in a circle")

    def check_tested(self, headers):
        """Each internal header is included by a test of its subject, and not only by other headers."""
        tests = [p for p in self.paths if p.startswith("test/") and p.endswith((".h", ".cpp"))]
        included = {i for p in tests for i in re.findall(r"^#include <CGAL/([^>]+)>", self.read(p), re.M)}
        for path in headers:
            name = path[len("include/CGAL/"):]
            if "/internal/" in path:
                self.require(name in included or name in UNTESTED_HEADERS, path, "not included by any file of test/")
                self.require(name not in included or name not in UNTESTED_HEADERS, path, "in UNTESTED_HEADERS, but tested")

    @staticmethod
    def is_in_circle(name, includes):
        seen, open_names = set(), list(includes[name])
        while open_names:
            other = open_names.pop()
            if other == name:
                return True
            if other not in seen:
                seen.add(other)
                open_names += includes[other]
        return False

    def check_unique_names(self):
        seen = {}
        for path in self.paths:
            if path.endswith((".h", ".cpp")) and not path.startswith(("include/CGAL/license/", "doc/")) \
                    and "/install_test/" not in path:
                name = os.path.basename(path).lower()
                self.require(name not in seen, path, "has the name of %s" % seen.get(name))
                seen[name] = path

    def check_programs(self):
        """Every program is named in the CMakeLists.txt above it and every name there exists; examples also in the manual."""
        examples = "examples/%s" % PACKAGE
        for base in (examples, "test/%s" % PACKAGE, "benchmark/%s" % PACKAGE, "program"):
            if not os.path.exists(os.path.join(self.root, base, "CMakeLists.txt")):
                self.require(base.startswith("benchmark/"), base, "no CMakeLists.txt")
                continue
            cmake = re.sub(r"#[^\n]*", "", self.read(base + "/CMakeLists.txt"))
            self.require(cmake.lstrip().startswith("cmake_minimum_required"), base + "/CMakeLists.txt",
                         "does not start with cmake_minimum_required")
            named = set(re.findall(r'[\w./]+\.cpp', cmake))
            there = {os.path.relpath(p, base) for p in self.paths
                     if p.startswith(base + "/") and p.endswith(".cpp") and "/install_test/" not in p}
            for name in sorted(named ^ there):
                self.require(False, "%s/%s" % (base, name),
                             "not named in CMakeLists.txt" if name in there else "does not exist, but is named in CMakeLists.txt")
            if base == examples:
                self.check_examples_in_manual(base, there)

    def check_examples_in_manual(self, base, there):
        path = "doc/%s/examples.txt" % PACKAGE
        listed = set(re.findall(r"\\example %s/(\S+)" % PACKAGE, self.read(path)))
        manual = "".join(self.read(p) for p in self.paths if re.fullmatch(r"doc/%s/\w+\.txt" % PACKAGE, p))
        shown = set(re.findall(r"\\cgalExample\{%s/([^}]+)\}" % PACKAGE, manual))
        for name in sorted(there - listed):
            self.require(False, "%s/%s" % (base, name), "not named in %s" % path)
        for name in sorted((listed | shown) - there):
            self.require(False, path, "names %s, which does not exist" % name)
        for name in sorted(shown - listed):
            self.require(False, path, "does not name %s, which the manual shows" % name)

    def check_package_info(self):
        base = "package_info/%s/" % PACKAGE
        for name in ("copyright", "description.txt", "license.txt", "maintainer", "dependencies", "long_description.txt"):
            present = base + name in self.paths and self.read(base + name).strip()
            self.require(present, base + name, "missing or empty")
            if not present:
                return
        self.require(self.read(base + "license.txt") == "GPL (v3 or later)\n", base + "license.txt", "wrong licence")
        self.require(re.fullmatch(r"[^<>\n]+ <[^<>@\s]+@[^<>@\s]+>\n", self.read(base + "maintainer")),
                     base + "maintainer", "not 'Name <mail>'")
        self.require(self.read(base + "description.txt").count("\n") == 1, base + "description.txt", "not one line")
        dependencies = self.read(base + "dependencies").split()
        self.require(dependencies == sorted(set(dependencies)), base + "dependencies", "not sorted")
        manuals = self.read("doc/%s/dependencies" % PACKAGE).split()
        self.require(manuals[:1] == ["Manual"], "doc/%s/dependencies" % PACKAGE, "does not start with Manual")

    def check_readme(self):
        example = self.read("examples/%s/make_boundary_constrained_mesh.cpp" % PACKAGE)
        self.require("```cpp\n%s```" % example in self.read("README.md"), "README.md", "does not show the example as it is")
        for link in re.findall(r'(?:\]\(|src=")(?!https?:)([^)#"]+)[)"]', self.read("README.md")):
            self.require(os.path.exists(os.path.join(self.root, link)), "README.md", "links to %s, which does not exist" % link)

    def check_pages_for_users(self):
        number_of_words = 0
        for path in PAGES_FOR_USERS:
            text = self.read(path)
            number_of_words += len(text.split())
            self.require("\\cgalFigureBegin" in text.split("\\section")[0], path, "has no picture at the top")
        self.require(number_of_words <= MAX_NUMBER_OF_WORDS, PAGES_FOR_USERS[0],
                     "%d words in the manual for users" % number_of_words)

    def check_developer_pages(self, headers):
        """What the pages for developers name is there; they name each floor, the headers of some, and all constants."""
        names, constants = set(), set()
        for path in DEVELOPER_PAGES:
            if path not in self.paths:
                self.require(False, path, "does not exist")
                continue
            page = self.read(path)
            names.update(in_backticks(page))
            for name in sorted(n for n in set(in_backticks(page)) if is_file_name(n)):
                self.require(self.find(name), path, "names %s, which does not exist" % name)
            for header, cells in rows_of_tables(page):
                self.check_row_of_developer_page(path, header, cells, constants)
        for path in headers:
            internal = re.fullmatch(r"include/CGAL/%s/internal/((\w+/)\w+\.h)" % PACKAGE, path)
            for name in internal.groups() if internal else ():
                self.require(name in names or (name.endswith(".h") and internal.group(2)[:-1] not in LISTED_FLOORS),
                             path, "no page for developers names %s" % name)
            for name in constants_of(without_comments_and_strings(self.read(path))):
                self.require((name, path) in constants, path, "%s is not in the tables of the pages for developers" % name)

    def check_row_of_developer_page(self, page, header, cells, constants):
        """A constant, which is added to the set, or a piece of code, or names of classes and functions: they are in the
        files of the row."""
        names = [name for cell in cells for name in in_backticks(cell)]
        files = [f for f in map(self.find, filter(is_file_name, names)) if f in self.paths]
        code = without_comments_and_strings("\n".join(self.read(f) for f in files))
        first = "".join(in_backticks(cells[0]))
        if header[:2] == ["name", "value"]:
            value = "".join(in_backticks(cells[1]))
            constants.update((first, f) for f in files)
            self.require(re.search(r"\b%s(\[\])?\s*=\s*%s\s*;" % (first, re.escape(value)), code), page,
                         "%s is not %s in %s" % (first, value, cells[2]))
        elif header[0] == "code":
            self.require(first in code, page, "%s is not in %s" % (first, cells[1]))
        elif files:
            for name in names:
                if not is_file_name(name) and not name.startswith("-"):
                    for word in re.findall(r"\w+", name):
                        self.require(re.search(r"\b%s\b" % word, code), page,
                                     "%s is not in the files of: %s" % (word, " | ".join(cells)))

    def find(self, name):
        """The path of a file or folder that a page for developers names, or None."""
        for folder in FOLDERS_OF_DEVELOPER_PAGES:
            path = folder + name
            if path in self.paths or (name.endswith("/") and any(p.startswith(path) for p in self.paths)):
                return path
        return None

    def check_sizes(self):
        def size(prefix):
            return sum(len(self.changes[p]) if p in self.changes else os.path.getsize(os.path.join(self.root, p))
                       for p in self.paths if p.startswith(prefix))
        self.require(size("data/") < 100000, "data", "more than 100 KB")
        self.require(size("doc/") < 2000000, "doc", "more than 2 MB")


def self_test(root):
    """Applies one defect after the other to the package, without writing to it."""
    header = "include/CGAL/%s/parameters.h" % PACKAGE
    util = "include/CGAL/%s/internal/util/Simplex_index_3.h" % PACKAGE
    lost = "include/CGAL/%s/internal/lost/Recover_constraint_3.h" % PACKAGE

    def replace(path, old, new):
        text = read(root, path)
        assert old in text, (path, old)
        return {path: text.replace(old, new, 1)}

    def append(path, text):
        return {path: read(root, path) + text}

    code = "\n#endif // CGAL_BOUNDARY_RECOVERY_3_PARAMETERS_H"
    examples = "examples/%s/" % PACKAGE
    defects = {
        "tab": append("CHANGES.md", "\tx\n"),
        "trailing blank": append("CHANGES.md", "x \n"),
        "newline at the end": append("CHANGES.md", "x"),
        "carriage return": append("CHANGES.md", "x\r\n"),
        "120 columns": append(examples + "recover_boundary_minimal.cpp", "//" + 120 * "x" + "\n"),
        "executable": replace("scripts/run_tests", "#!/usr/bin/env bash\n", ""),
        "SPDX": replace(header, "SPDX-License-Identifier: GPL-3.0-or-later", "GPL"),
        "$URL$": replace(header, "// $URL$", "//"),
        "$Id$": replace(header, "// $Id$", "//"),
        "guard is not named": replace(header, "#ifndef CGAL_BOUNDARY", "#ifndef CGAL_BONDARY"),
        "#endif": replace(header, "#endif // CGAL", "#endif //CGAL"),
        "include is not the one of the licence": replace(header, "#include <CGAL/license/Boundary_recovery_3.h>\n", ""),
        "which is on a lower floor": replace(util, "\n#include", "\n#include <CGAL/%s/internal/mesh/cell_simplices.h>\n#include" % PACKAGE),
        "on none of the floors": {"include/CGAL/%s/internal/x.h" % PACKAGE: read(root, util)},
        "in a circle": replace(util, "\n#include", "\n#include <CGAL/%s/internal/util/Simplex_index_3.h>\n#include" % PACKAGE),
        "not included by any file of test/": {os.path.dirname(util) + "/x.h": read(root, util)},
        "prints": replace(header, code, "\nvoid f() { std::cerr << 1; }\n" + code),
        "ends the program": replace(header, code, "\nvoid f() { std::abort(); }\n" + code),
        "assert": replace(header, code, "\nvoid f(int i) { assert(i); }\n" + code),
        "does not exist, but is named": append(examples + "CMakeLists.txt", 'create_single_source_cgal_program("no.cpp")\n'),
        "not named in CMakeLists.txt": {examples + "x_br3.cpp": "int main() { }\n"},
        "program/y.cpp: not named": {"program/y.cpp": "int main() { }\n"},
        "mesh/y_br3.cpp: not named": {"test/%s/mesh/y_br3.cpp" % PACKAGE: "int main() { }\n"},
        "not named in doc": replace("doc/%s/examples.txt" % PACKAGE, "\\example %s/recover_boundary_minimal.cpp\n" % PACKAGE, ""),
        "has the name of": {examples + "PARAMETERS.h": "\n"},
        "wrong licence": append("package_info/%s/license.txt" % PACKAGE, "or not\n"),
        "not sorted": append("package_info/%s/dependencies" % PACKAGE, "AABB_tree\n"),
        "does not show": append(examples + "make_boundary_constrained_mesh.cpp", "// more\n"),
        "links to doc/no.svg": replace("README.md", "doc/%s/fig/meshed_wing.svg" % PACKAGE, "doc/no.svg"),
        "has no picture": replace("doc/%s/sizes.txt" % PACKAGE, "\\cgalFigureBegin", "\\section"),
        "words in the manual": append(PAGES_FOR_USERS[0], 9000 * "x\n"),
        "names lost/Recover_constraint_3.h, which does not exist": {lost: None},
        "names lost/x.h": {os.path.dirname(lost) + "/x.h": read(root, lost)},
        "max_number_of_shells is not 256 in": replace(lost, "max_number_of_shells = 256;", "max_number_of_shells = 257;"),
        "max_number_of_thoughts is not in the tables": replace(
            lost, "private:", "private:\n  static constexpr int max_number_of_thoughts = 3;"),
        "N == 2 && crossings.size() > 2 is not in": replace(lost, "crossings.size() > 2", "crossings.size() > 3"),
        "is not in the files of: pickRecursiveLinkEdge": replace(DEVELOPER_PAGES[0], "`is_recursable_link_edge()`", "`pick_link_edge()`"),
        "more than 100 KB": {"data/meshes/x.off": 11000 * "123456789\n"},
    }
    unnoticed = []
    before = set(Checker(root).check_all())
    for expected, changes in defects.items():
        new = set(Checker(root, changes).check_all()) - before
        if not any(expected in complaint for complaint in new):
            unnoticed.append("not noticed: %s; new complaints: %s" % (expected, sorted(new)))
    print("%d defects tried" % len(defects))
    return unnoticed


def main(arguments):
    if len(arguments) == 2 and arguments[0] == "--self-test":
        complaints = self_test(arguments[1])
    elif len(arguments) == 1:
        complaints = Checker(arguments[0]).check_all()
    else:
        print(__doc__)
        return 1
    print("\n".join(complaints) if complaints else "nothing to complain about")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
