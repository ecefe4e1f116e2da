#!/usr/bin/env python3
"""Runs the example program mesh_surface and checks what it writes, prints and returns.

usage: test_mesh_surface_br3.py PROGRAM

Every mesh is read back by parsers of program_tests.py and checked with exact rational arithmetic. Gmsh and VTK read them,
too, where they are installed.
"""
import collections
import copy
import itertools
import json
import math
import os
import re
import shutil
import subprocess
import sys
import time
import xml.etree.ElementTree

sys.dont_write_bytecode = True  # the folder of the sources stays as it is
import program_tests
from program_tests import *
# what the programs do alike
from test_program_br3 import (test_binary_off, test_coordinates_are_kept, test_files, test_input_formats,
                              test_input_is_not_overwritten, test_intersections, test_invalid_coordinates,
                              test_invalid_faces, test_line_ends, test_pipe, test_repair_drops_duplicates_and_turns,
                              test_summary_that_cannot_be_written)

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.append(os.path.join(HERE, '..', 'corpus'))
from check_certificate import Certificate_checker, Wrong

DRAW_QUALITY = os.path.join(HERE, '..', '..', '..', 'program', 'draw_quality.py')
MESHED = RECOVERED
SECONDS = re.compile(rb'("seconds[a-z_]*": )[^,}]*')  # of a report


# ---------------------------------------------------------------- surfaces

def two_regions():
    """a box in a box, a box beside, a sheet inside and a triangle that bounds nothing"""
    sheets = ([(0.2, 0.2, 0.2), (0.4, 0.2, 0.2), (0.2, 0.5, 0.2), (9, 9, 9), (10, 9, 9), (9, 10, 9)],
              [(0, 1, 2), (3, 4, 5)])
    return join(box((1, 1, 1), (2, 2, 2)), box((0, 0, 0), (3, 3, 3)), box((5, 0, 0), (6, 1, 1)), sheets)


def mesh(name, surface, *arguments, status=MESHED):
    """the mesh of a surface, checked, and the report"""
    points, faces = surface
    report = report_of(write(name + '.off', off_text(points, faces)), '-o', name + '.mesh', '-o', name + '.vtu', *arguments,
                       status=status)
    result = read_vtu(name + '.vtu')
    assert result == read_mesh(name + '.mesh')
    check_tetrahedra(result)
    assert result.points[:len(points)] == [tuple(map(float, p)) for p in points]
    assert result.triangles == [tuple(f) for f in faces] and result.numbers == list(range(len(faces)))
    assert min(result.regions) > 0
    return result, report


# ---------------------------------------------------------------- other readers

def reads_with_gmsh():
    if shutil.which('gmsh'):
        return True
    print('skipped: gmsh is not installed')
    return False


def gmsh(*arguments):
    process = subprocess.run(['gmsh', '-v', '2', *arguments], capture_output=True, timeout=300, stdin=subprocess.DEVNULL)
    assert process.returncode == 0 and b'Error' not in process.stdout + process.stderr, process
    return (process.stdout + process.stderr).decode()


# ---------------------------------------------------------------- tests of the formats

def test_formats():
    surface = two_regions()
    run(write('two.off', off_text(*surface)), '--size', '0.8', '-o', 'two.mesh', '-o', 'two.msh', '-o', 'two.vtu', '-o',
        'two.vtk', status=MESHED)
    expected = read_mesh('two.mesh')
    assert read_vtu('two.vtu') == expected and read_vtk('two.vtk') == expected
    found = read_msh('two.msh')
    assert found.mesh == expected and found.volumes == ['region_%d' % r for r in expected.regions]

    # patches by sharp edges: the sides of the boxes, and two sheets
    assert found.patches == ['patch_%d' % (1 + i // 2 if i < 36 else i - 17) for i in range(38)]

    # nodes of the surface are on a surface, all others in the volume of their tetrahedra
    on_surface = {v for t in expected.triangles for v in t}
    for t, region in zip(expected.tetrahedra, expected.regions):
        assert all(found.owners[v] == (3, region) for v in t if v not in on_surface)
    assert all(found.owners[v][0] == 2 for v in on_surface)


def test_gmsh_reads_the_mesh():
    if not reads_with_gmsh():
        return
    run(write('two.off', off_text(*two_regions())), '--size', '0.8', '-o', 'two.msh', '-o', 'two.mesh', status=MESHED)
    messages = gmsh('-check', 'two.msh')
    assert 'duplicate' not in messages.lower() and 'volume' not in messages, messages
    ours = read_msh('two.msh')
    gmsh('two.msh', '-save', '-format', 'msh41', '-bin', '-o', 'again.msh')
    theirs = read_msh('again.msh')
    assert theirs.mesh[:4] == ours.mesh[:4] and theirs[1:] == ours[1:]
    write('patches.geo', 'Merge "two.msh";\nSave View[1] "patches.msh";\n')
    gmsh('patches.geo', '-')
    lines = read('patches.msh').decode().split('$ElementData\n')[1].split('\n')
    begin = 0
    for _ in range(3):  # texts, real numbers, integers
        begin += 1 + int(lines[begin])
    elements = len(ours.mesh.triangles) + len(ours.mesh.tetrahedra)
    assert int(lines[begin - 1]) == elements
    values = sorted(tuple(map(float, line.split())) for line in lines[begin:begin + elements])
    assert values == list(enumerate(ours.mesh.numbers + [-1] * len(ours.mesh.tetrahedra), 1))

    # it reads MEDIT's format, too, and takes references for entities
    gmsh('two.mesh', '-save', '-format', 'msh2', '-o', 'medit.msh')
    words = read('medit.msh').decode().split('$Elements\n')[1].split('\n')
    elements = [tuple(map(int, line.split())) for line in words[1:1 + int(words[0])]]
    count = collections.Counter((e[1], e[4]) for e in elements if e[1] in (2, 4))
    mesh = ours.mesh
    assert count == collections.Counter([(2, p) for p in mesh.patches] + [(4, r) for r in mesh.regions])


# ---------------------------------------------------------------- tests of what is meshed

def test_regions():
    surface = two_regions()
    result, report = mesh('two', surface, '--size', '0.8')
    volumes = volume_of_regions(result)
    assert report['number_of_regions'] == 3 and sorted(volumes.values()) == [6, 6, 6 * 26]
    facets = facets_of(result.tetrahedra)
    boundary = {f for f, n in facets.items() if n == 1}
    assert boundary == {frozenset(f) for f in surface[1][12:36]}
    assert all(facets[frozenset(f)] == 2 for f in surface[1][:12] + surface[1][36:37])
    void = join(box((0, 0, 0), (3, 3, 3)), box((1, 1, 1), (2, 2, 2), outward=False))
    result, report = mesh('void', void)
    check_domain(result, *void)
    assert set(result.regions) == {1} and report['number_of_regions'] == 1


def test_order_of_points():
    points, faces = schonhardt()
    result, report = mesh('twisted', (points, faces), '--size', '0.4', '--no-improvement')
    check_domain(result, points, faces)
    n, steiner, field = len(points), report['number_of_steiner_points_in_domain'], report['number_of_field_points']
    assert steiner > 0 and field > 0 and len(result.points) == n + steiner + field
    assert all(list(p) in report['steiner_points'] for p in result.points[n:n + steiner])
    assert not any(list(p) in report['steiner_points'] for p in result.points[n + steiner:])


def test_no_field_points():
    surface = box((0, 0, 0), (3, 4, 5))
    for sizes in ([], ['--size', '0.1']):
        result, report = mesh('box', surface, '--no-field-points', *sizes)
        check_domain(result, *surface)
        assert len(result.points) == 8 and report['number_of_field_points'] == 0 and not report['insert_field_points']


def number_of_points_inside(report):
    """what the field points became"""
    improvement = report['improvement']
    return (report['number_of_field_points'] + improvement['number_of_inserted_points']
            - improvement['number_of_removed_vertices'])


def size_of_sources(sources, background):
    """the size field, in floating point numbers"""
    def size(p):
        return min([background] + [s + growth * max(0, math.dist(p, q) - radius) for q, s, radius, growth in sources])
    return size


def check_number(n, values, low, high):
    """as many of the values are from low to high; of those at the limits, rounding decides"""
    assert sum(low + 1e-9 < x < high - 1e-9 for x in values) <= n <= sum(low - 1e-9 < x < high + 1e-9 for x in values)


def check_edges(result, report, size):
    """the report says the same of the edges inside as the mesh"""
    on_surface = {frozenset((t[i], t[i - 1])) for t in result.triangles for i in range(3)}
    inside = {frozenset((t[i], t[j])) for t in result.tetrahedra for i in range(4) for j in range(i)} - on_surface
    ratios = []
    for edge in inside:
        p, q = (result.points[v] for v in edge)
        ratios.append(math.dist(p, q) / size(tuple((x + y) / 2 for x, y in zip(p, q))))
    assert report['number_of_edges_inside'] == len(ratios)
    for name, low, high in (('below', 0, 0.5 ** 0.5), ('in', 0.5 ** 0.5, 2 ** 0.5), ('above', 2 ** 0.5, math.inf)):
        check_number(report['number_of_edges_%s_size' % name], ratios, low, high)
    assert math.isclose(report['mean_length_by_size'], sum(ratios) / len(ratios), rel_tol=1e-9)
    assert math.isclose(report['max_length_by_size'], max(ratios), rel_tol=1e-9)
    return report['number_of_edges_in_size'] / len(ratios)


def test_sizes():
    surface = grid_box(5)
    result, report = mesh('uniform', surface, '--size', '0.2')
    check_domain(result, *surface)
    assert report['size'] == 0.2 and check_edges(result, report, lambda p: 0.2) > 0.7
    n = len(result.tetrahedra)
    assert n / 2 < report['forecast_of_tetrahedra'] < 2 * n and report['number_of_field_points'] > 0
    result, report = mesh('coarse', surface, '--size', '10')
    coarse = len(result.tetrahedra)  # the surface is finer
    assert report['number_of_field_points'] < 10 and coarse < n
    result, report = mesh('default', surface)  # edges of the surface have lengths from 0.2 to 0.28
    check_domain(result, *surface)
    assert report['size'] is None and report['grading'] == 0.3
    assert max(n / 4, coarse) < len(result.tetrahedra) < n
    uniform, _ = mesh('flat', surface, '--grading', '0')
    assert len(uniform.tetrahedra) > len(result.tetrahedra)


def test_sources():
    surface = grid_box(3)
    sources = [((0.5, 0.5, 0.5), 0.05, 0.1, 0.3), ((0.1, 0.9, 0.5), 0.1, 0, 0.5), ((7, 7, 7), 0.01, 0.5, 0.1)]
    write('sources.txt', '# a comment\n\n' + ''.join('point %r %r %r %r %r %r\n' % (*p, *rest) for p, *rest in sources))
    result, report = mesh('sources', surface, '--size', '0.3', '--sources', 'sources.txt')
    check_domain(result, *surface)
    assert report['sources'] == 'sources.txt'
    assert check_edges(result, report, size_of_sources(sources, 0.3)) > 0.5
    without, _ = mesh('without', surface, '--size', '0.3')
    assert len(result.tetrahedra) > 3 * len(without.tetrahedra)
    near = sum(math.dist(p, sources[0][0]) < 0.25 for p in result.points)
    assert near > len(result.points) / 3
    result, report = mesh('both', surface, '--sources', 'sources.txt')  # and the sizes of the surface
    check_domain(result, *surface)
    assert len(result.tetrahedra) > 3 * len(without.tetrahedra)
    write('all.txt', 'segment 0 0 0 1 1 1 0.2 0.1 0.2\ntriangle 0 0 0 1 0 0 0 1 0 0.2 0 0.3 # one side\n'
          'box 0.2 0.2 0.2 0.4 0.4 0.4 0.1 0 doubling 0.5\n')
    result, report = mesh('all', surface, '--size', '0.5', '--sources', 'all.txt')
    check_domain(result, *surface)
    for line, text in ((1, 'ball 0 0 0 1 1 1'), (2, '\npoint 0 0 0 1 1'), (1, 'point 0 0 0 -1 1 1'), (1, 'point 0 0 0 0 1 1'),
                       (3, '#\n#\npoint 0 0 0 1 -1 1'), (1, 'point 0 0 x 1 1 1'), (2, 'point 0 0 0 1 1 1\nbox 1 2 3 4'),
                       (1, 'point 0 0 0 1 1 1 1'), (1, 'point 0 0 0 nan 1 1')):
        write('wrong.txt', text + '\n')
        error = check_file_error('sources.off', '--size', '1', '--sources', 'wrong.txt')
        assert 'wrong.txt' in error and 'line %d' % line in error, error
    assert 'nowhere.txt' in check_file_error('sources.off', '--sources', 'nowhere.txt')
    os.mkdir('folder.txt')
    assert 'folder.txt' in check_file_error('sources.off', '--sources', 'folder.txt')


def test_small_source():
    """it is far smaller than the cells around it, and grows steeply: nothing near it tells of it"""
    name, place = write('grid.off', off_text(*grid_box(10))), (0.2888, 0.1825, 0.4168)
    write('small.txt', 'point %r %r %r 0.0008 0.005 3\n' % place)
    arguments = '--size', '0.1', '--sources', 'small.txt', '--no-improvement'
    numbers = []
    for number in ('1', '2', '3', '4', '8'):
        report = report_of(name, *arguments, '--subdomains', number, '-o', 'small.mesh', status=MESHED)
        result = read_mesh('small.mesh')
        assert report['is_field_resolved'] and report['number_of_meshed_subdomains'] == int(number)
        assert min(math.dist(p, place) for p in result.points) < 0.0008
        numbers.append(len(result.points))
        assert 0.8 * numbers[0] < numbers[-1] < 1.2 * numbers[0]
    error = run(name, *arguments, '--subdomains', '8', '--max-vertices', '1000', status=INCOMPLETE).err
    assert 'and 1000 vertices are allowed' in error


def grid(n):
    """the points and tetrahedra of the unit cube, divided into n * n * n cubes of six tetrahedra each"""
    points = [(x / n, y / n, z / n) for x in range(n + 1) for y in range(n + 1) for z in range(n + 1)]
    tetrahedra = []
    for x, y, z in itertools.product(range(n), repeat=3):
        for order in itertools.permutations(range(3)):
            p, t = [x, y, z], []
            for axis in (None, *order):
                if axis is not None:
                    p[axis] += 1
                t.append((p[0] * (n + 1) + p[1]) * (n + 1) + p[2])
            tetrahedra.append(t)
    return points, tetrahedra


def test_background():
    surface = grid_box(3)
    points, tetrahedra = grid(2)
    sizes = [0.05 + 0.4 * p[0] for p in points]
    write('sizes.mesh', 'MeshVersionFormatted 2\nDimension 3\nVertices\n%d\n' % len(points)
          + ''.join('%r %r %r 0\n' % p for p in points) + 'Tetrahedra\n%d\n' % len(tetrahedra)
          + ''.join(' '.join(str(v + 1) for v in t) + ' 1\n' for t in tetrahedra) + 'End\n')
    write('sizes.sol', 'MeshVersionFormatted 2\nDimension 3\nSolAtVertices\n%d\n1 1\n' % len(points)
          + ''.join('%r\n' % size for size in sizes) + 'End\n')
    result, report = mesh('background', surface, '--size', '0.3', '--background', 'sizes.mesh')
    check_domain(result, *surface)
    assert report['background'] == 'sizes.mesh' and report['is_field_resolved']
    assert check_edges(result, report, lambda p: min(0.3, 0.05 + 0.4 * p[0])) > 0.5  # linear sizes are interpolated exactly
    left = sum(p[0] < 0.3 for p in result.points)
    assert left > len(result.points) / 2

    write('tetgen.node', '%d 3 0 0\n' % len(points) + ''.join('%d %r %r %r\n' % (i, *p) for i, p in enumerate(points)))
    write('tetgen.ele', '%d 4 0\n' % len(tetrahedra)
          + ''.join('%d %d %d %d %d\n' % (i, *t) for i, t in enumerate(tetrahedra)))
    write('tetgen.mtr', '%d 1\n' % len(points) + ''.join('%r\n' % size for size in sizes))
    for extension in ('.node', '.ele', '.mtr'):
        run('background.off', '--size', '0.3', '--background', 'tetgen' + extension, '-o', 'tetgen.msh', status=MESHED)
        assert read_msh('tetgen.msh').mesh == result
    sol = read('sizes.sol').decode()
    coarse, _ = mesh('graded', surface, '--size', '0.3', '--background', 'sizes.mesh', '--grading', '0.1')
    assert len(coarse.tetrahedra) > len(result.tetrahedra)

    for old, new, where in (('SolAtVertices\n27', 'SolAtVertices\n26', '26 sizes'), ('\n0.05\n', '\n-1\n', 'line 6'),
                            ('\n0.05\n', '\nx\n', 'line 6')):
        write('sizes.sol', sol.replace(old, new, 1))
        error = check_file_error('background.off', '--background', 'sizes.mesh')
        assert 'sizes.mesh' in error and where in error, error
    os.remove('sizes.sol')
    for name in ('sizes.mesh', 'sizes.sol', 'nowhere.mesh', 'nowhere.node', 'sizes.off', 'sizes'):
        assert name in check_file_error('background.off', '--background', name)
    write('sizes.sol', sol)
    os.symlink('sizes.sol', 'link.vtk')
    for output in ('sizes.mesh', 'link.vtk'):
        assert 'overwritten' in check_file_error('background.off', '--background', 'sizes.mesh', '-o', output)
    assert read('sizes.sol').decode() == sol


def dihedral_angles(points):
    """those of a tetrahedron, in degrees, by other formulas than those of the program"""
    def minus(p, q):
        return [x - y for x, y in zip(p, q)]

    def dot(p, q):
        return sum(x * y for x, y in zip(p, q))
    for i in range(4):
        for j in range(i):
            k, l = [v for v in range(4) if v not in (i, j)]
            axis = minus(points[j], points[i])
            u, v = [[x - dot(d, axis) / dot(axis, axis) * y for x, y in zip(d, axis)]
                    for d in (minus(points[k], points[i]), minus(points[l], points[i]))]
            yield math.degrees(math.acos(max(-1, min(1, dot(u, v) / math.sqrt(dot(u, u) * dot(v, v))))))


def test_quality_in_report():
    result, report = mesh('quality', grid_box(3), '--size', '0.3')
    angles = [list(dihedral_angles([result.points[v] for v in t])) for t in result.tetrahedra]
    all_angles = sorted(a for six in angles for a in six)
    assert math.isclose(report['min_dihedral_angle'], all_angles[0], abs_tol=1e-6)
    assert math.isclose(report['max_dihedral_angle'], all_angles[-1], abs_tol=1e-6)
    histogram = report['histogram_of_dihedral_angles']
    assert len(histogram) == 18 and sum(histogram) == len(all_angles)
    for i, n in enumerate(histogram):
        check_number(n, all_angles, 10 * i, 10 * i + 10)
    for name, numbers in (('below', (5, 10, 15, 20)), ('above', (150, 160, 170))):
        counts = report['tetrahedra_with_angle_' + name]
        assert sorted(counts) == sorted(map(str, numbers))
        for x in numbers:
            extremes = [min(six) if name == 'below' else max(six) for six in angles]
            check_number(counts[str(x)], extremes, -1 if name == 'below' else x, x if name == 'below' else 181)


def wedge(degrees):
    """a prism that is thin at the edge on the x axis"""
    ring = [(0, 0), (3, 0), (3 * math.cos(math.radians(degrees)), 3 * math.sin(math.radians(degrees)))]
    points = [(x, *p) for p in ring for x in (0, 1, 2)]
    faces = [(0, 3, 1), (1, 3, 4), (1, 4, 2), (2, 4, 5), (0, 1, 6), (1, 7, 6), (1, 2, 7), (2, 8, 7), (3, 6, 4), (4, 6, 7),
             (4, 7, 5), (5, 7, 8), (0, 6, 3), (2, 5, 8)]
    return points, faces


def check_certificate(name, report, surface):
    """what the report says of the tetrahedra that stayed bad, and of all of them"""
    result = read_mesh(name)
    checker = Certificate_checker(report, surface, (result.points, result.tetrahedra))
    checker()
    after = report['improvement']['after']
    smallest = [min(dihedral_angles([result.points[v] for v in t])) for t in result.tetrahedra]
    assert after['number_of_tetrahedra'] == len(smallest) and len(after['histogram_of_smallest_angles']) == 18
    for i, n in enumerate(after['histogram_of_smallest_angles']):
        check_number(n, smallest, 5 * i, 5 * i + 5)
    assert math.isclose(after['min_dihedral_angle'], min(smallest), abs_tol=1e-6)
    for key in ('tetrahedra_with_angle_below', 'tetrahedra_with_angle_above', 'max_dihedral_angle'):
        assert after[key] == report[key] or math.isclose(after[key], report[key], abs_tol=1e-6)
    assert after['min_dihedral_angle'] >= report['improvement']['before']['min_dihedral_angle']
    return report['improvement']['bad_tetrahedra']


def test_certificate():
    points, faces = wedge(8)
    spare = [(7, 7, 7)] + points, [tuple(v + 1 for v in f) for f in faces]  # a point that no triangle has
    for name, surface in (('wedge.off', (points, faces)), ('spare.off', spare)):
        report = report_of(write(name, off_text(*surface)), '-o', 'wedge.mesh', status=MESHED)
        bad = check_certificate('wedge.mesh', report, surface)
        forced = [entry for entry in bad if entry['reason'] == 'forced']
        assert forced and report['improvement']['target_angle'] == 25
        assert all(math.isclose(entry['surface_angle'], 8, rel_tol=1e-9) for entry in forced)
        triangles = {tuple(sorted(facet['triangle'] for facet in entry['facets'])) for entry in forced}
        assert triangles == {(0, 4), (2, 6)}  # those at the edges on the axis
    for target in (7.9, 0):
        report = report_of('wedge.off', '--min-angle', str(target), '-o', 'low.mesh', status=MESHED)
        check_certificate('low.mesh', report, (points, faces))
        assert report['improvement']['target_angle'] == target and report['improvement']['number_of_forced'] == 0
    box = grid_box(3)
    report = report_of(write('grid.off', off_text(*box)), '--size', '0.2', '-o', 'grid.mesh', '--min-angle', '30',
                       status=MESHED)
    check_certificate('grid.mesh', report, box)
    assert report['improvement']['number_of_forced'] == 0

    # the check notices what is wrong
    report = report_of('wedge.off', '-o', 'wedge.mesh', status=MESHED)
    position = next(i for i, entry in enumerate(report['improvement']['bad_tetrahedra']) if entry['reason'] == 'forced')

    def change_entry(**changes):
        return lambda improvement: improvement['bad_tetrahedra'][position].update(changes)
    for change in (change_entry(surface_angle=9), change_entry(reason='needle'), change_entry(min_dihedral_angle=1),
                   lambda improvement: improvement['bad_tetrahedra'][position]['facets'][0].update(triangle=12),
                   lambda improvement: improvement['bad_tetrahedra'].pop(), lambda improvement: improvement.update(target_angle=7)):
        wrong = copy.deepcopy(report)
        change(wrong['improvement'])
        try:
            check_certificate('wedge.mesh', wrong, (points, faces))
        except Wrong:
            continue
        assert False, change


def plates(distance):
    """a square plate of 18 triangles on each side"""
    points = [(x + 0.1 * (y % 2), y + 0.07 * (x % 2), z) for z in (0, distance) for y in range(4) for x in range(4)]
    faces = []
    for y in range(3):
        for x in range(3):
            p, q, r, s = (4 * y + x + k for k in (0, 1, 4, 5))
            faces += [(p, r, q), (q, r, s), (16 + p, 16 + q, 16 + r), (16 + q, 16 + s, 16 + r)]
    rim = [0, 1, 2, 3, 7, 11, 15, 14, 13, 12, 8, 4]
    for p, q in zip(rim, rim[1:] + rim[:1]):
        faces += [(p, q, 16 + p), (q, 16 + q, 16 + p)]
    return points, faces


def test_gaps():
    surface = plates(0.02)
    report = report_of(write('plates.off', off_text(*surface)), '-o', 'plates.mesh', status=MESHED)
    bad = check_certificate('plates.mesh', report, surface)
    gaps = [entry for entry in bad if entry['reason'] == 'gap']
    assert len(gaps) == report['improvement']['number_of_gap'] > 36 and {len(entry['facets']) for entry in gaps} == {2}
    process = run('plates.off', status=MESHED)
    words = r', gap: two triangles of the surface are 0.02 apart, which allows no more than [\d.]+ degrees$'
    assert re.search(words, process.out, re.M), process.out

    position = bad.index(gaps[0])
    for change in ({'distance': 0.03}, {'surface_angle': 3}, {'reason': 'needle'}, {'facets': gaps[0]['facets'][::-1]},
                   {'facets': [gaps[0]['facets'][0], {'triangle': 40, 'points': surface[1][40]}]}):
        wrong = copy.deepcopy(report)
        wrong['improvement']['bad_tetrahedra'][position].update(change)
        try:
            check_certificate('plates.mesh', wrong, surface)
        except Wrong:
            continue
        assert False, change


def test_extreme_scales():
    """all figures are those of the same surface of an ordinary size"""
    points, faces = grid_box(2)
    keys = ('number_of_points', 'number_of_tetrahedra', 'tetrahedra_with_angle_below', 'tetrahedra_with_angle_above',
            'histogram_of_dihedral_angles', 'number_of_edges_inside', 'number_of_edges_in_size')
    for arguments in ((), ('--size', 0.4)):
        reports = {}
        for exponent in (0, -498, -166, 166, 365, 498):
            scale = 2.0 ** exponent
            file = write('scaled.off', off_text([[x * scale for x in p] for p in points], faces))
            options = [repr(x * scale) if isinstance(x, float) else x for x in arguments]
            reports[exponent] = report_of(file, *options, status=MESHED)
            for key in keys:
                assert reports[exponent][key] == reports[0][key], (exponent, arguments, key)
            for key in ('min_dihedral_angle', 'max_dihedral_angle', 'mean_length_by_size', 'forecast_of_tetrahedra'):
                assert math.isclose(reports[exponent][key], reports[0][key], rel_tol=1e-9), (exponent, arguments, key)
        assert reports[0]['min_dihedral_angle'] > 20
    # what cannot be done is refused with the reason
    process = run(write('cube.off', off_text(points, faces)), '--size', '1e-120', status=INCOMPLETE)
    assert 'it would have about 10^308 or more vertices' in process.err, process.err


def test_no_improvement():
    name = write('plain.off', off_text(*wedge(8)))
    report = report_of(name, '--no-improvement', '--size', '1', '-o', 'plain.mesh', status=MESHED)
    assert 'improvement' not in report and 'seconds_improvement' not in report
    assert [phase['name'] for phase in report['meshing_phases']][-1] == 'field_point_insertion'
    assert report['number_of_points'] == 9 + report['number_of_field_points']
    process = run(name, '--no-improvement', '--timing', status=MESHED)
    assert '@@improve 0\n' in process.out and 'tetrahedra below' not in process.out and 'improved' not in process.out
    for combination in (['--no-improvement', '--effort', 'low'], ['--no-field-points', '--effort', 'low'],
                        ['--no-improvement', '--min-angle', '10'], ['--no-field-points', '--min-angle', '10']):
        check_file_error(name, *combination)


def coin(n):
    rim = [(math.cos(2 * math.pi * i / n), math.sin(2 * math.pi * i / n)) for i in range(n)]
    points = [(x, y, z) for z in (0, 0.1) for x, y in rim] + [(0, 0, 0), (0, 0, 0.1)]
    faces = []
    for i in range(n):
        j = (i + 1) % n
        faces += [(i, j, n + j), (i, n + j, n + i), (2 * n, j, i), (2 * n + 1, n + i, n + j)]
    return points, faces


def test_effort():
    name = write('effort.off', off_text(*coin(64)))  # thin triangles, beside which much can be tried
    meshes = {}
    for effort in ('low', 'normal', 'high', None):
        run(name, '--quiet', '-o', 'effort.mesh', *(['--effort', effort] if effort else []), status=MESHED)
        with open('effort.mesh', 'rb') as file:
            meshes[effort] = file.read()
    assert meshes[None] == meshes['normal'] and meshes['low'] != meshes['high']


def test_chart():
    def draw(*arguments):
        return subprocess.run([sys.executable, DRAW_QUALITY, *arguments], capture_output=True, timeout=60)
    name = write('a <chart> & more.off', off_text(*wedge(8)))
    run(name, '--report', 'chart.json', '--quiet', status=MESHED)
    for chart in ('first.svg', 'second.svg'):
        process = draw('chart.json', chart)
        assert process.returncode == 0 and process.stdout + process.stderr == b'', process
    assert read('first.svg') == read('second.svg')
    root = xml.etree.ElementTree.fromstring(read('first.svg').decode())
    improvement = json.loads(read('chart.json'))['improvement']
    texts = [element.text for element in root.iter('{http://www.w3.org/2000/svg}text')]
    assert name in texts and any('%d forced' % improvement['number_of_forced'] in t for t in texts), texts
    heights = collections.defaultdict(dict)  # of the bars
    for bar in root.iter('{http://www.w3.org/2000/svg}rect'):
        words = re.fullmatch(r'(before|after), (\d+) to \d+ degrees: (\d+) tetrahedra', bar[0].text or '')
        if words:
            heights[words[1]][int(words[2])] = (int(words[3]), float(bar.get('height')))
    for key, bars in heights.items():
        histogram = improvement[key]['histogram_of_smallest_angles']
        assert [bars[5 * i][0] for i in range(len(bars))] == histogram[:len(bars)] and sum(histogram[len(bars):]) == 0
    largest = max(height / n for bars in heights.values() for n, height in bars.values() if n > 0)
    smallest = min(height / n for n, height in heights['after'].values() if n > 0)
    assert set(heights) == {'before', 'after'} and smallest > 0 and largest <= 280
    run(name, '--no-improvement', '--report', 'none.json', '--quiet', status=MESHED)
    for arguments in (['none.json', 'x.svg'], ['nowhere.json', 'x.svg'], [name, 'x.svg'], ['chart.json'],
                      ['chart.json', 'nowhere/x.svg']):
        process = draw(*arguments)
        assert process.returncode == 1 and process.stderr and b'Traceback' not in process.stderr, process
    assert not os.path.exists('x.svg')


def test_report():
    name = write('report.off', off_text(*box((0, 0, 0), (3, 4, 5))))
    report = report_of(name, '-o', 'report.mesh', '--size', '1', status=MESHED)
    result = read_mesh('report.mesh')
    assert report['program'] == 'mesh_surface' and report['input'] == name and report['notes'] == []
    assert report['status'] == 'meshed' and report['recovery_status'] == 'recovered'
    assert report['number_of_edges'] == 18 and report['number_of_facets'] == report['number_of_triangles'] == 12
    assert report['number_of_points'] == len(result.points) == 8 + number_of_points_inside(report)
    assert report['number_of_tetrahedra'] == len(result.tetrahedra) and report['number_of_regions'] == 1
    for key in ('missing_edges', 'missing_facets', 'unrepresentable_constraints', 'defects', 'steiner_points', 'invalid_sizes'):
        assert report[key] == []
    names = [phase['name'] for phase in report['phases']]
    assert names[0] == 'insertion' and 'search' in names
    names = [phase['name'] for phase in report['meshing_phases']]
    assert names[0] == 'domain_marking' and names[-2:] == ['field_point_insertion', 'quality_improvement'], names
    last = report['meshing_phases'][-1]
    assert last['number_of_vertices'] == len(result.points) and last['number_of_cells'] >= len(result.tetrahedra)
    seconds = [report['seconds_' + step] for step in ('recovery', 'field_points', 'improvement')]
    assert min(seconds) >= 0 and sum(seconds) <= report['seconds']


def test_printing():
    surface = write('printing.off', off_text(*box((0, 0, 0), (3, 4, 5))))
    process = run(surface, '--quiet', '--size', '1', '-o', 'printing.mesh', status=MESHED)
    assert process.out == '' and process.err == ''
    process = run(surface, '--size', '1', status=MESHED)
    assert process.err == '' and '@@' not in process.out and '\r' not in process.out
    lines = process.out.splitlines()
    for line, words in itertools.zip_longest(lines, (
            r'printing\.off: 12 triangles, 8 points', r'about [\d.]+ tetrahedra are to be expected',
            r'mesh: \d+ tetrahedra in 1 region, \d+ points: \d+ added inside', r'dihedral angles: from [\d.]+ to [\d.]+ degrees',
            r'below 25 degrees: \d+.*', r'the worst one:  [\d.]+ degrees at .*',
            r'edges inside: \d+ % are as long as was asked for, within a factor of 1\.41', r'meshed in [\d.e-]+ seconds',
            r'no mesh is written; -o OUTPUT does that',
            r'note: 12 triangles of the surface with edges longer than twice the size; --remesh-surface 1 divides them')):
        assert re.fullmatch(words, line), (words, line)
    process = run(surface, '--size', '1', '--verbose', status=MESHED)
    for words in (r'^search ', r'^field_point_insertion +\d+ +\d+ ', r'^quality_improvement +\d+ +\d+ ', r'^ *60 to +70 +[\d.]+ %', r'^edges inside: \d+, [\d.]+ %',
                  r'below 5: \d+, 10: \d+, 15: \d+, 20: \d+; above 150: \d+, 160: \d+, 170: \d+',
                  r'^improved from [\d.e-]+ and [\d.]+ degrees: \d+ edges? and \d+ facets? removed, ',
                  r'^tetrahedra below 25 degrees: 0 forced by the surface, 0 in gaps of it, \d+ at needles of it, \d+ not improved',
                  r'^meshed: \d+ points, \d+ field points? and 0 Steiner points among them, and \d+ tetrahedra in 1 region'):
        assert re.search(words, process.out, re.M), (words, process.out)
    assert 'no mesh is written' not in run(surface, '-o', 'printing.mesh', status=MESHED).out
    assert 'written: printing.mesh, printing.vtu\n' in run(surface, '-o', 'printing.mesh', '-o', 'printing.vtu').out
    process = run(write('wedge.off', off_text(*wedge(8))), '--verbose', status=MESHED)
    words = r'^  [\d.]+ degrees at \(([-\d.e]+ ){2}[-\d.e]+\), forced: triangles of the surface meet at 8 degrees$'
    assert re.search(words, process.out, re.M), process.out
    process = run(surface, '--quiet', '--timing', status=MESHED)
    lines = [re.fullmatch(r'@@(\w+) ([\d.e+-]+)', line).groups() for line in process.out.splitlines()]
    assert [word for word, _ in lines] == ['rec', 'fill', 'improve', 'tmesh']
    seconds = {word: float(x) for word, x in lines}
    assert min(seconds.values()) >= 0 and seconds['improve'] > 0
    assert seconds['rec'] + seconds['fill'] + seconds['improve'] <= seconds['tmesh']


# ---------------------------------------------------------------- tests of what is not meshed

def check_no_mesh(*arguments, reason, status):
    """status 3, a reason on stderr, no file, and the status in the report"""
    process = run(*arguments, '-o', 'never.mesh', status=INCOMPLETE)
    assert re.fullmatch(r'[\w.]+: [^\n]+ points[^\n]*\n(about [^\n]+ tetrahedra are to be expected\n)?', process.out), process
    assert process.err.startswith('mesh_surface: there is no mesh: '), process
    assert reason in process.err and not os.path.exists('never.mesh'), process
    report = report_of(*arguments, '-o', 'never.mesh', status=INCOMPLETE)
    assert report['status'] == status and report['number_of_tetrahedra'] == 0 and not os.path.exists('never.mesh')
    return report


def test_no_mesh():
    points, faces = box((0, 0, 0), (3, 4, 5))
    name = write('box.off', off_text(points, faces))
    report = check_no_mesh(name, '--size', '0.1', '--max-vertices', '1000', reason='tetrahedra', status='too_large')
    assert report['forecast_of_vertices'] > 1000 and report['number_of_field_points'] == 0
    run(name, '--size', '1', '--max-vertices', '1000', status=MESHED)
    for limit in (['--size', '0.1', '--max-vertices', '1000'], ['--time-limit', '0']):
        process = run(name, '--quiet', *limit, status=INCOMPLETE)
        assert process.out == '' and re.fullmatch(r'mesh_surface: there is no mesh: .*\n', process.err), process
    report = check_no_mesh(name, '--time-limit', '0', reason='stopped', status='stopped')
    report = check_no_mesh(write('open.off', off_text(points, faces[:-2])), reason='no region', status='no_region')
    assert report['recovery_status'] == 'recovered' and report['number_of_regions'] == 0
    report = check_no_mesh(name, '--size', '1e-120', reason='tetrahedra', status='too_large')


def test_time_limit():
    name = write('limit.off', off_text(*grid_box(10)))
    start = time.monotonic()
    run(name, '--no-field-points', status=MESHED)
    limit = '%.3f' % max(0.2, 4 * (time.monotonic() - start))  # enough for the recovery, also on a busy machine
    report = report_of(name, '--size', '0.015', '--time-limit', limit, '-o', 'limit.mesh', status=INCOMPLETE)
    assert report['status'] == 'stopped' and report['recovery_status'] == 'recovered'
    result = read_mesh('limit.mesh')  # what there is by then
    assert len(result.tetrahedra) == report['number_of_tetrahedra'] > 0 and len(result.triangles) == 1200
    assert math.isclose(signed_volume(result.points, result.tetrahedra), 6, rel_tol=1e-9)
    process = run(name, '--size', '0.015', '--time-limit', limit, '--quiet', status=INCOMPLETE)
    words = r'mesh_surface: the time limit ended the work before the mesh was (filled|improved as far as possible)\n'
    assert process.out == '' and re.fullmatch(words, process.err), process
    report = report_of(name, '--size', '1', '--time-limit', '60', status=MESHED)
    assert report['status'] == 'meshed'
    assert report['improvement']['is_measured'] and report['improvement']['is_certificate_complete']


def test_threads():
    """neither the mesh nor what is told of it depends on them"""
    name = write('threads.off', off_text(*box((0, 0, 0), (1, 2, 3))))
    told = []
    for threads in ('1', '2', '3'):
        report = report_of(name, '--size', '0.12', '--threads', threads, '-o', 'threads.mesh', status=MESHED)
        told.append((read('threads.mesh'), SECONDS.sub(rb'\1', json.dumps(report).encode())))
    assert told[0] == told[1] == told[2]
    assert report['number_of_tetrahedra'] > 10000  # several blocks of work


def test_subdomains():
    name = write('subdomains.off', off_text(*box((0, 0, 0), (1, 2, 3))))
    text = []
    for threads in ('1', '2', '3'):
        output = 'subdomains_%s.mesh' % threads
        run(name, '--size', '0.2', '--subdomains', '5', '--threads', threads, '-o', output, status=MESHED)
        text.append(read(output))
    assert text[0] == text[1] == text[2]
    result, report = mesh('subdomains', box((0, 0, 0), (1, 2, 3)), '--size', '0.2', '--subdomains', '5')
    assert report['number_of_subdomains'] == 5 and len(result.triangles) == 12
    assert report['number_of_meshed_subdomains'] == 5
    report = report_of(name, '--subdomains', '1000000', status=MESHED)
    assert report['number_of_subdomains'] == 1000000 and report['number_of_meshed_subdomains'] == 1
    assert 'decomposition' in [phase['name'] for phase in report['meshing_phases']]
    assert math.isclose(signed_volume(result.points, result.tetrahedra), 6 * 6, rel_tol=1e-9)


def test_command_line():
    process = run('--help', status=MESHED)
    assert process.out.startswith('usage: mesh_surface') and process.err == ''
    for option in ('-o --size --sources --background --grading --no-field-points --max-vertices --time-limit --subdomains '
                   '--threads --min-angle --effort --no-improvement --repair --tolerance --list-defects --patch-angle --region --void --report '
                   '--timing --quiet --version -h,--help').split():
        assert '  %s ' % option in process.out, option
    surface = write('command_line.off', off_text(*tetrahedron()))
    for wrong in (['--unknown'], ['-x'], ['-o'], ['--report'], [surface], [''], ['--size'], ['--size', '0'], ['--size', '-1'],
                  ['--size', 'nan'], ['--size', 'inf'], ['--size', '1e999'], ['--size', '1m'], ['--size', ''],
                  ['--grading', '-1'], ['--grading', 'nan'], ['--grading', '0.3', '--size', '1'], ['--sources'],
                  ['--background'], ['--max-vertices', '-1'], ['--max-vertices', '1.5'], ['--max-vertices', '1e300'],
                  ['--time-limit', 'soon'], ['--subdomains', '0'], ['--subdomains', '1.5'],
                  ['--threads', '0'], ['--threads'], ['--tolerance', '1'], ['--conforming'], ['--min-angle'],
                  ['--min-angle', '-1'], ['--min-angle', '70.6'], ['--min-angle', 'nan'], ['--no-improvement', '1'],
                  ['--effort'], ['--effort', 'much'], ['--effort', ''], ['-o', 'out.stl'], ['-o', 'out']):
        check_file_error(surface, *wrong)
    run(surface, '--grading', '0.5', '--max-vertices', '100', '--time-limit', '60', '--min-angle', '70.5', status=MESHED)


def test_files_of_sizes_are_not_overwritten():
    write('box.off', off_text(*box((0, 0, 0), (1, 2, 4))))
    write('sources.mesh', 'point 0 0 0 1 1 1\n')
    os.symlink('sources.mesh', 'link.msh')
    for output in (['--report', 'sources.mesh'], ['-o', 'sources.mesh'], ['-o', 'other.vtk', '-o', 'link.msh']):
        assert 'overwritten' in check_file_error('box.off', '--sources', 'sources.mesh', *output)
    assert read('sources.mesh') == b'point 0 0 0 1 1 1\n' and not os.path.exists('other.vtk')


def test_default_surface():
    run('-o', 'default.mesh', '--report', 'default.json', '--quiet', status=MESHED)
    result = read_mesh('default.mesh')
    assert set(result.regions) == {1}
    points = integers(result.points)
    volumes = [signed_volume(points, [t]) for t in result.tetrahedra]
    assert min(volumes) > 0 and sum(volumes) == signed_volume(points, result.triangles)
    assert {f for f, n in facets_of(result.tetrahedra).items() if n == 1} == {frozenset(t) for t in result.triangles}
    report = json.loads(read('default.json'))
    assert report['number_of_field_points'] > 1000 and report['number_of_steiner_points_in_domain'] == 0


def test_determinism():
    write('sources.txt', 'point 0 0 3 1 1 0.3\n')
    for name in ('first', 'second'):
        run('-o', name + '.mesh', '-o', name + '.msh', '-o', name + '.vtu', '-o', name + '.vtk', '--report', name + '.json',
            '--sources', 'sources.txt', '--quiet', status=MESHED)
    for extension in ('.mesh', '.msh', '.vtu', '.vtk'):
        assert read('first' + extension) == read('second' + extension)
    assert SECONDS.sub(rb'\1', read('first.json')) == SECONDS.sub(rb'\1', read('second.json'))


if __name__ == '__main__':
    run_tests(__doc__, globals())
