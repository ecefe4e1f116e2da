#!/usr/bin/env python3
"""Draws the figures of the user manual that explain notions: shell, recursion, conditions, points, sizes, defects, sub-domains.

usage: draw_figures.py FOLDER           write the SVG files into FOLDER
       draw_figures.py --check FOLDER   exit 1 unless FOLDER holds exactly what would be written

Only Python's standard library is used.
"""
import math
import os
import sys

BLACK, GREY, RED, BLUE, ORANGE = "#222", "#999", "#c0392b", "#2e6da4", "#f0a34a"
LIGHT_BLUE, LIGHT_ORANGE, LIGHT_RED, LIGHT_GREEN = "#d5e3f0", "#fbe3c4", "#f3c9c3", "#dcefdc"


def between(p, q, t=0.5):
    return (p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]))


def ring(center, radius, degree, turn=0.0, flat=1.0):
    """The corners of a regular polygon, clockwise from the top as one sees it."""
    angles = [2 * math.pi * (i + turn) / degree - math.pi / 2 for i in range(degree)]
    return [(center[0] + radius * math.cos(a), center[1] + flat * radius * math.sin(a)) for a in angles]


class Drawing:
    def __init__(self, width, height):
        self.size, self.items = (width, height), []

    def number(self, x):
        return ("%.1f" % x).rstrip("0").rstrip(".")

    def path(self, points, close=False, stroke=BLACK, width=1.3, fill="none", dash=None, opacity=None):
        d = "M" + "L".join("%s %s" % (self.number(x), self.number(y)) for x, y in points) + ("Z" if close else "")
        style = "".join(' %s="%s"' % (k, v) for k, v in (("stroke-dasharray", dash), ("fill-opacity", opacity)) if v)
        self.items.append('<path d="%s" fill="%s" stroke="%s" stroke-width="%s" stroke-linejoin="round"%s/>'
                          % (d, fill, stroke, width, style))

    def polygon(self, points, fill="none", **options):
        self.path(points, close=True, fill=fill, **options)

    def line(self, p, q, **options):
        self.path([p, q], **options)

    def dot(self, p, color=BLACK, radius=3):
        self.items.append('<circle cx="%s" cy="%s" r="%s" fill="%s"/>'
                          % (self.number(p[0]), self.number(p[1]), radius, color))

    def circle(self, p, radius, color):
        self.items.append('<circle cx="%s" cy="%s" r="%s" fill="none" stroke="%s" stroke-dasharray="4 3"/>'
                          % (self.number(p[0]), self.number(p[1]), self.number(radius), color))

    def cross(self, p, color=RED, size=5):
        for s in (-1, 1):
            self.line((p[0] - size, p[1] - s * size), (p[0] + size, p[1] + s * size), stroke=color, width=2)

    def arrow(self, p, q, color=BLACK):
        self.line(p, q, stroke=color, width=1.6)
        a = math.atan2(q[1] - p[1], q[0] - p[0])
        self.path([(q[0] + 9 * math.cos(a + s), q[1] + 9 * math.sin(a + s)) for s in (2.7, -2.7)] + [q],
                  close=True, stroke=color, fill=color, width=1)

    def label(self, p, text, dx=0, dy=0, color=BLACK, size=15):
        """Mathematics, in italics; what follows an underscore is the subscript."""
        name, _, index = text.partition("_")
        words = '<tspan font-style="italic">%s</tspan>' % name
        if index:
            words += ('<tspan font-style="italic" font-size="%d" dy="4">%s</tspan>'
                      % (round(0.72 * size), index.replace("-", "\u2212")))
        self.text(p, words, dx, dy, color, size)

    def text(self, p, text, dx=0, dy=0, color=BLACK, size=13):
        """Words, centered at a point."""
        self.items.append('<text x="%s" y="%s" font-size="%d" fill="%s">%s</text>'
                          % (self.number(p[0] + dx), self.number(p[1] + dy + size / 3), size, color, text))

    def svg(self):
        head = ('<svg xmlns="http://www.w3.org/2000/svg" width="%d" height="%d" viewBox="0 0 %d %d" '
                'font-family="DejaVu Sans,Helvetica,Arial,sans-serif" text-anchor="middle" xml:space="preserve">'
                % (self.size + self.size))
        white = '<rect width="%d" height="%d" fill="#fff"/>' % self.size
        return "\n".join([head, white] + self.items + ["</svg>"]) + "\n"


def spindle(x, y):
    """The ends of a supporting edge and its skirt polygon, seen from the side; p_0 and p_1 are behind."""
    skirt = [(x - 40, y - 22), (x + 48, y - 26), (x + 92, y + 8), (x + 14, y + 34), (x - 88, y + 10)]
    return (x, y - 120), (x, y + 120), skirt


def shell():
    """The shell of an edge, and two covering meshes of it: from the side, and the skirt polygon from above."""
    d = Drawing(760, 490)
    titles = ["the shell of ab", "complete reduction", "partial reduction"]
    triangles = [[], [(0, 1, 3), (1, 2, 3), (0, 3, 4)], [(1, 2, 3)]]
    cores = [[0, 1, 2, 3, 4], [], [0, 1, 3, 4]]
    for panel in range(3):
        x = 130 + 250 * panel
        a, b, p = spindle(x, 145)
        for t in triangles[panel]:
            d.polygon([p[i] for i in t], fill=LIGHT_ORANGE, stroke=ORANGE)
        for i in range(5):
            behind = i in (0, 1)
            dash = "4 3" if behind else None
            d.line(a, p[i], stroke=BLACK, dash=dash, width=1)
            d.line(b, p[i], stroke=BLACK, dash=dash, width=1)
            j = (i + 1) % 5
            d.line(p[i], p[j], stroke=BLUE, width=2, dash="4 3" if i in (0, 4) and j in (0, 1) else None)
        if cores[panel]:
            d.line(a, b, stroke=RED, width=2.6)
        for q in p + [a, b]:
            d.dot(q)
        d.label(a, "a", dx=-12)
        d.label(b, "b", dx=-12)
        for i, (dx, dy) in enumerate([(-12, -9), (12, -9), (17, 4), (10, 16), (-17, 4)]):
            d.label(p[i], "p_%d" % i, dx=dx, dy=dy)
        q = ring((x, 370), 62, 5, -0.5)
        for t in triangles[panel]:
            d.polygon([q[i] for i in t], fill=LIGHT_ORANGE, stroke=ORANGE, width=2)
        for i in cores[panel]:
            d.line((x, 370), q[i], width=1)
        d.polygon(q, stroke=BLUE, width=2)
        for i in range(5):
            d.dot(q[i])
            d.label(between((x, 370), q[i], 1.22), "p_%d" % i)
        if cores[panel]:
            d.dot((x, 370), RED, 4)
            d.label((x, 370), "ab", dx=0, dy=14 if panel else 15, color=RED)
        d.text((x, 474), titles[panel], size=14)
    return d


def recursion():
    """A link edge is the supporting edge of the next level: its shell loses b, so the first shell loses p_i."""
    d = Drawing(760, 300)
    y, r = 135, 78
    names = ["p_i", "p_i+1", "", "", "", "p_i-1"]
    q = ring((120, y), r, 6)
    d.polygon([(120, y), q[0], q[1]], fill=LIGHT_ORANGE, stroke="none")
    d.polygon([(120, y), q[5], q[0]], fill=LIGHT_ORANGE, stroke="none")
    draw_ring(d, (120, y), q, names, "ab")
    d.line((120, y), q[0], stroke=ORANGE, width=4)
    d.text((120, 250), "level l: the shell of ab,", size=14)
    d.text((120, 270), "and its face a b p\u1d62", size=14)

    center = (375, y)
    q = ring(center, r, 5)
    d.polygon([q[4], q[0], q[1]], fill=LIGHT_ORANGE, stroke=ORANGE, width=2)
    draw_ring(d, center, q, ["b", "p_i+1", "", "", "p_i-1"], "a p_i", without=(0,))
    d.line(center, q[0], stroke=ORANGE, width=2, dash="4 3")
    d.text((375, 250), "level l + 1: the shell of the link edge a p\u1d62", size=14)
    d.text((375, 270), "loses the vertex b, and so that face", size=14)

    q = ring((635, y), r, 6)[1:]
    draw_ring(d, (635, y), q, ["p_i+1", "", "", "", "p_i-1"], "ab")
    d.text((635, 250), "level l: the shell of ab is", size=14)
    d.text((635, 270), "smaller, and is tried again", size=14)
    d.arrow((220, y), (265, y))
    d.arrow((483, y), (528, y))
    return d


def draw_ring(d, center, q, names, middle, without=()):
    for i, p in enumerate(q):
        if i not in without:
            d.line(center, p, width=1)
    d.polygon(q, stroke=BLUE, width=2)
    for p, name in zip(q, names):
        d.dot(p)
        if name:
            d.label(between(center, p, 1.25), name)
    d.dot(center, RED, 4)
    d.label(center, middle, dy=16, color=RED)


def conditions():
    """BRC1 to BRC4: the new entities are orange, the lost constraints red."""
    d = Drawing(760, 250)
    t = [(30, 140), (165, 150), (110, 60)]
    u, v, m = (75, 25), (125, 195), (98, 110)
    d.line(m, v, stroke=RED, width=2.2, dash="5 3")
    d.polygon(t, fill=LIGHT_ORANGE, stroke=ORANGE, width=2, opacity=0.85)
    d.line(u, m, stroke=RED, width=2.2)
    label_points(d, [(u, "u", -11, 0), (v, "v", 11, 2)], RED)
    label_points(d, [(t[0], "p_i", -6, 15), (t[1], "p_j", 8, 15), (t[2], "p_k", 14, -6)])
    d.cross(m)
    d.text((98, 232), "BRC1: refused", size=14)

    t = [(220, 140), (355, 150), (300, 60)]
    u, v, m = (265, 25), (315, 195), (288, 110)
    d.line(m, v, stroke=ORANGE, width=2.2, dash="5 3")
    d.polygon(t, fill=LIGHT_RED, stroke=RED, width=2, opacity=0.85)
    d.line(u, m, stroke=ORANGE, width=2.2)
    label_points(d, [(u, "p_i", -13, 0), (v, "p_j", 14, 2)])
    label_points(d, [(t[0], "u", -4, 14), (t[1], "v", 8, 13), (t[2], "w", 14, -4)], RED)
    d.cross(m)
    d.text((288, 232), "BRC2: refused", size=14)

    for k, x in enumerate((478, 668)):
        q = ring((x, 105), 66, 4)
        d.polygon(q, stroke=BLUE, width=2)
        d.line(q[0], q[2], stroke=GREY, width=2.2)
        d.line(q[1], q[3], stroke=ORANGE, width=2.2)
        if k == 0:
            d.line((x - 58, 66), (x + 52, 60), stroke=RED, width=2.2, dash="5 3")
            d.line((x - 60, 72), (x + 62, 118), stroke=RED, width=2.2, dash="5 3")
            crossings = [(x, 63), (x, 94.6), (x + 27.5, 105)]
        else:
            d.polygon([(x - 32, 76), (x + 26, 64), (x + 10, 86)], fill=LIGHT_RED, stroke=RED, width=1.6, opacity=0.6)
            d.polygon([(x - 20, 127), (x + 42, 120), (x + 30, 90)], fill=LIGHT_RED, stroke=RED, width=1.6, opacity=0.6)
            crossings = [(x, 76), (x, 118), (x + 22, 105)]
        for p in crossings:
            d.dot(p, RED, 3.5)
        for p in q:
            d.dot(p)
        d.text((x, 192), "from 2 to 1", color=GREY)
        d.text((x, 232), "BRC%d: allowed" % (k + 3), size=14)
    return d


def label_points(d, points, color=BLACK):
    for p, name, dx, dy in points:
        d.dot(p, color)
        d.label(p, name, dx=dx, dy=dy, color=color)


def conforming():
    """A lost edge becomes a chain of mesh edges, a lost facet a union of mesh facets."""
    d = Drawing(760, 260)
    for k, x in enumerate((20, 215)):
        u, v = (x + 10, 130), (x + 165, 110)
        top, low = [(x + 45, 60), (x + 100, 45)], [(x + 60, 190), (x + 120, 180)]
        for p, q in ((u, top[0]), (top[0], top[1]), (top[1], v), (u, low[0]), (low[0], low[1]), (low[1], v)):
            d.line(p, q)
        crossed = [(top[0], low[0]), (top[1], low[0]), (top[1], low[1])]
        points = [u] + [between(*pq, t=crossing(u, v, pq)) for pq in crossed] + [v]
        for p, q in crossed:
            d.line(p, q)
        if k == 0:
            d.line(u, v, stroke=RED, width=2.2, dash="5 3")
        else:
            d.path(points, stroke=BLUE, width=2.6)
            extra = [(points[1], top[1]), (points[2], low[1])]
            for p, q in extra:
                d.line(p, q, stroke=ORANGE, width=1.6)
            for p in points[1:-1]:
                d.dot(p, BLUE, 4)
        for p in top + low:
            d.dot(p)
        label_points(d, [(u, "u", -2, 16), (v, "v", 4, 16)], RED if k == 0 else BLUE)
    d.text((202, 240), "a lost edge, and its parts", size=14)
    for k, x in enumerate((410, 590)):
        t = [(x + 10, 165), (x + 150, 175), (x + 92, 70)]
        e, m, f = (x + 70, 25), (x + 86, 140), (x + 98, 215)
        d.line(m, f, dash="4 3", width=1.6)
        d.polygon(t, fill=LIGHT_RED if k == 0 else LIGHT_BLUE, stroke=RED if k == 0 else BLUE, width=2, opacity=0.85)
        if k == 0:
            d.cross(m)
        else:
            for p in t:
                d.line(m, p, stroke=BLUE, width=2)
            d.dot(m, BLUE, 4)
        d.line(e, m, width=1.6)
        d.dot(e)
        d.dot(f)
    d.text((582, 240), "a lost facet, and its parts", size=14)
    d.arrow((192, 75), (222, 75))
    d.arrow((568, 130), (591, 130))
    return d


def crossing(u, v, pq):
    """Where the line uv divides the segment pq."""
    def side(p):
        return (v[0] - u[0]) * (p[1] - u[1]) - (v[1] - u[1]) * (p[0] - u[0])
    return side(pq[0]) / (side(pq[0]) - side(pq[1]))


def splitting():
    """A Steiner point s comes off a facet, a manifold edge, a non-manifold edge."""
    d = Drawing(760, 300)
    y, r = 125, 88
    panels = [(125, [0, 4], "s inside a facet: one fan", "seen from the side"),
              (380, [0, 3], "s on an edge of two facets", "seen along the edge"),
              (635, [0, 3, 5], "s on an edge of three facets", "seen along the edge")]
    for x, fans, title, subtitle in panels:
        center = (x, y)
        q = ring(center, r, 8, turn=-2)
        middles = []
        for k, first in enumerate(fans):
            last = fans[(k + 1) % len(fans)]
            arc = [(first + i) % 8 for i in range((last - first) % 8 + 1)]
            angle = 2 * math.pi * (first + (len(arc) - 1) / 2 - 2) / 8 - math.pi / 2
            m = (x + 0.5 * r * math.cos(angle), y + 0.5 * r * math.sin(angle))
            d.polygon([center] + [q[i] for i in arc], fill=(LIGHT_ORANGE, LIGHT_BLUE, LIGHT_GREEN)[k], stroke="none")
            for i in arc:
                d.line(m, q[i], width=1, stroke=GREY)
            if x != 125: # in the view along the edge, the ends of the edge are where s is
                d.line(m, center, width=1, stroke=GREY)
            middles.append(m)
        d.polygon(q, width=1.6)
        for i in fans:
            d.line(center, q[i], stroke=RED, width=3)
        for i in range(8):
            d.dot(q[i])
        d.dot(center, RED, 4)
        d.label(center, "s", dx=-10 if len(fans) == 3 else 0, dy=12 if len(fans) == 2 else 10, color=RED)
        for k, m in enumerate(middles):
            d.dot(m, BLUE, 4)
            away = (m[0] - x, m[1] - y)
            d.label(m, "s_%d" % (k + 1), dx=0.34 * away[0] + 2, dy=0.42 * away[1], color=BLUE)
        d.text((x, 245), title, size=14)
        d.text((x, 266), subtitle, size=12, color=GREY)
    return d


def circle_of(a, b, c):
    """The center and the squared radius of the circle through three points."""
    bx, by, cx, cy = b[0] - a[0], b[1] - a[1], c[0] - a[0], c[1] - a[1]
    area = 2 * (bx * cy - by * cx)
    x = (cy * (bx * bx + by * by) - by * (cx * cx + cy * cy)) / area
    y = (bx * (cx * cx + cy * cy) - cx * (bx * bx + by * by)) / area
    return (a[0] + x, a[1] + y), x * x + y * y


def squared_distance(p, q):
    return (p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2


def delaunay(points):
    """The triangles with no point inside of their circles: few points, so all are tried."""
    triangles, n = [], len(points)
    for i in range(n):
        for j in range(i + 1, n):
            for k in range(j + 1, n):
                center, radius = circle_of(points[i], points[j], points[k])
                if all(m in (i, j, k) or squared_distance(points[m], center) > radius for m in range(n)):
                    triangles.append((i, j, k))
    return triangles


def edges_of(triangle):
    i, j, k = triangle
    return [(i, j), (i, k), (j, k)]


def cavity_of(p, points, triangles, walls):
    """The triangles whose circles contain p, from the one that contains p on, but not through walls."""
    def contains(t):
        center, radius = circle_of(*(points[i] for i in t))
        return squared_distance(p, center) < radius
    conflict = [t for t in triangles if contains(t)]
    first = [t for t in conflict if sum(d < 0 for d in sides(p, [points[i] for i in t])) in (0, 3)]
    cavity, behind = list(first), []
    for t in cavity:
        for e in edges_of(t):
            for u in conflict:
                if u not in cavity and e in edges_of(u):
                    (behind if e in walls else cavity).append(u)
    return cavity, [u for u in behind if u not in cavity]


def sides(p, t):
    return [(t[(i + 1) % 3][0] - t[i][0]) * (p[1] - t[i][1]) - (t[(i + 1) % 3][1] - t[i][1]) * (p[0] - t[i][0])
            for i in range(3)]


def cavity():
    """A new point, its cavity, which ends at a wall, and the star that takes its place; in the plane."""
    d = Drawing(760, 330)
    points = [(32, 28), (122, 20), (205, 42), (20, 118), (92, 84), (168, 98), (232, 130), (52, 176), (128, 165), (190, 186),
              (22, 250), (96, 238), (158, 250), (228, 240)]
    p, triangles = (104, 153), delaunay(points)
    walls = [(7, 8), (8, 9), (6, 9), (3, 7)]
    hole, behind = cavity_of(p, points, triangles, walls)
    for panel, title in enumerate(["the cell of p", "the cavity", "the star"]):
        move = lambda q, x=250 * panel: (q[0] + x, q[1] + 12)
        for t in triangles:
            fill = "none"
            if panel == 1 and t in hole or panel == 0 and t == hole[0]:
                fill = LIGHT_ORANGE
            if panel < 2 or t not in hole:
                d.polygon([move(points[i]) for i in t], fill=fill, stroke=GREY, width=1)
        if panel == 1:
            for t in hole + behind:
                center, radius = circle_of(*(points[i] for i in t))
                d.circle(move(center), math.sqrt(radius), RED if t in behind else ORANGE)
        if panel == 2:
            border = [e for t in hole for e in edges_of(t) if sum(e in edges_of(u) for u in hole) == 1]
            for e in border:
                d.polygon([move(p), move(points[e[0]]), move(points[e[1]])], fill=LIGHT_ORANGE, stroke=ORANGE, width=1.6)
        for i, j in walls:
            d.line(move(points[i]), move(points[j]), stroke=BLUE, width=3)
        for q in points:
            d.dot(move(q), radius=2.5)
        d.dot(move(p), RED, 4)
        d.label(move(p), "p", dx=11, dy=-5, color=RED)
        d.text((125 + 250 * panel, 312), title, size=14)
    return d


class Graph:
    """Axes in a drawing, with the origin at a place, and lengths per unit."""
    def __init__(self, drawing, origin, unit, size, names):
        self.drawing, self.origin, self.unit = drawing, origin, unit
        drawing.arrow(origin, (origin[0] + size[0], origin[1]))
        drawing.arrow(origin, (origin[0], origin[1] - size[1]))
        drawing.text((origin[0] + size[0] / 2, origin[1] + 34), names[0], size=13)
        drawing.text((origin[0] + 6, origin[1] - size[1] - 12), names[1], size=13)

    def at(self, x, y):
        return (self.origin[0] + x * self.unit[0], self.origin[1] - y * self.unit[1])

    def curve(self, function, first, last, **options):
        n = 120
        xs = [first + (last - first) * i / n for i in range(n + 1)]
        self.drawing.path([self.at(x, function(x)) for x in xs], **options)


def source():
    """The size at a distance from a source: linear, and doubling."""
    d = Drawing(560, 320)
    s, r, doubled, g = 1.0, 1.0, 3.0, 0.25
    graph = Graph(d, (60, 265), (70, 50), (470, 225), ("distance d from the source", "size"))
    for x, y, name in ((r, s, "r"), (doubled, 2 * s, "D"), (2 * doubled - r, 4 * s, "2D - r")):
        d.line(graph.at(x, 0), graph.at(x, y), stroke=GREY, width=1, dash="4 3")
        d.label(graph.at(x, 0), name, dy=14)
    for y, name in ((s, "s"), (2 * s, "2s"), (4 * s, "4s")):
        d.line(graph.at(0, y), graph.at(r if y == s else doubled if y == 2 * s else 2 * doubled - r, y),
               stroke=GREY, width=1, dash="4 3")
        d.label(graph.at(0, y), name, dx=-16)
    d.line(graph.at(0, s), graph.at(r, s), stroke=BLACK, width=2.6)
    graph.curve(lambda x: s + g * (x - r), r, 6, stroke=BLUE, width=2.6)
    graph.curve(lambda x: s * 2 ** ((x - r) / (doubled - r)), r, 5.1, stroke=ORANGE, width=2.6)
    d.text(graph.at(5.6, 1.75), "linear", color=BLUE, size=14)
    d.text(graph.at(3.55, 3.1), "doubling", color=ORANGE, size=14)
    return d


def grading():
    """Sizes at vertices of a surface, and what is made of them in between: the lowest of all cones."""
    d = Drawing(560, 300)
    graph = Graph(d, (50, 250), (47, 40), (490, 215), ("place", "size"))
    sizes, g = [(0.6, 1.0), (2, 0.5), (3.2, 3.2), (5.4, 1.7), (7.2, 1), (8.9, 1.6)], 0.5
    for x, h in sizes:
        for end in (0, 10):
            d.line(graph.at(x, h), graph.at(*clipped(x, h, end, g, 3.8)), stroke=GREY, width=1, dash="4 3")
    graph.curve(lambda x: min(h + g * abs(x - q) for q, h in sizes), 0, 10, stroke=BLUE, width=2.6)
    for x, h in sizes:
        lowest = min(k + g * abs(x - q) for q, k in sizes)
        d.line(graph.at(x, 0), graph.at(x, h), stroke=LIGHT_BLUE, width=1.4)
        d.dot(graph.at(x, h), RED if lowest < h else BLUE, 4.5)
    d.text(graph.at(3.2, 4.2), "too large beside its neighbors", color=RED)
    return d


def clipped(x, h, end, g, top):
    """The end of a line from (x, h) with the slope g, away from x, that does not leave the picture."""
    length = min(abs(end - x), (top - h) / g)
    return (x + math.copysign(length, end - x), h + g * length)


def defects():
    """Four defects of surfaces: an intersection, a vertex on an edge, a fold, and a triangle without area."""
    d = Drawing(760, 215)
    at = lambda panel: (lambda x, y: (15 + 185 * panel + x, y))
    q = at(0)
    d.polygon([q(10, 150), q(120, 165), q(90, 60)], fill=LIGHT_BLUE, stroke=BLUE)
    d.polygon([q(40, 80), q(160, 110), q(60, 30)], fill=LIGHT_RED, stroke=BLUE, opacity=0.7)
    d.line(q(67, 87), q(102, 97), stroke=RED, width=3)
    q = at(1)
    d.polygon([q(10, 110), q(160, 110), q(85, 30)], fill=LIGHT_BLUE, stroke=BLUE)
    d.polygon([q(10, 110), q(80, 110), q(40, 175)], fill=LIGHT_BLUE, stroke=BLUE)
    d.polygon([q(80, 110), q(160, 110), q(130, 175)], fill=LIGHT_BLUE, stroke=BLUE)
    d.dot(q(80, 110), RED, 5)
    q = at(2)
    d.polygon([q(20, 150), q(150, 150), q(60, 30)], fill=LIGHT_BLUE, stroke=BLUE)
    d.polygon([q(20, 150), q(150, 150), q(110, 65)], fill=LIGHT_RED, stroke=BLUE, opacity=0.7)
    q = at(3)
    d.polygon([q(20, 60), q(150, 60), q(85, 150)], fill=LIGHT_BLUE, stroke=BLUE)
    d.line(q(20, 60), q(150, 60), stroke=RED, width=3)
    for x in (20, 85, 150):
        d.dot(q(x, 60), RED, 4)
    for panel, title in enumerate(["intersection", "vertex on an edge", "fold", "no area"]):
        d.text(at(panel)(85, 202), title, size=14)
    return d


def subdomains():
    """Triangles of four parts, of the zones around the seams of two parts, and of those around more, in the plane."""
    d = Drawing(760, 275)
    columns, rows, step = 9, 8, 26
    def place(i, j):
        inside = 0 < i < columns and 0 < j < rows
        return (10 + step * i + (4 * math.sin(5 * i + 3 * j) if inside else 0),
                15 + step * j + (4 * math.cos(4 * i + 7 * j) if inside else 0))
    def part(triangle):
        x, y = (sum(c) / 3 for c in zip(*(place(*v) for v in triangle)))
        return (x > 125 + 12 * math.sin(y / 25)) + 2 * (y > 120 + 10 * math.sin(x / 30))
    triangles = []
    for i in range(columns):
        for j in range(rows):
            a, b, c, e = (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)
            triangles += [(a, b, c), (a, c, e)] if (i + j) % 2 else [(a, b, e), (b, c, e)]
    parts = {}
    for t in triangles:
        for v in t:
            parts.setdefault(v, set()).add(part(t))
    many = [v for v in parts if len(parts[v]) > 2]
    near = lambda v: min(max(abs(v[0] - w[0]), abs(v[1] - w[1])) for w in many)
    for panel, title in enumerate(["parts", "seams of two parts", "where more parts meet"]):
        move = lambda q, x=252 * panel: (q[0] + x, q[1])
        for t in triangles:
            of_two = [parts[v] for v in t if len(parts[v]) == 2]
            fill = "#fff"
            if panel == 0:
                fill = (LIGHT_BLUE, LIGHT_ORANGE, LIGHT_GREEN, LIGHT_RED)[part(t)]
            elif panel == 1 and of_two and min(map(near, t)) > 1:
                fill = LIGHT_BLUE if of_two[0] in ({0, 1}, {2, 3}) else LIGHT_ORANGE
            elif panel == 2 and min(map(near, t)) <= 1:
                fill = LIGHT_GREEN
            d.polygon([move(place(*v)) for v in t], fill=fill, stroke=GREY, width=0.8)
        for t in triangles if panel == 0 else []:
            for v, w in ((t[0], t[1]), (t[1], t[2]), (t[0], t[2])):
                sides_of_edge = {part(u) for u in triangles if v in u and w in u}
                if len(sides_of_edge) == 2:
                    d.line(move(place(*v)), move(place(*w)), stroke=BLUE, width=2.4)
        d.text((127 + 252 * panel, 258), title, size=14)
    return d


FIGURES = {"shell.svg": shell, "recursion.svg": recursion, "conditions.svg": conditions,
           "conforming.svg": conforming, "splitting.svg": splitting, "cavity.svg": cavity, "source.svg": source,
           "grading.svg": grading, "defects.svg": defects, "subdomains.svg": subdomains}


def main(arguments):
    check = arguments[:1] == ["--check"]
    if len(arguments) != 1 + check:
        print(__doc__)
        return 1
    wrong = 0
    for name, draw in FIGURES.items():
        path, text = os.path.join(arguments[-1], name), draw().svg()
        if not check:
            with open(path, "w", encoding="utf-8", newline="\n") as file:
                file.write(text)
        elif not os.path.exists(path) or open(path, encoding="utf-8", newline="").read() != text:
            wrong += 1
            print("%s: missing, or not what is drawn" % path)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
