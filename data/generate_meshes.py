#!/usr/bin/env python3
"""Makes the small closed surfaces of data/meshes, from geometry alone; one of them as a faulty STL file.

usage: generate_meshes.py FOLDER           write the files into FOLDER
       generate_meshes.py --check FOLDER   exit 1 unless FOLDER holds exactly what would be written

Coordinates are rounded to 4 digits, so that the files do not depend on the last bit of a sine. Every
surface is checked before it is written: closed, consistently oriented, of the expected volume sign.
"""
import itertools
import math
import os
import sys
from fractions import Fraction


class Surface:
    """Points, each once, as tuples of exact decimals; triangles, oriented outwards."""

    def __init__(self):
        self.points, self.index, self.triangles = [], {}, []

    def point(self, x, y, z):
        p = tuple(Fraction(round(c * 10000), 10000) for c in (x, y, z))
        if p not in self.index:
            self.index[p] = len(self.points)
            self.points.append(p)
        return self.index[p]

    def triangle(self, a, b, c):
        self.triangles.append((a, b, c))

    def quad(self, a, b, c, d, diagonal=0):
        """Two triangles; diagonal 0 joins a and c, 1 joins b and d."""
        if diagonal == 0:
            self.triangle(a, b, c)
            self.triangle(a, c, d)
        else:
            self.triangle(a, b, d)
            self.triangle(b, c, d)

    def six_volumes(self):
        total = 0
        for t in self.triangles:
            (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (self.points[v] for v in t)
            total += ax * (by * cz - bz * cy) - ay * (bx * cz - bz * cx) + az * (bx * cy - by * cx)
        return total

    def check(self, edges_of_more_than_two_triangles=0):
        """Each directed edge is matched by its reverse; only so many edges have more than two triangles."""
        count = {}
        for t in self.triangles:
            assert len(set(t)) == 3
            for i in range(3):
                a, b = t[i], t[(i + 1) % 3]
                count.setdefault((min(a, b), max(a, b)), []).append(1 if a < b else -1)
        assert all(len(c) >= 2 for c in count.values())
        assert sum(len(c) > 2 for c in count.values()) == edges_of_more_than_two_triangles
        if edges_of_more_than_two_triangles == 0:
            assert all(sum(c) == 0 for c in count.values()) and self.six_volumes() > 0
        assert len(set(map(frozenset, self.triangles))) == len(self.triangles)
        return self

    def coordinates(self):
        """The points as lines of text."""
        def decimal(x):
            text = "%.4f" % float(x)
            return text.rstrip("0").rstrip(".")

        return [" ".join("0" if c == 0 else decimal(c) for c in p) for p in self.points]

    def off(self):
        lines = ["OFF", "%d %d 0" % (len(self.points), len(self.triangles))]
        lines += self.coordinates()
        lines += ["3 %d %d %d" % t for t in self.triangles]
        return "\n".join(lines) + "\n"

    def faulty_stl(self):
        """STL as it comes from careless programs: one triangle is there twice, one has two equal corners."""
        points, (a, b, _) = self.coordinates(), self.triangles[-1]
        lines = ["solid nut"]
        for t in self.triangles + [self.triangles[0], (a, b, b)]:
            lines += ["facet normal 0 0 0", "outer loop"]
            lines += ["vertex " + points[v] for v in t]
            lines += ["endloop", "endfacet"]
        return "\n".join(lines + ["endsolid nut"]) + "\n"


def add_box(surface, low, high, outwards=True, without=()):
    """The six quads of a box; `without` names sides like '+x' that are left out."""
    v = [surface.point(*((low, high)[(i >> k) & 1][k] for k in range(3))) for i in range(8)]
    sides = {"-x": (0, 4, 6, 2), "+x": (1, 3, 7, 5), "-y": (0, 1, 5, 4), "+y": (2, 6, 7, 3),
             "-z": (0, 2, 3, 1), "+z": (4, 5, 7, 6)}
    for name, q in sides.items():
        if name not in without:
            q = [v[i] for i in (q if outwards else reversed(q))]
            surface.quad(*q)


def cube():
    s = Surface()
    add_box(s, (0, 0, 0), (1, 1, 1))
    return s.check()


def nested_cubes():
    """A cube with a cubical void."""
    s = Surface()
    add_box(s, (0, 0, 0), (3, 3, 3))
    add_box(s, (1, 1, 1), (2, 2, 2), outwards=False)
    return s.check()


def two_cubes():
    """Two regions: 11 distinct quads, the four edges of the shared one have more than two triangles."""
    s = Surface()
    add_box(s, (0, 0, 0), (1, 1, 1))
    add_box(s, (1, 0, 0), (2, 1, 1), without=("-x",))
    assert len(s.triangles) == 22
    return s.check(edges_of_more_than_two_triangles=4)


def schoenhardt():
    """Schoenhardt's prism, twisted by 30 degrees: no tetrahedra fill it without a further point."""
    s = Surface()

    def ring(z, turn):
        return [s.point(math.cos(math.radians(120 * i + turn)), math.sin(math.radians(120 * i + turn)), z)
                for i in range(3)]

    low, high = ring(0, 0), ring(1, 30)
    s.triangle(low[0], low[2], low[1])
    s.triangle(*high)
    for i in range(3):
        j = (i + 1) % 3
        s.quad(low[i], low[j], high[j], high[i])  # the diagonal low[i] high[j] is reflex
        corners = [s.points[v] for v in (low[i], low[j], high[j], high[i])]
        assert orientation_3(*corners) > 0, "the diagonal is not reflex"
    return s.check()


def orientation_3(p, q, r, t):
    u, v, w = (tuple(x - y for x, y in zip(a, p)) for a in (q, r, t))
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0])
            + u[2] * (v[0] * w[1] - v[1] * w[0]))


def orientation_2(p, q, r):
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def circle(n, radius, turn=0.0):
    return [(radius * math.cos(2 * math.pi * (i + turn) / n), radius * math.sin(2 * math.pi * (i + turn) / n))
            for i in range(n)]


def strip(outer, inner):
    """Triangles between two nested polygons that start at about the same angle and run counterclockwise:
    corners ('o', i) and ('i', j), advanced by angle."""
    triangles, i, j = [], 0, 0
    while i < len(outer) or j < len(inner):
        o, n = ("o", i % len(outer)), ("i", j % len(inner))
        if i < len(outer) and (j == len(inner) or (i + 1) * len(inner) <= (j + 1) * len(outer)):
            i += 1
            triangles.append((o, ("o", i % len(outer)), n))
        else:
            j += 1
            triangles.append((o, ("i", j % len(inner)), n))
    return triangles


def extrude(outline, bore, cap, height):
    """A part of constant section: `cap` holds triangles over corners ('o', i) of the outline, ('i', j) of the bore."""
    s = Surface()
    low = {("o", i): s.point(x, y, 0) for i, (x, y) in enumerate(outline)}
    low.update({("i", j): s.point(x, y, 0) for j, (x, y) in enumerate(bore)})
    high = {c: s.point(s.points[v][0], s.points[v][1], height) for c, v in low.items()}
    area = 0
    for a, b, c in cap:
        turn = orientation_2(*(s.points[low[v]] for v in (a, b, c)))
        assert turn > 0, "the cap is folded"
        area += turn
        s.triangle(high[a], high[b], high[c])
        s.triangle(low[a], low[c], low[b])
    for kind, n, sign in (("o", len(outline), 1), ("i", len(bore), -1)):
        for i in range(n):
            a, b = (kind, i), (kind, (i + 1) % n)
            if sign < 0:
                a, b = b, a
            s.quad(low[a], low[b], high[b], high[a], diagonal=i % 2)
            area -= orientation_2((0, 0), s.points[low[a]], s.points[low[b]])
    assert area == 0, "the cap does not cover the section exactly"
    return s.check()


def washer():
    """A thin plate with a round hole."""
    outline, bore = circle(24, 4), circle(16, 2)
    return extrude(outline, bore, strip(outline, bore), 0.25)


def nut():
    """A hexagon nut."""
    outline, bore = circle(6, 2), circle(12, 1)
    return extrude(outline, bore, strip(outline, bore), 0.8)


def gear():
    """A gear cut as a CSG program would: a fine outline joined to a coarse bore by stretched triangles."""
    teeth, root, tip = 24, circle(48, 8, -0.5), []
    for i in range(teeth):
        for side in (-0.3, 0.3):
            angle = 2 * math.pi * (i + side / 2) / teeth
            tip.append((10 * math.cos(angle), 10 * math.sin(angle)))
    outline, number = [], {}
    for i in range(teeth):
        for name, p in (("r", root[2 * i]), ("t", tip[2 * i]), ("t", tip[2 * i + 1]), ("r", root[2 * i + 1])):
            number[name, p] = len(outline)
            outline.append(p)
    cap = []
    for i in range(teeth):
        a, b, c, d = (("o", 4 * i + k) for k in range(4))
        cap += [(a, b, c), (a, c, d)]
    bore = circle(7, 3, 0.02)
    for triangle in strip(root, bore):
        cap.append(tuple(("o", number["r", root[v]]) if kind == "o" else (kind, v) for kind, v in triangle))
    return extrude(outline, bore, cap, 0.5)


def airfoil(n):
    """A symmetric profile of 12 % thickness and length 1, counterclockwise from the trailing edge: 2 n corners."""
    def half(x):
        return 0.6 * (0.2969 * math.sqrt(x) - 0.126 * x - 0.3516 * x ** 2 + 0.2843 * x ** 3 - 0.1036 * x ** 4)

    def point(i):
        x = (1 + math.cos(math.pi * i / n)) / 2
        return x, 0.0 if i % n == 0 else half(x) if i < n else -half(x)

    return [point(i) for i in range(2 * n)]


def add_grid_box(surface, low, high, n):
    """A box whose sides are divided into n by n quads."""
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3

        def corner(end, i, j):
            p = [0, 0, 0]
            p[axis] = end[axis]
            for k, position in ((u, i), (v, j)):
                p[k] = low[k] + (high[k] - low[k]) * position / n
            return surface.point(*p)

        for i in range(n):
            for j in range(n):
                for end in (low, high):
                    q = [corner(end, a, b) for a, b in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))]
                    surface.quad(*(q if end is high else reversed(q)))


def wing():
    """The air around a swept wing that becomes narrower towards its tip: a void in a box."""
    s, n, number_of_sections = Surface(), 8, 9
    sections = []
    for k in range(number_of_sections):
        y = -2 + 4 * k / (number_of_sections - 1)
        chord, sweep = 1 - 0.125 * (y + 2), 0.25 * (y + 2)
        sections.append([s.point(sweep + chord * x, y, chord * z) for x, z in airfoil(n)])
    for a, b in zip(sections, sections[1:]):
        for i in range(2 * n):
            j = (i + 1) % (2 * n)
            s.quad(a[i], a[j], b[j], b[i], diagonal=i % 2)
    for section, is_tip in ((sections[0], False), (sections[-1], True)):
        for i in range(n):
            q = [section[i], section[(i + 1) % (2 * n)], section[2 * n - i - 1], section[(2 * n - i) % (2 * n)]]
            q = q if is_tip else q[::-1]
            corners = [v for k, v in enumerate(q) if v != q[k - 1]]
            s.quad(*corners) if len(corners) == 4 else s.triangle(*corners)
    assert s.six_volumes() < 0, "the wing does not turn inwards"
    add_grid_box(s, (-4, -5, -4), (8, 5, 4), 4)
    return s.check()


def graded_lines(*places_and_distances):
    """Positions from the first place to the last one, all places among them. Their distances are those that are asked
    for at the places, and change linearly between them."""
    lines = [places_and_distances[0][0]]
    for (a, first), (b, last) in zip(places_and_distances, places_and_distances[1:]):
        steps, growth = [0.0], (last - first) / (b - a)
        while steps[-1] < b - a:
            steps.append(steps[-1] + first + growth * steps[-1])
        if len(steps) > 2 and steps[-1] - (b - a) > b - a - steps[-2]:
            steps.pop()
        lines += [a + step * ((b - a) / steps[-1]) for step in steps[1:-1]] + [b]
    return lines


def add_blocks(surface, lines, is_solid, shape, sign):
    """The boundary of some of the blocks between three families of lines, which a map then gives its shape. So it is
    watertight whatever the shape. It turns outwards if the sign is 1."""
    def is_solid_block(block):
        return all(0 <= b < len(line) - 1 for b, line in zip(block, lines)) and \
            is_solid(*((line[b] + line[b + 1]) / 2 for b, line in zip(block, lines)))

    def length(a, b):
        return sum((c - d) ** 2 for c, d in zip(surface.points[a], surface.points[b]))

    for block in itertools.product(*(range(len(line) - 1) for line in lines)):
        for axis, step in itertools.product(range(3), (-1, 1)):
            neighbor = tuple(b + step * (k == axis) for k, b in enumerate(block))
            if not is_solid_block(block) or is_solid_block(neighbor):
                continue
            q = []
            for i, j in ((0, 0), (1, 0), (1, 1), (0, 1)):
                corner = list(block)
                corner[axis] += step == 1
                corner[(axis + 1) % 3] += i
                corner[(axis + 2) % 3] += j
                q.append(surface.point(*shape(*(line[c] for c, line in zip(corner, lines)))))
            q = q if step == sign else q[::-1]
            surface.quad(*q, diagonal=0 if length(q[0], q[2]) <= length(q[1], q[3]) else 1)


def add_wing_with_pylon(surface, size, sign):
    """A wing with the chord 3 and the span 6, swept back and blunt at its edges, and below it a pylon down to -0.75."""
    front, back, width, bottom = 0.7, 2.3, 0.12, -0.75

    def half_thickness(x):
        return 0.0825 * (1 + min(1, min(x, 3 - x) / 0.6))

    def narrowness(x):  # of the pylon, where it begins and ends
        return 1 - 0.5 * max(0, 1 - min(abs(x - front), abs(x - back)) / 0.3)

    def shape(x, y, z):  # z is 0 at the lower side of the wing, 1 at the upper one, -1 at the bottom
        t, side, n = half_thickness(x), abs(y), narrowness(x)
        side = side * n if side <= width else 3 - (3 - side) * ((3 - width * n) / (3 - width))
        return (x + 0.08 * side * side, math.copysign(side, y),
                t * (2 * z - 1) if z >= 0 else -t - z * (bottom + t))

    lines = (graded_lines((0, 2 * size), (front, size), (back, size), (3, 2 * size)),
             graded_lines((-3, 2 * size), (-width, size), (0, size), (width, size), (3, 2 * size)),
             graded_lines((-1, size / 0.585), (0, size / 0.585)) + [1])
    add_blocks(surface, lines, lambda x, y, z: z > 0 or (front < x < back and abs(y) < width), shape, sign)


def add_store(surface, center, radius, size, sign):
    """A cylinder along x, with half an ellipsoid at each end: a long box, of which the cubes at the ends become
    spheres."""
    def shape(x, y, z):
        end = max(abs(x) - 1, 0)
        d = [math.copysign(math.tan(math.pi / 4 * end), x), math.tan(math.pi / 4 * y), math.tan(math.pi / 4 * z)]
        scale = radius / math.sqrt(sum(c * c for c in d))
        along = 2 * radius * max(-1, min(1, x)) + scale * d[0] * (1.8 if x > 0 else 1.4)
        return center[0] + along, center[1] + scale * d[1], center[2] + scale * d[2]

    step, along = size / (radius * math.pi / 4), size / (2 * radius)
    across = graded_lines((-1, step), (0, step), (1, step))
    lines = (graded_lines((-2, step), (-1, step), (0, along), (1, step), (2, step)), across, across)
    add_blocks(surface, lines, lambda x, y, z: True, shape, sign)


def store():
    """The air around a store below the pylon of a wing: two voids in a box. The points of the store are the last ones.
    It is what benchmark_moving_body makes, as coarse as can be."""
    s, size = Surface(), 0.25
    box = [graded_lines((low, 6 * size), (high, 6 * size)) for low, high in ((-5, 8), (-5.5, 5.5), (-8, 3))]
    add_blocks(s, box, lambda x, y, z: True, lambda x, y, z: (x, y, z), 1)
    add_wing_with_pylon(s, size, -1)
    add_store(s, (1.5, 0, -1.35), 0.4, size, -1)
    return s.check()


SURFACES = {"cube_br3.off": cube, "nested_cubes_br3.off": nested_cubes, "two_cubes_br3.off": two_cubes,
            "schoenhardt_br3.off": schoenhardt, "washer_br3.off": washer, "gear_br3.off": gear, "nut_br3.stl": nut,
            "wing_br3.off": wing, "store_br3.off": store}


def main(arguments):
    check = arguments[:1] == ["--check"]
    if len(arguments) != 1 + check:
        print(__doc__)
        return 1
    folder, wrong = arguments[-1], 0
    for name, make in SURFACES.items():
        path, surface = os.path.join(folder, name), make()
        text = surface.off() if name.endswith(".off") else surface.faulty_stl()
        if not check:
            with open(path, "w", newline="\n") as file:
                file.write(text)
        elif not os.path.exists(path) or open(path, newline="").read() != text:
            wrong += 1
            print("%s: missing, or not what the generator makes" % path)
    for name in sorted(os.listdir(folder)) if check else ():
        if name not in SURFACES:
            wrong += 1
            print("%s: no generator makes it" % os.path.join(folder, name))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
