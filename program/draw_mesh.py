#!/usr/bin/env python3
"""Draws a tetrahedral mesh that is cut open, as SVG: boundary triangles in blue, what the cut lays bare in orange, and
Steiner points, the vertices that no boundary triangle has, as red dots if they are few.

usage: draw_mesh.py MESH OUT.svg [WIDTH] [--chart] [--cut X,Y,Z,D] [--view AZIMUTH,ELEVATION] [--around X,Y,Z,RADIUS]
                    [--window X,Y,Z,WIDTH,HEIGHT] [--angles | --references] [--strip MESH...]

MESH is a .vtu, .msh (Gmsh 4.1, text or binary) or .mesh file as mesh_surface writes it:
  mesh_surface part.stl -o part.vtu && draw_mesh.py part.vtu part.svg --chart
shows it cut open, in the colours of --angles, and below it how many tetrahedra have which smallest dihedral angle.

meshed_wing.svg is the default surface of mesh_surface, cut along the middle of the wing:
  mesh_surface -o wing.mesh
  draw_mesh.py wing.mesh meshed_wing.svg --cut 0,-1,0,0 --view -58,19
before_improvement.svg and after_improvement.svg are a part of it, without and with step 7, in colours:
  mesh_surface --no-improvement -o before.mesh && mesh_surface -o after.mesh
  draw_mesh.py before.mesh before_improvement.svg 620 --cut 0,-1,0,0 --view -90,0 --around 0.6,0,0,1.2 --angles
before_remeshing.svg, after_remeshing.svg and film_strip.svg are from benchmark_moving_body, the latter with fewer cells:
  benchmark_moving_body 100000 8 fine_ && benchmark_moving_body 30000 15 coarse_
  draw_mesh.py fine_08_before.mesh before_remeshing.svg 620 SAME --window 1.7,0,-2.9,8,6.8
  draw_mesh.py fine_08_after.mesh after_remeshing.svg 620 SAME --window 1.7,0,-2.9,8,6.8
  draw_mesh.py coarse_00_after.mesh film_strip.svg SAME --window 1.4,0,-3.6,6.5,11
    --strip coarse_04_after.mesh coarse_09_after.mesh coarse_15_after.mesh
where SAME is --cut 0,-1,0,0 --view -90,0 --references.
recovered_gear.svg is the default surface of recover_boundary:
  recover_boundary -o gear.mesh && draw_mesh.py gear.mesh recovered_gear.svg
recovered_schoenhardt.svg is the smallest surface of data/meshes that takes a point:
  recover_boundary schoenhardt_br3.off -o prism.mesh && draw_mesh.py prism.mesh recovered_schoenhardt.svg 440
The pages of the manual begin with these, of surfaces of data/meshes:
  mesh_surface two_cubes_br3.off --remesh-surface 0.2 --size 0.4 --sources left_cube.txt -o materials.mesh
  draw_mesh.py materials.mesh meshed_materials.svg 560 --references --cut 0,-1,0,-0.5 --view -60,25
  mesh_surface nut_br3.stl --repair --remesh-surface 0.3 --size 0.3 -o nut.vtu
  draw_mesh.py nut.vtu meshed_nut.svg 460 --cut 0.3,-1,0,0.5 --view -55,40
  mesh_surface wing_br3.off --sources wake.txt --grading 0.3 -o sources.mesh
  draw_mesh.py sources.mesh meshed_sources.svg 560 --cut 0,-1,0,0 --view -90,0 --around 2.3,0,0,1.5
  mesh_surface gear_br3.off --remesh-surface 0.9 -o gear.vtu
  draw_mesh.py gear.vtu meshed_gear.svg 560 --chart --view -60,35
with 'box 0 0 0 1 1 1 0.1 0 10' in left_cube.txt, and the sources of the example mesh_with_sources.cpp in wake.txt.

Without --cut, tetrahedra whose centroid lies to the right and to the front of the middle (larger x, smaller y) are left
out; with it, those whose centroid p has (X,Y,Z) * p > D. Surfaces inside the outer one are drawn as a whole all the same.
--view tells from where the mesh is seen, in degrees; --around draws only what is in a ball, --window only what is seen in
a rectangle around a place. With --angles, the colours of what the cut lays bare tell the smallest dihedral angle of the
tetrahedron: from red, 0 degrees, over yellow to green, 40 and more. With --references, tetrahedra with the reference 2 are
green, those with 3 red. --strip draws further meshes to the right of the first one. What is hidden is left out of the
file. Only Python's standard library is used.
"""
import argparse
import heapq
import math
import re
import struct
import sys

MARGIN, GAP, DOTS = 8, 4, 50
BOUNDARY, INSIDE, LIGHT = (96, 141, 186), (240, 163, 74), (-0.35, -0.5, 0.79)
REFERENCES = {2: (128, 190, 118), 3: (206, 52, 44)}
SCALE = 2  # of the numbers in the file: integers are short
BINS, DEGREES_PER_BIN, CHART = 15, 5, 150  # of the chart, and its height
SIZES = {"vtu": {10: 4, 24: 4, 5: 3, 22: 3}, "msh": {4: 4, 11: 4, 2: 3, 9: 3}}  # corners of each type of cells
NODES = {4: 4, 11: 10, 2: 3, 9: 6}  # of Gmsh's types


def read_medit(path):
    """Points, tetrahedra, their references, and boundary triangles."""
    with open(path) as file:
        tokens = iter(file.read().split())
    points, tetrahedra, references, triangles = [], [], {}, []
    for word in tokens:
        if word == "Vertices":
            for _ in range(int(next(tokens))):
                points.append(tuple(float(next(tokens)) for _ in range(3)))
                next(tokens)
        elif word in ("Triangles", "Tetrahedra"):
            size, target = (3, triangles) if word == "Triangles" else (4, tetrahedra)
            for _ in range(int(next(tokens))):
                target.append(tuple(int(next(tokens)) - 1 for _ in range(size)))
                reference = int(next(tokens))
                if size == 4:
                    references[target[-1]] = reference
    return points, tetrahedra, references, triangles


def read_vtu(path):
    """The same of a file whose arrays are raw bytes behind the XML; the array `region` has the references."""
    with open(path, "rb") as file:
        text, _, data = file.read().partition(b'<AppendedData encoding="raw">')
    text, data = text.decode(), data[data.index(b"_") + 1:]
    order = "<" if 'byte_order="LittleEndian"' in text else ">"

    def array(name):
        element = re.search(r'<DataArray[^>]*Name="%s"[^>]*>' % name, text).group()
        code = {"Float64": "d", "Int64": "q", "Int32": "i", "UInt8": "B"}[re.search(r'type="(\w+)"', element).group(1)]
        begin = int(re.search(r'offset="(\d+)"', element).group(1))
        size, = struct.unpack_from(order + "Q", data, begin)
        return struct.unpack_from("%s%d%s" % (order, size // struct.calcsize(code), code), data, begin + 8)
    names = re.findall(r'<Points>\s*<DataArray[^>]*Name="(\w+)"', text)
    x, corners, ends, types, regions = map(array, (names[0], "connectivity", "offsets", "types", "region"))
    points = [x[i:i + 3] for i in range(0, len(x), 3)]
    tetrahedra, references, triangles = [], {}, []
    for end, begin, kind, region in zip(ends, (0,) + ends, types, regions):
        cell = corners[begin:begin + SIZES["vtu"].get(kind, 0)]
        if len(cell) == 4:
            tetrahedra.append(cell)
            references[cell] = region
        elif len(cell) == 3:
            triangles.append(cell)
    return points, tetrahedra, references, triangles


class Words:
    """The numbers of a section of a .msh file, as text or binary."""
    def __init__(self, data, is_binary):
        self.data, self.is_binary, self.position = data if is_binary else data.split(), is_binary, 0

    def take(self, code, n=1):
        if self.is_binary:
            values = struct.unpack_from("=%d%s" % (n, code), self.data, self.position)
            self.position += struct.calcsize("=%d%s" % (n, code))
        else:
            values = tuple((float if code == "d" else int)(w) for w in self.data[self.position:self.position + n])
            self.position += n
        return values


def read_msh(path):
    """The same of Gmsh's format 4.1; volumes are the references."""
    with open(path, "rb") as file:
        data = file.read()
    version, kind, _ = data.split(b"\n", 2)[1].split()
    if version != b"4.1":
        raise ValueError("only version 4.1 of the format is read")

    def section(name):
        begin = data.index(b"$%s\n" % name) + len(name) + 2
        return Words(data[begin:data.index(b"\n$End%s" % name, begin)], kind == b"1")
    words, position, points = section(b"Nodes"), {}, []
    for _ in range(words.take("Q", 4)[0]):
        words.take("i", 3)
        n, = words.take("Q")
        for tag in words.take("Q", n):
            position[tag] = len(position)
        x = words.take("d", 3 * n)
        points += [x[i:i + 3] for i in range(0, len(x), 3)]
    words, tetrahedra, references, triangles = section(b"Elements"), [], {}, []
    for _ in range(words.take("Q", 4)[0]):
        _, entity, kind_of_cells = words.take("i", 3)
        n, = words.take("Q")
        width = 1 + NODES[kind_of_cells]
        numbers = words.take("Q", n * width)
        for i in range(0, n * width, width):
            cell = tuple(position[tag] for tag in numbers[i + 1:i + 1 + SIZES["msh"][kind_of_cells]])
            if len(cell) == 4:
                tetrahedra.append(cell)
                references[cell] = entity
            else:
                triangles.append(cell)
    return points, tetrahedra, references, triangles


def read_mesh(path):
    """Points, tetrahedra, their references, and boundary triangles of a file in any of the formats."""
    extension = path.rpartition(".")[2].lower()
    readers = {"mesh": read_medit, "vtu": read_vtu, "msh": read_msh}
    if extension not in readers:
        raise ValueError("it is none of .vtu, .msh, .mesh")
    return readers[extension](path)


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


def facets(t):
    """Those of a tetrahedron, turned outwards."""
    return (t[1], t[2], t[3]), (t[0], t[3], t[2]), (t[0], t[1], t[3]), (t[0], t[2], t[1])


def smallest_angle(points, t):
    """Of the dihedral angles of a tetrahedron, in degrees."""
    normals = [n for n in (normal(points, f) for f in facets(t)) if n]
    if len(normals) < 4:
        return 0
    largest_cosine = max(-dot(normals[i], normals[j]) for i in range(4) for j in range(i))
    return math.degrees(math.acos(max(-1, min(1, largest_cosine))))


def is_cut_off(points, cut):
    """A function that tells whether a tetrahedron is left out."""
    middle = [(min(c) + max(c)) / 2 for c in zip(*points)]

    def centroid(t):
        return [sum(points[v][i] for v in t) / 4 for i in range(3)]
    if cut:
        return lambda t: dot(cut[:3], centroid(t)) > cut[3]
    return lambda t: centroid(t)[0] > middle[0] and centroid(t)[1] < middle[1]


def outer_vertices(points, boundary):
    """The vertices of the boundary that are connected with the one at the very left."""
    parent = {v: v for t in boundary for v in t}

    def root(v):
        while parent[v] != v:
            parent[v] = parent[parent[v]]
            v = parent[v]
        return v
    for t in boundary:
        for v in t[1:]:
            parent[root(v)] = root(t[0])
    outer = root(min(parent, key=lambda v: points[v]))
    return {v for v in parent if root(v) == outer}


def visible_skin(points, tetrahedra, boundary, cut):
    """The outer triangles, turned outwards, of the tetrahedra that are kept, and inner surfaces as the others see them;
    each with its tetrahedron."""
    leave_out = is_cut_off(points, cut)
    outer = outer_vertices(points, boundary)
    boundary = {frozenset(t) for t in boundary}
    skin = {}
    for t in tetrahedra:
        is_left_out = leave_out(t)
        for f in facets(t):
            key = frozenset(f)
            if is_left_out:
                if key in boundary and f[0] not in outer:
                    skin[key] = f[::-1], t
            elif key in skin:
                del skin[key]  # the other side is a tetrahedron that is kept, too
            else:
                skin[key] = f, t
    return skin


def project(points, azimuth, elevation):
    """Orthogonal view: to the right, upwards, towards the eye."""
    a, e = math.radians(azimuth), math.radians(elevation)
    eye = (math.cos(a) * math.cos(e), math.sin(a) * math.cos(e), math.sin(e))
    right = (-math.sin(a), math.cos(a), 0.0)
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


def box(triangle):
    return [f(p[i] for p in triangle) for i in (0, 1) for f in (min, max)]


def span(triangle, y):
    """From where to where a triangle goes in the height y."""
    left, right = -math.inf, math.inf
    for a, b in zip(triangle, triangle[1:] + triangle[:1]):
        if a[1] != b[1]:
            x = a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1])
            left, right = (left, min(right, x)) if a[1] < b[1] else (max(left, x), right)
    return left, right


def shown(triangles, low, pixel):
    """The numbers of the triangles that are seen in some pixel."""
    nearest = {}
    for k, t in enumerate(triangles):
        y_low, y_high = box(t)[2:]
        slope = depth(t, 1, 0) - depth(t, 0, 0)
        for row in range(math.ceil((y_low - low[1]) / pixel), math.floor((y_high - low[1]) / pixel) + 1):
            y = low[1] + row * pixel
            left, right = span(t, y)
            z = depth(t, low[0], y)
            for column in range(math.ceil((left - low[0]) / pixel), math.floor((right - low[0]) / pixel) + 1):
                z_here = z + slope * column * pixel
                if (row, column) not in nearest or z_here > nearest[row, column][0]:
                    nearest[row, column] = (z_here, k)
    return sorted({k for _, k in nearest.values()})


def overlapping_boxes(boxes):
    """Pairs of numbers of boxes that overlap: a sweep from left to right, with those that are open in strips."""
    strip = 2 * sum(b[3] - b[2] for b in boxes) / len(boxes)
    strips, pairs = {}, set()
    for i in sorted(range(len(boxes)), key=lambda i: boxes[i][0]):
        a = boxes[i]
        for s in range(math.floor(a[2] / strip), math.floor(a[3] / strip) + 1):
            strips[s] = [j for j in strips.get(s, []) if boxes[j][1] > a[0]]
            pairs.update((j, i) for j in strips[s] if a[2] < boxes[j][3] and boxes[j][2] < a[3])
            strips[s].append(i)
    return pairs


def back_to_front(triangles, tolerance):
    """An order for painting. Where triangles hide each other in a circle, the farther centroid comes first."""
    before = [0] * len(triangles)  # how many are to be painted before
    after = [[] for _ in triangles]
    for pair in sorted(overlapping_boxes([box(t) for t in triangles])):
        for i, j in (pair, pair[::-1]):
            if is_behind(triangles[i], triangles[j], tolerance):
                after[i].append(j)
                before[j] += 1
    distance = [(sum(p[2] for p in t), i) for i, t in enumerate(triangles)]
    ready = [distance[i] for i in range(len(triangles)) if before[i] == 0]
    heapq.heapify(ready)
    rest = sorted(distance, reverse=True)
    order, is_done = [], [False] * len(triangles)
    while rest:
        _, i = heapq.heappop(ready) if ready else rest[-1]
        if not is_done[i]:
            is_done[i] = True
            order.append(i)
            for j in after[i]:
                before[j] -= 1
                if before[j] == 0:
                    heapq.heappush(ready, distance[j])
        while rest and is_done[rest[-1][1]]:
            rest.pop()
    return order


def colour(base, n):
    light = 0.62 + 0.38 * max(0.0, dot(n, LIGHT))
    return "#%02x%02x%02x" % tuple(min(255, round(c * light * 1.12)) for c in base)


def colour_of_angle(degrees):
    """From red over yellow to green."""
    x = min(1, degrees / 40)
    low, high, y = ((214, 48, 39), (254, 224, 120), 2 * x) if x < 0.5 else ((254, 224, 120), (90, 170, 100), 2 * x - 1)
    return tuple(a + (b - a) * y for a, b in zip(low, high))


def path(corners):
    """The first corner, and the ways from each to the next, as short as SVG has them."""
    ways = [minus(q, p) for p, q in zip(corners, corners[1:])]
    text = "M%d,%dl" % corners[0] + " ".join("%d,%d" % way for way in ways)
    return text.replace(" -", "-").replace(",-", "-") + "z"


def colour_of_cut(points, t, references, colours):
    """That of a facet of a tetrahedron."""
    if colours == "angles":
        return colour_of_angle(smallest_angle(points, t))
    return REFERENCES.get(references[t], INSIDE) if colours == "references" else INSIDE


def seen_part(seen, faces, options):
    """The lower left and the upper right corner of the picture, in the coordinates of the view."""
    if options.window:
        center = project([options.window[:3]], *options.view)[0]
        return [[center[i] + sign * options.window[3 + i] / 2 for i in (0, 1)] for sign in (-1, 1)]
    used = [seen[v] for f, _ in faces for v in f]
    return [[f(p[i] for p in used) for i in (0, 1)] for f in (min, max)]


def draw(path_of_mesh, left, width, options):
    """The height of the picture, and its lines."""
    points, tetrahedra, references, boundary = read_mesh(path_of_mesh)
    seen = project(points, *options.view)
    given = {v for t in boundary for v in t}
    is_boundary = {frozenset(t) for t in boundary}
    faces = []
    for key, (f, t) in visible_skin(points, tetrahedra, boundary, options.cut).items():
        n = normal(seen, f)
        around = options.around
        is_near = around is None or all(math.dist(points[v], around[:3]) < around[3] for v in f)
        if n and n[2] > 1e-6 and is_near:  # else it turns its back on the eye
            inside = colour_of_cut(points, t, references, options.colours)
            faces.append((f, colour(BOUNDARY if key in is_boundary else inside, normal(points, f))))
    low, high = seen_part(seen, faces, options)
    faces = [face for face in faces if all(min(seen[v][i] for v in face[0]) < high[i] and
                                           max(seen[v][i] for v in face[0]) > low[i] for i in (0, 1))]
    scale = (width - 2 * MARGIN) / (high[0] - low[0])
    faces = [faces[k] for k in shown([[seen[v] for v in f] for f, _ in faces], low, 0.5 / scale)]

    def corner(v):
        return (round(SCALE * (MARGIN + (seen[v][0] - low[0]) * scale)),
                round(SCALE * (MARGIN + (high[1] - seen[v][1]) * scale)))

    height = round((high[1] - low[1]) * scale + 2 * MARGIN)
    lines = ['<svg x="%d" width="%d" height="%d" stroke="#23313f" stroke-width="%g" stroke-linejoin="round">'
             % (SCALE * left, SCALE * width, SCALE * height, SCALE * (0.7 if len(faces) < 1000 and not options.strip else 0.35))]
    if options.window:  # a margin on all sides
        lines[0] = lines[0].replace("<svg", '<svg viewBox="%d %d %d %d"' % (
            SCALE * MARGIN, SCALE * MARGIN, SCALE * (width - 2 * MARGIN), SCALE * (height - 2 * MARGIN)))
    for i in back_to_front([[seen[v] for v in f] for f, _ in faces], 1e-4 * (high[0] - low[0])):
        f, fill = faces[i]
        lines.append('<path fill="%s" d="%s"/>' % (fill, path([corner(v) for v in f])))
    dots = sorted({v for f, _ in faces for v in f} - given)
    for v in dots if len(dots) <= DOTS else []:
        lines.append('<circle fill="#d0312d" cx="%d" cy="%d" r="%d"/>' % (*corner(v), SCALE * 5))
    lines.append("</svg>")
    if options.chart:
        lines += draw_chart([smallest_angle(points, t) for t in tetrahedra], left, height, width)
        height += CHART
    return height, lines


def draw_chart(angles, left, top, width):
    """Bars for the numbers of tetrahedra with smallest dihedral angles of 0 to 5 degrees, and so on."""
    counts = [0] * BINS
    for angle in angles:
        counts[min(BINS - 1, int(angle / DEGREES_PER_BIN))] += 1
    lines = ['<svg x="%d" y="%d" width="%d" height="%d" viewBox="0 0 %d %d" font-family="sans-serif" font-size="11">'
             % (SCALE * left, SCALE * top, SCALE * width, SCALE * CHART, width, CHART)]

    def text(x, y, words, anchor="middle"):
        lines.append('<text x="%d" y="%d" text-anchor="%s">%s</text>' % (x, y, anchor, words))
    step, bottom, highest = (width - 4 * MARGIN) / BINS, CHART - 34, CHART - 66
    for k, n in enumerate(counts):
        x, h = 2 * MARGIN + k * step, highest * n / max(1, max(counts))
        lines.append('<rect x="%.1f" y="%.1f" width="%.1f" height="%.2f" fill="%s"><title>%d</title></rect>' % (
            x + 1, bottom - h, step - 2, h, colour(colour_of_angle(DEGREES_PER_BIN * (k + 0.5)), LIGHT), n))
        text(x, bottom + 14, "%d" % (DEGREES_PER_BIN * k))
        if n:
            text(x + step / 2, bottom - h - 4, "%d" % n)
    text(width / 2, CHART - 6, "smallest dihedral angle in degrees, of %d tetrahedra: from %.3g" % (
        len(angles), min(angles, default=0)))
    return lines + ["</svg>"]


def draw_strip(options):
    meshes, left, parts, height = [options.mesh] + options.strip, 0, [], 0
    width = round((options.width - GAP * (len(meshes) - 1)) / len(meshes))
    for mesh in meshes:
        height, lines = draw(mesh, left, width, options)
        parts += lines
        left += width + GAP
    return "\n".join(['<svg xmlns="http://www.w3.org/2000/svg" width="%d" height="%d" viewBox="0 0 %d %d">'
                      % (left - GAP, height, SCALE * (left - GAP), SCALE * height),
                      '<rect width="100%" height="100%" fill="#fff"/>'] + parts + ["</svg>", ""])


def main():
    def numbers(text):
        return tuple(map(float, text.split(",")))
    # a list of numbers may begin with a minus sign: it must not be taken for an option
    arguments = [" " + a if a[:1] == "-" and a[1:2].isdigit() else a for a in sys.argv[1:]]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh")
    parser.add_argument("picture")
    parser.add_argument("width", nargs="?", type=int, default=880)
    parser.add_argument("--cut", type=numbers)
    parser.add_argument("--view", type=numbers, default=(-62, 38))
    parser.add_argument("--around", type=numbers)
    parser.add_argument("--window", type=numbers)
    parser.add_argument("--chart", action="store_true")
    parser.add_argument("--angles", action="store_const", dest="colours", const="angles")
    parser.add_argument("--references", action="store_const", dest="colours", const="references")
    parser.add_argument("--strip", nargs="+", default=[])
    options = parser.parse_args(arguments)
    if options.chart and not options.colours:
        options.colours = "angles"
    try:
        picture = draw_strip(options)
        with open(options.picture, "w", encoding="utf-8") as file:
            file.write(picture)
    except (OSError, ValueError, KeyError, IndexError, AttributeError, struct.error) as error:
        print("draw_mesh.py: %s: %s" % (options.mesh, error), file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
