#!/usr/bin/env python3
"""Writes one shape refined to about as many triangles as one likes, as a closed surface in OFF.

usage: refined_surface.py knot|plate TRIANGLES FILE.off

`knot`: a tube along a trefoil knot; its points are moved pseudo-randomly, and its quads are long, so many edges are lost.
`plate`: a plate with a round hole as a CAD program would mesh it: flat sides, walls of triangles four times as high as wide.
"""
import math
import random
import sys


def trefoil(t):
    return (math.sin(t) + 2 * math.sin(2 * t), math.cos(t) - 2 * math.cos(2 * t), -math.sin(3 * t))


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return tuple(x / length for x in v)


def cross(u, v):
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def knot(triangles):
    """The quads are three times as long along the tube as across it."""
    around = max(6, round(math.sqrt(triangles / 2 / 5.0)))
    along = max(24, round(triangles / 2 / around))
    rng, points, faces = random.Random(5), [], []
    for i in range(along):
        for j in range(around):
            t = 2 * math.pi * (i + 0.3 * (rng.random() - 0.5)) / along
            a = 2 * math.pi * (j + 0.3 * (rng.random() - 0.5)) / around
            p, h = trefoil(t), 1e-4
            tangent = unit(tuple(x - y for x, y in zip(trefoil(t + h), trefoil(t - h))))
            side = unit(cross(tangent, (p[1], -p[0], 3.0)))
            other = cross(tangent, side)
            radius = 0.35 + 0.05 * math.sin(9 * t)
            points.append(tuple(c + radius * (math.cos(a) * s + math.sin(a) * o) for c, s, o in zip(p, side, other)))
    grid(faces, along, around, lambda i, j: (i % along) * around + j % around)
    return points, faces


def grid(faces, rows, columns, vertex):
    for i in range(rows):
        for j in range(columns):
            a, b, c, d = vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)
            faces.extend([(a, b, c), (a, c, d)] if (i + j) % 2 else [(a, b, d), (b, c, d)])


def plate(triangles):
    """Rings of points around the hole, on both sides; the inner rings are moved in their planes."""
    around = max(8, round(math.sqrt(triangles * 2.0)))
    rings = max(2, round(triangles / 4 / around))
    rows = max(1, rings // 8)
    rng, points, faces = random.Random(7), [], []

    def radius(k):
        return 1 + 2 * k / rings

    def add(k, height, moved):
        first = len(points)
        for j in range(around):
            a = 2 * math.pi * (j + (0.4 * (rng.random() - 0.5) if moved else 0)) / around
            r = radius(k + (0.4 * (rng.random() - 0.5) if moved else 0))
            points.append((r * math.cos(a), r * math.sin(a), height))
        return first

    loop = [add(k, 0.0, 0 < k < rings) for k in range(rings + 1)]            # the lower side, outwards
    loop += [add(rings, 0.3 * k / rows, False) for k in range(1, rows)]      # the outer wall, upwards
    loop += [add(rings - k, 0.3, 0 < k < rings) for k in range(rings + 1)]   # the upper side, inwards
    loop += [add(0, 0.3 * (1 - k / rows), False) for k in range(1, rows)]    # the wall of the hole, downwards
    grid(faces, len(loop), around, lambda i, j: loop[i % len(loop)] + j % around)
    return points, faces


FAMILIES = {"knot": knot, "plate": plate}


def write(family, triangles, path):
    points, faces = FAMILIES[family](triangles)
    with open(path, "w", encoding="ascii") as file:
        file.write("OFF\n%d %d 0\n" % (len(points), len(faces)))
        file.writelines("%.17g %.17g %.17g\n" % p for p in points)
        file.writelines("3 %d %d %d\n" % f for f in faces)


if __name__ == "__main__":
    if len(sys.argv) != 4 or sys.argv[1] not in FAMILIES:
        sys.exit(__doc__)
    write(sys.argv[1], int(sys.argv[2]), sys.argv[3])
