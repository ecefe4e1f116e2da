#!/usr/bin/env python3
"""Runs the program mesh_surface with surfaces that are open, that cross themselves, and that are folded.

usage: test_faulty_surfaces_br3.py PROGRAM

Every mesh is read back by parsers of program_tests.py and checked with exact rational arithmetic. What needs CGAL 6 is
skipped, with a word, where the program is compiled with an older one.
"""
import functools
import math
import random
import re
import sys

sys.dont_write_bytecode = True  # the folder of the sources stays as it is
from program_tests import *

MESHED, NO_REGION = RECOVERED, INCOMPLETE
MESH_ONLY = ['--no-field-points']


# ---------------------------------------------------------------- surfaces

def without(surface, *faces):
    return surface[0], [f for i, f in enumerate(surface[1]) if i not in faces]


def tube(n, radius=1.0, height=4.0):
    """the wall of a prism, open at both ends: loops of n edges"""
    ring = [(radius * math.cos(2 * math.pi * i / n), radius * math.sin(2 * math.pi * i / n)) for i in range(n)]
    points = [(x, y, z) for z in (0.0, height) for x, y in ring]
    faces = []
    for i in range(n):
        j = (i + 1) % n
        faces += [(i, j, n + j), (i, n + j, n + i)]
    return points, faces


def folded_box():
    """a box with a grid of points on its top, one of which is moved over an edge, and all are up or down a little"""
    points, faces = grid_box(3)
    points = [(x, y, z + 1e-7 * ((7 * i) % 5 - 2) if z == 1 and 0 < x < 1 and 0 < y < 1 else z)
              for i, (x, y, z) in enumerate(points)]
    moved = points.index(next(p for p in points if abs(p[0] - 1 / 3) + abs(p[1] - 1 / 3) < 1e-9 and p[2] > 0.5))
    points[moved] = (0.9, 0.37, points[moved][2])
    return points, faces


def crumbled(surface, distance):
    """each triangle has points of its own, moved at random"""
    generator = random.Random(1)
    points = [tuple(x + distance * generator.uniform(-1, 1) for x in surface[0][v]) for f in surface[1] for v in f]
    return points, [(i, i + 1, i + 2) for i in range(0, len(points), 3)]


def overlapping_boxes():
    return join(box((0, 0, 0), (4, 4, 4)), box((2, 2, 2), (6, 6, 6)))


# ---------------------------------------------------------------- runs

def mesh(name, surface, *arguments, status=MESHED):
    """the mesh, checked, and the report"""
    report = report_of(write(name + '.off', off_text(*surface)), '-o', name + '.mesh', *arguments, status=status)
    result = read_mesh(name + '.mesh')
    check_tetrahedra(result)
    return result, report


def volumes(result):
    return sorted(volume_of_regions(result).values())


@functools.lru_cache(maxsize=None)
def repair_of_boxes():
    surface = write('boxes_of_test.off', off_text(*overlapping_boxes()))
    return report_of(surface, '--repair', *MESH_ONLY, status=run(surface, '--repair', *MESH_ONLY).returncode)


def resolves_intersections():
    if repair_of_boxes()['repair']['can_resolve_intersections']:
        return True
    print('skipped: the program is compiled with CGAL %s, which cannot do that' % repair_of_boxes()['cgal_version'])
    return False


# ---------------------------------------------------------------- open surfaces

def test_open_surface_is_explained():
    surface = without(box((0, 0, 0), (3, 4, 12)), 0)
    name = write('open.off', off_text(*surface))
    process = run(name, status=NO_REGION)
    assert 'the surface bounds no region' in process.err and 'open along 1 loop ' in process.err
    assert re.search(r'a loop of 3 edges, 12 long, between \(0 0 0\) and \(3 4 0\)', process.err), process.err
    assert '--close-holes' in process.err
    report = report_of(name, status=NO_REGION)
    loop, = report['boundary_loops']
    assert loop['is_closed'] and loop['number_of_edges'] == 3 and loop['length'] == 12
    assert loop['box'] == [0, 0, 0, 3, 4, 0] and len(set(loop['vertices'])) == 3
    assert report['facets_that_bound_nothing'] == list(range(len(surface[1])))


def test_longest_loops_are_shown():
    # each of five boxes lacks a triangle; two boxes have a common vertex where they are open
    boxes = [without(box((20 * i, 0, 0), (20 * i + 1 + i, 1, 1)), 0) for i in range(5)]
    name = write('five.off', off_text(*join(*boxes)))
    err = run(name, status=NO_REGION).err
    assert err.count('  a loop of 3 edges') == 3 and 'open along 5 loops' in err
    assert 'and 2 more: --report lists all of them' in err and 'touch' not in err
    lengths = [loop['length'] for loop in report_of(name, status=NO_REGION)['boundary_loops']]
    assert len(lengths) == 5 and lengths == sorted(lengths, reverse=True)

    first, second = without(box((0, 0, 0), (1, 1, 1)), 0), without(box((0, 0, 0), (-1, -1, -1), outward=False), 0)
    report = report_of(write('touching.off', off_text(*join(first, second))), status=NO_REGION)
    assert [loop['number_of_edges'] for loop in report['boundary_loops']] == [3, 3]
    assert report['number_of_branching_boundary_vertices'] == 1
    assert 'touch' in run('touching.off', status=NO_REGION).err


def test_chain_of_open_edges():
    # a flag at an edge of a box: three of the edges of the flag are open, and do not close
    points, faces = box((0, 0, 0), (1, 1, 1))
    flag = points + [(0, -1, 0), (1, -1, 0)], faces + [(0, 1, 8), (1, 9, 8)]
    report = report_of(write('flag.off', off_text(*flag)), status=MESHED)
    loop, = report['boundary_loops']
    assert not loop['is_closed'] and loop['number_of_edges'] == 3 and loop['length'] == 3
    assert report['facets_that_bound_nothing'] == [12, 13]
    assert 'a chain that does not close of 3 edges' in run('flag.off', status=MESHED).err
    process = run('flag.off', '--close-holes', status=MESHED)
    assert '0 loops closed' in process.out and 'stays open: it does not close' in process.out


def test_triangles_that_bound_nothing():
    closed, hull = box((4, 4, 4), (5, 5, 5)), without(box((0, 0, 0), (10, 10, 10)), 3)
    name = write('hull.off', off_text(*join(hull, closed)))
    process = run(name, status=MESHED)
    assert 'warning: 11 of 23 triangles bound nothing' in process.err and '(0 0 0) and (10 10 10)' in process.err
    assert 'facet 0, 1, 2, ...' in process.err and 'open along 1 loop ' in process.err
    report = report_of(name, status=MESHED)
    assert report['facets_that_bound_nothing'] == list(range(11)) and report['number_of_regions'] == 1
    assert run(name, '--quiet', status=MESHED).err == ''

    # a sheet inside of a region is there on purpose
    sheet = [(1, 1, 1), (2, 1, 1), (1, 2, 1)], [(0, 1, 2)]
    name = write('sheet.off', off_text(*join(box((0, 0, 0), (10, 10, 10)), sheet)))
    assert run(name, status=MESHED).err == ''
    report = report_of(name, status=MESHED)
    assert report['number_of_facets_inside_regions'] == 1 and report['facets_that_bound_nothing'] == []
    assert report['boundary_loops'] == []


# ---------------------------------------------------------------- closing of holes

def test_holes_are_closed():
    for surface in (without(box((0, 0, 0), (1, 2, 4)), 5), without(grid_box(4), 3, 40, 41, 90), tube(7), tube(300)):
        name = write('holes.off', off_text(*surface))
        number = len(report_of(name, status=NO_REGION)['boundary_loops'])
        process = run(name, '--close-holes', *MESH_ONLY, status=MESHED)
        assert 'holes: %d loop' % number in process.out and process.err == ''
        result, report = mesh('holes', surface, '--close-holes', *MESH_ONLY)
        assert [hole['state'] for hole in report['holes']] == ['closed'] * number
        added = sum(hole['number_of_added_triangles'] for hole in report['holes'])
        assert len(result.triangles) == len(surface[1]) + added and added > 0
        assert result.triangles[:len(surface[1])] == surface[1] and result.points[:len(surface[0])] == surface[0]
        boundary = result.triangles
        assert volumes(result) == [signed_volume(result.points, boundary)]  # closed, and turned alike


def test_length_of_holes():
    surface = join(without(box((0, 0, 0), (1, 1, 1)), 0), without(box((5, 0, 0), (9, 4, 4)), 0))
    for arguments, regions in ((['--close-holes', '5'], 1), (['--close-holes=5'], 1), (['--close-holes', '20'], 2),
                               (['--close-holes'], 2)):
        report = mesh('two', surface, *arguments, *MESH_ONLY)[1]
        assert report['number_of_regions'] == regions and len(report['holes']) == 2
    assert 'stays open: it is longer than allowed' in run('two.off', '--close-holes', '5', status=MESHED).out
    # the length may be left out before the name of the file
    run('--close-holes', 'two.off', *MESH_ONLY, status=MESHED)
    run('two.off', '--close-holes', '-o', 'two.vtu', *MESH_ONLY, status=MESHED)
    run('two.off', '--close-holes', '1', *MESH_ONLY, status=NO_REGION)
    check_file_error('two.off', '--close-holes', '-1')


def test_filling_that_would_cross():
    # a spike through the hole
    spike = [(1.5, 1, -2), (2.5, 1, -2), (2, 2, -2), (2, 1.3, 2)], [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]
    lid = {i for i, f in enumerate(box((0, 0, 0), (4, 4, 4))[1]) if all(box((0, 0, 0), (4, 4, 4))[0][v][2] == 0 for v in f)}
    surface = join(without(box((0, 0, 0), (4, 4, 4)), *lid), spike)
    process = run(write('spike.off', off_text(*surface)), '--close-holes', *MESH_ONLY, status=MESHED)
    assert '0 loops closed' in process.out and 'a loop of 4 edges, 16 long' in process.out, process.out
    assert 'stays open: its filling would cross the surface' in process.out and 'bound nothing' in process.err
    report = report_of('spike.off', '--close-holes', *MESH_ONLY, status=MESHED)
    assert report['number_of_regions'] == 1 and report['holes'][0]['number_of_added_triangles'] == 0
    # a lone triangle would be closed by itself
    alone = join(box((0, 0, 0), (1, 1, 1)), ([(3, 0, 0), (4, 0, 0), (3, 1, 0)], [(0, 1, 2)]))
    assert '0 loops closed' in run(write('alone.off', off_text(*alone)), '--close-holes', status=MESHED).out


# ---------------------------------------------------------------- refusals

def test_refusals_name_what_helps():
    points, faces = box((0, 0, 0), (1, 1, 1))
    twice = run(write('twice.off', off_text(points, faces + faces[:5])), status=INVALID_INPUT).err
    assert '5 defects: 5 duplicate_facet' in twice and twice.count('\n  duplicate_facet') == 3
    assert 'and 2 more: --report' in twice and '--repair may help' in twice
    far = run(write('nan.off', off_text(points, faces).replace('1 1 1', '1 nan 1')), status=INVALID_INPUT).err
    assert '--repair' not in far and 'no option' in far
    crossing = run(write('crossing.off', off_text(*overlapping_boxes())), status=INVALID_INPUT).err
    assert '--repair' in crossing and ('CGAL 6' in crossing) != resolves_intersections()
    both = without(overlapping_boxes(), 1)
    err = run(write('both.off', off_text(*both)), status=INVALID_INPUT).err
    assert '--repair' in err and 'open along 1 loop' in err and '--close-holes may help' in err


# ---------------------------------------------------------------- repair

def test_flat_fold_is_unfolded():
    surface = folded_box()
    check_invalid(write('folded.off', off_text(*surface)), 'intersecting_constraints')
    result, report = mesh('folded', surface, '--repair')
    changes = report['repair']
    assert report['number_of_regions'] == 1 and changes['number_of_intersections_after'] == 0
    assert changes['number_of_unfolded_facets'] == len(changes['unfolded_facets']) > 0
    assert changes['number_of_new_points'] == 0 and changes['number_of_open_edges_after'] == 0
    assert report['min_dihedral_angle'] > 1 and abs(float(volumes(result)[0]) / 6 - 1) < 1e-6
    kept = [p for i, p in enumerate(surface[0]) if i not in changes['unfolded_vertices']]
    assert report['facets_that_bound_nothing'] == [] and result.points[:len(kept)] == kept
    assert 'folded flat replaced' in run('folded.off', '--repair', status=MESHED).out
    changes = report_of('folded.off', '--repair', '--tolerance', '0',
                        status=run('folded.off', '--repair', '--tolerance', '0').returncode)['repair']
    assert changes['unfolded_facets'] == []


def test_wide_gaps_are_closed():
    # gaps are wider than the tolerance of the default: it is tried to divide triangles at points beside their edges, and
    # points are beside many
    surface = grid_box(4)
    scaled = [tuple(20 * x for x in p) for p in surface[0]], surface[1]
    name = write('crumbled.off', off_text(*crumbled(scaled, 1e-5)))
    assert 'or --repair where points that should be equal' in run(name, status=INVALID_INPUT).err
    err = run(name, '--repair', status=NO_REGION if resolves_intersections() else INVALID_INPUT).err
    assert 'or a larger --tolerance where points' in err
    assert ('--repair was not enough; a larger --tolerance' in err) != resolves_intersections()
    result, report = mesh('crumbled', crumbled(scaled, 1e-5), '--repair', '--tolerance', '1e-4')
    assert report['number_of_regions'] == 1 and report['facets_that_bound_nothing'] == []
    assert abs(float(volumes(result)[0]) / 6 / 8000 - 1) < 1e-5


def test_dust_is_no_region():
    if not resolves_intersections():
        return
    # a tip of one body is just inside of the other one: their overlap is dust, and so is not a region
    for depth, regions in ((1e-4, 2), (1.0, 3)):
        needle = [(1, 1, 4 - depth), (0, 0, 9), (3, 0, 9), (0, 3, 9)], [(0, 2, 1), (0, 3, 2), (0, 1, 3), (1, 2, 3)]
        result, report = mesh('tip', join(box((0, 0, 0), (4, 4, 4)), needle), '--repair', *MESH_ONLY)
        assert report['number_of_regions'] == regions, (depth, report['number_of_regions'])
        assert (report['repair']['number_of_dust_regions'] > 0) == (regions == 2)
        assert report['facets_that_bound_nothing'] == []
        smallest = float(volumes(result)[0]) / 6
        assert smallest > 1e-6 * 64

    # what is small and was not made by intersections stays
    small = box((8, 8, 8), (8.001, 8.001, 8.001))
    report = mesh('small', join(overlapping_boxes(), small), '--repair', *MESH_ONLY)[1]
    assert report['number_of_regions'] == 4 and report['repair']['number_of_dust_regions'] == 0


def test_fold_leaves_no_triangle():
    if not resolves_intersections():
        return
    # the top of a box, whose triangles overlap a part of each other exactly in its plane: there and back
    points, faces = grid_box(2)
    top = next(i for i, p in enumerate(points) if p == (0.5, 0.5, 1))
    points[top] = (1.25, 0.5, 1.0)  # beyond the rim
    report = mesh('rim', (points, faces), '--repair', '--tolerance', '0', *MESH_ONLY)[1]
    assert report['number_of_regions'] == 1 and report['repair']['number_of_intersections_after'] == 0
    assert report['facets_that_bound_nothing'] == [] and report['number_of_facets_inside_regions'] == 0


def test_resolving_noise_ends():
    if not resolves_intersections():
        return
    # triangles between a few vertices, some of them nearly equal: rounded points make more and more intersections
    generator = random.Random(19)
    points = [tuple(10 * generator.randint(0, 3) + 1e-6 * generator.uniform(-1, 1) for _ in range(3)) for _ in range(9)]
    faces = [tuple(generator.sample(range(9), 3)) for _ in range(80)]
    changes = report_of(write('noise.off', off_text(points, faces)), '--repair', *MESH_ONLY,
                        status=INVALID_INPUT)['repair']
    assert 0 < changes['number_of_intersections_after'] < changes['number_of_intersections_before']


# ---------------------------------------------------------------- fusion

def test_fusion():
    if not resolves_intersections():
        return
    result, report = mesh('fused', overlapping_boxes(), '--repair', '--fuse', *MESH_ONLY)
    assert volumes(result) == [6 * 120] and report['repair']['is_fused'] and report['repair']['divided_facets']
    assert signed_volume(result.points, result.triangles) == 6 * 120
    # a box inside is a part of the union, a void is none; what lies apart stays; faces in common go
    for surface, expected in (
            (join(box((0, 0, 0), (3, 3, 3)), box((1, 1, 1), (2, 2, 2))), [27]),
            (join(box((0, 0, 0), (3, 3, 3)), box((1, 1, 1), (2, 2, 2), outward=False)), [26]),
            (join(box((0, 0, 0), (3, 3, 3)), box((5, 1, 1), (6, 2, 2))), [1, 27]),
            (join(box((0, 0, 0), (3, 3, 3)), box((3, 0, 0), (6, 3, 3))), [54]),
            (join(box((0, 0, 0), (3, 3, 3)), box((1, 1, 3), (2, 2, 4))), [28])):
        result, report = mesh('union', surface, '--repair', '--fuse', *MESH_ONLY)
        assert volumes(result) == [6 * v for v in expected], (volumes(result), expected)
        assert report['repair']['is_fused'] and report['facets_that_bound_nothing'] == []
    result, report = mesh('inner', join(box((0, 0, 0), (3, 3, 3)), box((1, 1, 1), (2, 2, 2))), '--repair', '--fuse')
    assert report['repair']['inner_facets'] == list(range(12, 24))
    check_file_error('inner.off', '--fuse')


def test_fusion_needs_an_inside():
    # two boxes with a common wall that is there once: there are no winding numbers
    points, faces = box((0, 0, 0), (1, 1, 1))
    shifted = [(x + 1, y, z) for x, y, z in points]
    number = {p: i for i, p in enumerate(points)}
    all_points = points + [p for p in shifted if p not in number]
    number.update({p: i for i, p in enumerate(all_points)})
    second = [tuple(number[shifted[v]] for v in f) for f in faces]
    wall = {frozenset(f) for f in faces}
    surface = all_points, faces + [f for f in second if frozenset(f) not in wall]
    result, report = mesh('wall', surface, '--repair', '--fuse', *MESH_ONLY)
    assert not report['repair']['is_fused'] and volumes(result) == [6, 6]
    assert 'not fused' in run('wall.off', '--repair', '--fuse', *MESH_ONLY, status=MESHED).out

    # what bounds nothing is lost inside of a body only
    opened = without(box((0, 0, 0), (1, 1, 1)), 0)
    report = report_of(write('opened.off', off_text(*opened)), '--repair', '--fuse', status=NO_REGION)
    assert not report['repair']['is_fused'] and report['repair']['source_facets'] == list(range(11))
    assert volumes(mesh('opened', opened, '--repair', '--fuse', '--close-holes')[0]) == [6]
    sheets = [([(x, 1, 1), (x + 0.5, 1, 1), (x, 1.5, 1)], [(0, 1, 2)]) for x in (1.0, 4.0)]
    result, report = mesh('sheets', join(box((0, 0, 0), (3, 3, 3)), *sheets), '--repair', '--fuse')
    assert report['repair']['is_fused'] and report['repair']['inner_facets'] == [12]
    assert report['facets_that_bound_nothing'] == [13] and volumes(result) == [6 * 27]
    assert report['repair']['number_of_open_edges_after'] == 3


if __name__ == '__main__':
    run_tests(__doc__, globals())
