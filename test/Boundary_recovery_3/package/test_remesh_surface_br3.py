#!/usr/bin/env python3
"""Runs mesh_surface with --remesh-surface on surfaces of needles, and checks the surface of the mesh.

usage: test_remesh_surface_br3.py PROGRAM
"""
import collections
import math
import sys

sys.dont_write_bytecode = True  # the folder of the sources stays as it is
from program_tests import *

MESHED = RECOVERED


# ---------------------------------------------------------------- surfaces

def cylinder(n, height=2):
    """a cylinder of radius 1, with needles: no vertex between its ends"""
    ring = [(math.cos(2 * math.pi * i / n), math.sin(2 * math.pi * i / n)) for i in range(n)]
    points = [(x, y, z) for z in (0, height) for x, y in ring] + [(0, 0, 0), (0, 0, height)]
    faces = []
    for i in range(n):
        j = (i + 1) % n
        faces += [(i, j, n + j), (i, n + j, n + i), (2 * n, j, i), (2 * n + 1, n + i, n + j)]
    return points, faces


def boxes_with_a_common_wall():
    """two flat boxes, one beside the other: three triangles meet at the border of their wall"""
    points = [(x, y, z) for x in (0, 1, 3) for y in (0, 1) for z in (0, 0.05)]

    def quad(a, b, c, d):
        return [(a, b, c), (a, c, d)]

    faces = quad(0, 1, 3, 2) + quad(4, 6, 7, 5) + quad(8, 10, 11, 9)  # x = 0, 1, 3
    for k in (0, 4):
        faces += quad(k, k + 4, k + 5, k + 1) + quad(k + 2, k + 3, k + 7, k + 6)  # y = 0, 1
        faces += quad(k, k + 2, k + 6, k + 4) + quad(k + 1, k + 5, k + 7, k + 3)  # z
    return points, faces


# ---------------------------------------------------------------- measures

def distance(p, q):
    return math.dist(p, q)


def angles(points, face):
    a, b, c = (distance(points[face[i - 2]], points[face[i - 1]]) for i in range(3))
    for x, y, z in ((a, b, c), (b, c, a), (c, a, b)):
        yield math.degrees(math.acos(max(-1, min(1, (y * y + z * z - x * x) / (2 * y * z)))))


def smallest_angle(points, faces):
    return min(a for f in faces for a in angles(points, f))


def edges(faces):
    """how many faces each edge has"""
    return collections.Counter(frozenset(e) for f in faces for e in ((f[0], f[1]), (f[1], f[2]), (f[2], f[0])))


def remesh(name, surface, *arguments):
    """the mesh, checked, and the entry of the report"""
    report = report_of(write(name + '.off', off_text(*surface)), '-o', name + '.mesh', '-o', name + '.vtu',
                       '--remesh-surface', *arguments, status=MESHED)
    result = read_mesh(name + '.mesh')
    check_tetrahedra(result)
    entry = report['remeshing']
    assert entry['is_possible'] and entry['is_remeshed'], entry
    assert entry['number_of_triangles_before'] == len(surface[1])
    assert entry['number_of_triangles_after'] == len(result.triangles)
    assert max(entry['distance_to_input'], entry['distance_from_input']) <= entry['tolerance']
    assert math.isclose(entry['smallest_angle_of_triangles_after'], smallest_angle(result.points, result.triangles),
                        rel_tol=1e-4, abs_tol=1e-4)
    return result, report


# ---------------------------------------------------------------- tests

def test_needles_of_a_cylinder():
    points, faces = cylinder(200)
    assert smallest_angle(points, faces) < 1
    result, report = remesh('cylinder', (points, faces))
    entry = report['remeshing']
    assert math.isclose(entry['tolerance'], 1e-3 * math.sqrt(12), rel_tol=1e-2)
    assert smallest_angle(result.points, result.triangles) > 10 and report['min_dihedral_angle'] > 10
    assert set(edges(result.triangles).values()) == {2}
    for x, y, z in (result.points[v] for v in set(v for f in result.triangles for v in f)):
        r = math.hypot(x, y)
        assert -1e-9 <= z <= 2 + 1e-9 and r <= 1 + 1e-9
        assert z in (0, 2) or abs(r - 1) <= entry['tolerance'], 'every vertex is on the cylinder, or at its ends'


def test_sharp_edges_and_patches_stay():
    """the edges of a box are covered by edges of the new surface, and each of its sides is a patch"""
    points, faces = box((0, 0, 0), (10, 1, 0.2))
    result, report = remesh('box', (points, faces))
    assert result.points[:8] == [tuple(map(float, p)) for p in points], 'corners stay, and come first'
    assert smallest_angle(result.points, result.triangles) > 15
    of_side = collections.defaultdict(set)
    for f, patch in zip(result.triangles, result.patches):
        corners = [result.points[v] for v in f]
        sides = [(i, c) for i, high in enumerate((10, 1, 0.2)) for c in (0, high) if all(p[i] == c for p in corners)]
        assert len(sides) == 1, corners
        of_side[sides[0]].add(patch)
    assert len(of_side) == 6 and all(len(p) == 1 for p in of_side.values())
    assert len(set.union(*of_side.values())) == 6


def test_labels_divide_what_is_flat():
    """two names on one side of a box: the border between them stays, where nothing is sharp"""
    points, faces = box((0, 0, 0), (1, 1, 1))
    n, sides = len(points), faces[2:4]  # z = 1, to be divided at x = 0.3
    assert all(points[v][2] == 1 for f in sides for v in f), sides
    points = points + [(0.3, 0, 1), (0.3, 1, 1)]
    text = ''.join('v %r %r %r\n' % tuple(p) for p in points)

    def triangle(a, b, c):
        return 'f %d %d %d\n' % (a + 1, b + 1, c + 1)

    text += 'g left\n' + triangle(4, n, n + 1) + triangle(4, n + 1, 6)
    text += 'g right\n' + triangle(n, 5, 7) + triangle(n, 7, n + 1)
    text += 'g rest\n'
    for f in faces[:2] + faces[4:]:
        edge = next((k for k in range(3) if {f[k], f[(k + 1) % 3]} in ({4, 5}, {6, 7})), None)
        if edge is None:
            text += triangle(*f)
        else:
            a, b, c = f[edge], f[(edge + 1) % 3], f[(edge + 2) % 3]
            m = n if {a, b} == {4, 5} else n + 1
            text += triangle(a, m, c) + triangle(m, b, c)
    report = report_of(write('names.obj', text), '-o', 'names.mesh', '--remesh-surface', '0.15', status=MESHED)
    assert report['remeshing']['is_remeshed']
    result = read_mesh('names.mesh')
    check_tetrahedra(result)
    assert len(set(result.patches)) == 3
    of_place = collections.defaultdict(set)
    for f, patch in zip(result.triangles, result.patches):
        corners = [result.points[v] for v in f]
        xs = [p[0] for p in corners]
        place = 'rest'
        if all(p[2] == 1 for p in corners):
            assert max(xs) <= 0.3 or min(xs) >= 0.3, corners
            place = 'left' if max(xs) <= 0.3 else 'right'
        of_place[place].add(patch)
    assert sorted(map(len, of_place.values())) == [1, 1, 1] and len(set.union(*of_place.values())) == 3


def test_largest_edge():
    points, faces = box((0, 0, 0), (1, 1, 1))
    coarse, _ = remesh('coarse', (points, faces))
    fine, report = remesh('fine', (points, faces), '0.1')
    assert report['remeshing']['largest_edge'] == 0.1
    for e in edges(fine.triangles):
        assert distance(*(fine.points[v] for v in e)) <= 0.1 + 1e-12
    assert len(fine.triangles) > len(coarse.triangles)
    assert smallest_angle(fine.points, fine.triangles) > 20


def test_three_triangles_at_an_edge():
    """both sides of a common wall stay conforming"""
    result, report = remesh('wall', boxes_with_a_common_wall())
    assert report['number_of_regions'] == 2
    wall = [f for f in result.triangles if all(result.points[v][0] == 1 for v in f)]
    assert wall and set(edges(result.triangles).values()) == {2, 3}
    for e, n in edges(result.triangles).items():
        p, q = (result.points[v] for v in e)
        border = p[0] == q[0] == 1 and (p[1] == q[1] in (0, 1) or p[2] == q[2] in (0, 0.05))
        assert (n == 3) == border, (p, q)
    assert smallest_angle(result.points, result.triangles) > 10


def test_open_sheet_stays():
    """a sheet inside: its border stays where it is"""
    sheet = ([(0.2, 0.2, 0.5), (0.8, 0.2, 0.5), (0.8, 0.8, 0.5), (0.2, 0.8, 0.5)], [(0, 1, 2), (0, 2, 3)])
    result, _ = remesh('sheet', join(box((0, 0, 0), (1, 1, 1)), sheet))
    counts = edges(result.triangles)
    border = [e for e, n in counts.items() if n == 1]
    length = sum(distance(*(result.points[v] for v in e)) for e in border)
    assert math.isclose(length, 2.4, rel_tol=1e-9), length


def test_small_steps_go():
    """a step of a ten-thousandth of the tolerance is none: no needles are left of it"""
    h = 1e-7
    points = [(x, y, z) for y in (0, 1) for x, z in ((0, 0), (2, 0), (2, 1), (1, 1), (1, 1 + h), (0, 1 + h))]
    outline = [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5)]
    faces = outline + [tuple(v + 6 for v in reversed(f)) for f in outline]
    for i in range(6):
        j = (i + 1) % 6
        faces += [(j, i, i + 6), (j, i + 6, j + 6)]
    result, report = remesh('step', (points, faces))
    assert smallest_angle(result.points, result.triangles) > 15 and report['min_dihedral_angle'] > 10


def test_same_input_same_output():
    write('a.off', off_text(*cylinder(60)))
    for name in 'first', 'second':
        run('a.off', '-o', name + '.mesh', '--remesh-surface', '--quiet', status=MESHED)
    assert read('first.mesh') == read('second.mesh')


def test_needles_are_never_replaced_by_default():
    """but the option is suggested where they matter"""
    points, faces = cylinder(300)
    write('needles.off', off_text(points, faces))
    process = run('needles.off', '-o', 'needles.mesh', status=MESHED)
    assert read_mesh('needles.mesh').triangles == [tuple(f) for f in faces]
    assert '--remesh-surface' in process.out, process.out
    process = run('needles.off', '-o', 'good.mesh', '--remesh-surface', status=MESHED)
    assert 'remeshing of the surface' in process.out and '--remesh-surface' not in process.out, process.out


def test_invalid_surfaces_are_left_alone():
    """what intersects itself is refused as it is"""
    points, faces = join(box((0, 0, 0), (2, 2, 2)), box((1, 1, 1), (3, 3, 3)))
    write('crossing.off', off_text(points, faces))
    process = run('crossing.off', '--remesh-surface', status=INVALID_INPUT)
    assert 'the surface is not valid' in process.out, process.out
    assert not report_of('crossing.off', '--remesh-surface', status=INVALID_INPUT)['remeshing']['is_possible']


def test_numbers_that_make_no_sense():
    write('box.off', off_text(*box((0, 0, 0), (1, 1, 1))))
    for number in '-1', 'nan':
        check_file_error('box.off', '--remesh-surface', number)
    report = report_of('box.off', '--remesh-surface', '1e-9', status=MESHED)
    assert report['remeshing']['is_too_fine'] and report['number_of_triangles'] == 12


if __name__ == '__main__':
    run_tests(__doc__, globals())
