#!/usr/bin/env python3
"""Draws a tetrahedral mesh that is cut open, as SVG: boundary triangles in blue, what the cut lays bare in orange, and
Steiner points, the vertices that no boundary triangle has, as red dots.

usage: draw_cut_mesh.py IN.mesh OUT.svg [WIDTH]

recovered_gear.svg is the default surface of the program:
  recover_boundary -o gear.mesh && draw_cut_mesh.py gear.mesh recovered_gear.svg
recovered_schoenhardt.svg is the smallest surface of data/meshes that takes a point:
  recover_boundary schoenhardt_br3.off -o prism.mesh && draw_cut_mesh.py prism.mesh recovered_schoenhardt.svg 440

To cut it open, tetrahedra whose centroid lies to the right and to the front of the middle (larger x, smaller y) are left
out. Only Python's standard library is used.
"""
import math
import sys

AZIMUTH, ELEVATION, WIDTH, MARGIN = math.radians(-62), math.radians(38), 880, 8
BOUNDARY, INSIDE, LIGHT = (96, 141, 186), (240, 163, 74), (-0.35, -0.5, 0.79)


def read_medit(path):
    """Points, tetrahedra and boundary triangles."""
    with open(path) as file:
        tokens = iter(file.read().split())
    points, tetrahedra, triangles = [], [], []
    for word in tokens:
        if word == "Vertices":
            for _ in range(int(next(tokens))):
                points.append(tuple(float(next(tokens)) for _ in range(3)))
                next(tokens)
        elif word in ("Triangles", "Tetrahedra"):
            size, target = (3, triangles) if word == "Triangles" else (4, tetrahedra)
            for _ in range(int(next(tokens))):
                target.append(tuple(int(next(tokens)) - 1 for _ in range(size)))
                next(tokens)
    return points, tetrahedra, triangles


def minus(p, q):
    return tuple(a - b for a, b in zip(p, q))


def dot(p, q):
    return sum(a * b for a, b in zip(p, q))


def cross(p, q):
    return (p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0])


def normal(points, t):
    n = cross(minus(points[t[1]], points[t[0]]), minus(points[t[2]], points[t[0]]))
    length = math.sqrt(dot(n, n))
    return tuple(c / length for c in n) if length else None


def visible_skin(points, tetrahedra):
    """The outer triangles, turned outwards, of the tetrahedra that are kept."""
    middle = [(min(c) + max(c)) / 2 for c in zip(*points)]
    skin = {}
    for t in tetrahedra:
        centroid = [sum(points[v][i] for v in t) / 4 for i in range(3)]
        if centroid[0] > middle[0] and centroid[1] < middle[1]:
            continue
        for f in ((t[1], t[2], t[3]), (t[0], t[3], t[2]), (t[0], t[1], t[3]), (t[0], t[2], t[1])):
            key = frozenset(f)
            if key in skin:
                del skin[key]  # the other side is a tetrahedron that is kept, too
            else:
                skin[key] = f
    return skin


def project(points):
    """Orthogonal view: to the right, upwards, towards the eye."""
    eye = (math.cos(AZIMUTH) * math.cos(ELEVATION), math.sin(AZIMUTH) * math.cos(ELEVATION), math.sin(ELEVATION))
    right = (-math.sin(AZIMUTH), math.cos(AZIMUTH), 0.0)
    up = cross(eye, right)
    return [(dot(p, right), dot(p, up), dot(p, eye)) for p in points]


def clip(polygon, a, b):
    """The part of a convex polygon on the left of ab."""
    def side(p):
        return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
    out = []
    for p, q in zip(polygon, polygon[1:] + polygon[:1]):
        s, t = side(p), side(q)
        if s >= 0:
            out.append(p)
        if s * t < 0:
            out.append(tuple(x + (y - x) * s / (s - t) for x, y in zip(p, q)))
    return out


def depth(triangle, x, y):
    n = cross(minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0]))
    return triangle[0][2] - (n[0] * (x - triangle[0][0]) + n[1] * (y - triangle[0][1])) / n[2]


def is_behind(s, t, tolerance):
    """Whether triangle s is hidden by t somewhere, both counterclockwise as seen."""
    overlap = [p[:2] for p in s]
    for a, b in zip(t, t[1:] + t[:1]):
        overlap = clip(overlap, a, b)
        if len(overlap) < 3:
            return False
    area = sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(overlap, overlap[1:] + overlap[:1]))
    if area < tolerance * tolerance:
        return False
    x, y = (sum(c) / len(overlap) for c in zip(*overlap))
    return depth(t, x, y) - depth(s, x, y) > tolerance


def back_to_front(triangles, tolerance):
    """An order for painting. Where triangles hide each other in a circle, the farther centroid comes first."""
    n = len(triangles)
    boxes = [[f(p[i] for p in t) for i in (0, 1) for f in (min, max)] for t in triangles]
    behind = [set() for _ in range(n)]  # what is to be painted before
    for i in range(n):
        for j in range(n):
            a, b = boxes[i], boxes[j]
            if i != j and a[0] < b[1] and b[0] < a[1] and a[2] < b[3] and b[2] < a[3]:
                if is_behind(triangles[i], triangles[j], tolerance):
                    behind[j].add(i)
    rest = sorted(range(n), key=lambda i: sum(p[2] for p in triangles[i]))
    order = []
    while rest:
        chosen = [i for i in rest if not behind[i]] or rest[:1]
        order += chosen
        rest = [i for i in rest if i not in set(chosen)]
        for i in rest:
            behind[i].difference_update(chosen)
    return order


def colour(base, n):
    light = 0.62 + 0.38 * max(0.0, dot(n, LIGHT))
    return "#%02x%02x%02x" % tuple(min(255, round(c * light * 1.12)) for c in base)


def draw(points, tetrahedra, boundary, width):
    seen = project(points)
    given = {v for t in boundary for v in t}
    boundary = {frozenset(t) for t in boundary}
    faces = []
    for key, f in visible_skin(points, tetrahedra).items():
        n = normal(seen, f)
        if n and n[2] > 1e-6:  # else it turns its back on the eye
            faces.append((f, colour(BOUNDARY if key in boundary else INSIDE, normal(points, f))))
    used = [seen[v] for f, _ in faces for v in f]
    low, high = ([f(p[i] for p in used) for i in (0, 1)] for f in (min, max))
    scale = (width - 2 * MARGIN) / (high[0] - low[0])

    def corner(v):
        return MARGIN + (seen[v][0] - low[0]) * scale, MARGIN + (high[1] - seen[v][1]) * scale

    height = round((high[1] - low[1]) * scale + 2 * MARGIN)
    lines = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 %d %d" stroke="#23313f" stroke-width=".7" '
             'stroke-linejoin="round">' % (width, height), '<rect width="100%" height="100%" fill="#fff" stroke="none"/>']
    for i in back_to_front([[seen[v] for v in f] for f, _ in faces], 1e-4 * (high[0] - low[0])):
        f, fill = faces[i]
        lines.append('<path fill="%s" d="M%sz"/>' % (fill, " ".join("%.1f,%.1f" % corner(v) for v in f)))
    for v in sorted({v for f, _ in faces for v in f} - given):
        lines.append('<circle fill="#d0312d" cx="%.1f" cy="%.1f" r="5"/>' % corner(v))
    return "\n".join(lines + ["</svg>", ""])


def main(arguments):
    if len(arguments) not in (2, 3):
        print(__doc__)
        return 1
    picture = draw(*read_medit(arguments[0]), int(arguments[2]) if len(arguments) == 3 else WIDTH)
    with open(arguments[1], "w") as file:
        file.write(picture)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
