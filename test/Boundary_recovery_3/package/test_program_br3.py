#!/usr/bin/env python3
"""Runs the example program recover_boundary and checks what it writes, prints and returns.

usage: test_program_br3.py PROGRAM

Every mesh is read back by parsers of program_tests.py and checked with exact rational arithmetic.
"""
import collections
import json
import math
import os
import re
import struct
import subprocess
import sys
import threading

sys.dont_write_bytecode = True  # the folder of the sources stays as it is
import program_tests
from program_tests import *


# ---------------------------------------------------------------- tests

def test_command_line():
    process = run('--help', status=RECOVERED)
    assert process.out.startswith('usage: recover_boundary') and process.err == ''
    for option in ('-o --repair --tolerance --conforming --flips-only --keep-exterior --effort --max-recursion-level '
                   '--time-limit --report --quiet').split():
        assert option in process.out
    surface = write('command_line.off', off_text(*tetrahedron()))
    for wrong in (['--unknown'], ['-x'], ['-o'], ['--report'], ['--time-limit'], ['--time-limit', 'soon'],
                  ['--time-limit', '-1'], ['--time-limit', 'nan'], ['--time-limit', '3s'],
                  ['--max-recursion-level', '1.5'], ['--max-recursion-level', '-2'], [surface], [''],
                  ['--effort'], ['--effort', 'none'],
                  ['--tolerance', '1'], ['--repair', '--tolerance', '-1'], ['--repair', '--tolerance', 'nan'],
                  ['--conforming', '--flips-only'], ['-o', 'out.stl'], ['-o', 'out']):
        check_file_error(surface, *wrong)
    for effort in ('more-time', 'more-points'):
        run(surface, '--effort', effort, status=RECOVERED)
    run(surface, '--max-recursion-level', '2', '--time-limit', '60', '--flips-only', '--flips-only', status=RECOVERED)


def test_output_formats():
    points, faces = box((0, 0, 0), (3, 4, 5))
    surface = write('formats.off', off_text(points + [(1.5, 0.1, 1 / 3)], faces))  # no face uses the last point
    run(surface, '-o', 'a.mesh', '-o', 'a.vtu', '-o', 'a.vtk', '-o', 'a.msh', '-o', 'b.mesh', status=RECOVERED)
    mesh, vtu, vtk = read_mesh('a.mesh'), read_vtu('a.vtu'), read_vtk('a.vtk')
    check_domain(mesh, points, faces)
    assert set(mesh.regions) == {1} and len(mesh.points) == 8
    assert mesh == vtu == vtk == read_msh('a.msh').mesh
    assert read('a.mesh') == read('b.mesh')


def test_coordinates_are_kept():
    points = [(0.1, 1 / 3, 1e-300), (1e10 / 7, 0.3, -0.7), (2 / 3, 1e9 / 11, 0.2), (5e-324, math.pi, 1e8 * math.e)]
    faces = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]
    if signed_volume(points, faces) < 0:
        faces = [(a, c, b) for a, b, c in faces]
    for name, text in (('digits.off', off_text), ('digits.ply', ply_binary), ('digits.obj', obj_text)):
        run(write(name, text(points, faces)), '-o', 'digits.mesh', status=RECOVERED)
        check_domain(read_mesh('digits.mesh'), points, faces)


def test_input_formats():
    points, faces = box((0, 0, 0), (1, 2, 4))
    run(write('in.off', off_text(points, faces)), '-o', 'off.mesh', status=RECOVERED)
    for name, text in (('in.obj', obj_text), ('in.ply', ply_text), ('IN.PLY', ply_binary)):
        run(write(name, text(points, faces)), '-o', 'same.mesh', status=RECOVERED)
        assert read('same.mesh') == read('off.mesh'), name
    order = list(dict.fromkeys(v for f in faces for v in f))  # STL has no vertices: they come as faces name them
    points, faces = [points[v] for v in order], [tuple(order.index(v) for v in f) for f in faces]
    run(write('ordered.off', off_text(points, faces)), '-o', 'ordered.mesh', status=RECOVERED)
    soup = [points[v] for f in faces for v in f], [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(len(faces))]
    for name, content in (('ascii.stl', stl_text(points, faces)), ('binary.stl', stl_binary(points, faces)),
                          ('soup.off', off_text(*soup)), ('soup.obj', obj_text(*soup))):
        run(write(name, content), '-o', 'same.mesh', status=RECOVERED)
        mesh = read_mesh('same.mesh')
        check_domain(mesh, points, faces)
        assert read('same.mesh') == read('ordered.mesh'), name


def test_regions():
    outer, inner = box((0, 0, 0), (3, 3, 3)), box((1, 1, 1), (2, 2, 2))
    void = join(outer, box((1, 1, 1), (2, 2, 2), outward=False))
    run(write('void.off', off_text(*void)), '-o', 'void.mesh', status=RECOVERED)
    mesh = read_mesh('void.mesh')
    check_domain(mesh, *void)
    assert set(mesh.regions) == {1}

    run('void.off', '-o', 'all.mesh', '-o', 'all.msh', '-o', 'all.vtu', '--keep-exterior', status=RECOVERED)
    mesh = read_mesh('all.mesh')
    check_tetrahedra(mesh)
    assert volume_of_regions(mesh) == {1: 6 * 26, 0: 6} and read_vtu('all.vtu') == mesh
    msh = read_msh('all.msh')  # regions are numbers of volumes, which are never 0
    assert msh.mesh == mesh._replace(regions=[r or 2 for r in mesh.regions])
    assert msh.volumes == ['region_1' if r else 'outside' for r in mesh.regions]

    report = report_of(write('two.off', off_text(*join(outer, inner))), '-o', 'two.mesh', status=RECOVERED)
    mesh = read_mesh('two.mesh')
    check_tetrahedra(mesh)
    assert volume_of_regions(mesh) == {1: 6 * 26, 2: 6} and report['number_of_regions'] == 2

    # an open surface bounds no region: its convex hull is written, and the report says so
    points, faces = outer
    report = report_of(write('open.off', off_text(points, faces[:-2])), '-o', 'open.mesh', status=RECOVERED)
    assert report['domain'] == 'convex_hull' and report['number_of_regions'] == 0
    mesh = read_mesh('open.mesh')
    check_tetrahedra(mesh)
    assert volume_of_regions(mesh) == {1: 6 * 27}


def test_incomplete():
    points, faces = schonhardt()
    surface = write('twisted.off', off_text([(9, 9, 9)] + points, [tuple(v + 1 for v in f) for f in faces]))
    process = run(surface, '--flips-only', '-o', 'twisted.vtu', status=INCOMPLETE)
    assert 'incomplete' in process.out and process.err == ''
    report = report_of(surface, '--flips-only', status=INCOMPLETE)
    assert report['status'] == 'incomplete' and report['mode'] == 'flips_only'
    assert report['number_of_edges'] == 12 and report['number_of_facets'] == 8
    edges, facets = report['missing_edges'], report['missing_facets']
    assert edges and facets
    reflex = [{i + 1, (i + 1) % 3 + 4} for i in range(3)]  # numbers of the file, in which a vertex is not used
    for edge in edges:
        assert set(edge['vertices']) in reflex
        assert edge['points'] == [list(points[v - 1]) for v in edge['vertices']]
    for facet in facets:
        assert {v - 1 for v in facet['vertices']} == set(faces[facet['index']])
        assert any(set(edge['vertices']) <= set(facet['vertices']) for edge in edges)
    mesh = read_vtu('twisted.vtu')  # written all the same: the convex hull, and the facets that are there
    check_tetrahedra(mesh)
    assert report['domain'] == 'convex_hull' and len(mesh.points) == 6
    missing = {facet['index'] for facet in facets}
    assert mesh.numbers == [i for i in range(len(faces)) if i not in missing]
    assert mesh.triangles == [tuple(faces[i]) for i in range(len(faces)) if i not in missing]


def test_steiner_points():
    points, faces = schonhardt()
    report = report_of(write('twisted.off', off_text(points, faces)), '-o', 'twisted.mesh', status=RECOVERED)
    assert report['status'] == 'recovered' and report['mode'] == 'constrained' and report['domain'] == 'regions'
    assert report['missing_edges'] == report['missing_facets'] == []
    mesh = read_mesh('twisted.mesh')
    check_domain(mesh, points, faces)
    left = report['number_of_steiner_points_left']
    assert 0 < left <= report['number_of_steiner_points'] and report['number_of_constraint_points'] > 0
    assert left == len(report['steiner_points']) and report['number_of_split_edges'] == 0
    assert report['number_of_steiner_points_in_domain'] == len(mesh.points) - 6 > 0
    inside = [list(p) for p in mesh.points[6:]]
    assert [p for p in report['steiner_points'] if p in inside] == inside
    phases = [phase['name'] for phase in report['phases']]
    assert {'conforming_edge_recovery', 'steiner_splitting', 'steiner_suppression'} <= set(phases)
    process = run('twisted.off', status=RECOVERED)
    assert re.search(r'^steiner_splitting ', process.out, re.M)
    assert 'Steiner points: %d put on constraints, %d after splitting, %d left, %d of them in the domain' % (
        report['number_of_constraint_points'], report['number_of_steiner_points'], left, len(mesh.points) - 6) in process.out


def test_steiner_points_outside():
    void = twisted_box(outward=False)
    report = report_of(write('void.off', off_text(*void)), '-o', 'void.mesh', status=RECOVERED)
    mesh = read_mesh('void.mesh')
    check_domain(mesh, *void)
    left, inside = report['number_of_steiner_points_left'], report['number_of_steiner_points_in_domain']
    assert left > inside  # one is in the void, which cannot be filled without
    assert len(mesh.points) == 14 + inside
    run('void.off', '-o', 'all.mesh', '--keep-exterior', status=RECOVERED)
    mesh = read_mesh('all.mesh')
    check_tetrahedra(mesh)
    assert set(mesh.regions) == {0, 1} and len(mesh.points) == 14 + left


def chains_of(triangles):
    """the directed edges around a set of triangles that are turned the same way"""
    edges = collections.Counter((t[i], t[(i + 1) % 3]) for t in triangles for i in range(3))
    assert set(edges.values()) == {1}
    return {a: b for a, b in edges if (b, a) not in edges}


def check_parts(mesh, faces):
    """the triangles of each face are turned as it is, and one cycle through its corners goes around them"""
    parts = collections.defaultdict(list)
    for triangle, number in zip(mesh.triangles, mesh.numbers):
        parts[number].append(triangle)
    assert sorted(parts) == list(range(len(faces)))
    for i, face in enumerate(faces):
        after = chains_of(parts[i])
        cycle = [face[0]]
        while after[cycle[-1]] != face[0]:
            cycle.append(after[cycle[-1]])
        assert len(cycle) == len(after) and [v for v in cycle if v in face] == list(face), (face, cycle)
    return max(map(len, parts.values()))


def test_conforming():
    points, faces = schonhardt()
    report = report_of(write('twisted.off', off_text(points, faces)), '--conforming', '-o', 'twisted.vtu',
                       status=RECOVERED)
    assert report['mode'] == 'conforming' and report['domain'] == 'regions'
    assert report['number_of_steiner_points_left'] == report['number_of_constraint_points'] > 0
    assert report['number_of_split_edges'] > 0 and report['number_of_split_facets'] > 0
    mesh = read_vtu('twisted.vtu')
    check_tetrahedra(mesh)
    assert check_parts(mesh, faces) > 1 and set(mesh.regions) == {1}
    boundary = {f for f, n in facets_of(mesh.tetrahedra).items() if n == 1}
    assert boundary == {frozenset(t) for t in mesh.triangles}
    assert signed_volume(mesh.points, mesh.tetrahedra) == signed_volume(mesh.points, mesh.triangles)

    for outward, regions in ((False, {1}), (True, {1, 2})):  # parts that are not turned like their face would not tell
        surface = twisted_box(outward)
        run(write('box.off', off_text(*surface)), '--conforming', '-o', 'box.vtu', status=RECOVERED)
        mesh = read_vtu('box.vtu')
        check_tetrahedra(mesh)
        assert check_parts(mesh, surface[1]) > 1 and set(mesh.regions) == regions


def test_time_limit():
    points, faces = box((0, 0, 0), (3, 4, 5))
    surface = write('limit.off', off_text(points, faces))
    report = report_of(surface, '--time-limit', '0', status=INCOMPLETE)
    assert report['status'] == 'stopped'
    process = run(surface, '--time-limit', '0', '--quiet', status=INCOMPLETE)
    assert process.out == ''
    assert process.err == 'recover_boundary: the time limit ended the work before the surface was recovered\n'
    assert report_of(surface, '--time-limit', '60', status=RECOVERED)['status'] == 'recovered'


def test_report():
    name = b'odd "name"\\ \xff\xc3\xa9\t.off'
    try:
        write(name, off_text(*tetrahedron()))
    except OSError:  # a file system that refuses such a name
        name = write('plain.off', off_text(*tetrahedron()))
    report = report_of(name, '-o', 'report.mesh', status=RECOVERED)
    assert report['status'] == 'recovered' and report['mode'] == 'constrained'
    assert report['number_of_edges'] == 6 and report['number_of_facets'] == 4
    assert report['number_of_points'] == 4 and report['number_of_tetrahedra'] == 1
    assert report['number_of_regions'] == 1 and report['domain'] == 'regions'
    assert abs(report['max_dihedral_angle'] - 90) < 1e-9
    assert abs(report['min_dihedral_angle'] - math.degrees(math.acos(3 ** -0.5))) < 1e-9
    for key in ('missing_edges', 'missing_facets', 'unrepresentable_constraints', 'defects', 'steiner_points'):
        assert report[key] == []
    phases = [phase['name'] for phase in report['phases']]
    assert phases[0] == 'insertion' and 'search' in phases
    assert report['seconds'] >= report['seconds_recovery'] >= 0
    seconds = {phase['name']: phase['seconds'] for phase in report['phases']}
    assert sum(seconds.values()) <= report['seconds'] + 1e-9
    assert abs(report['seconds'] - seconds['insertion'] - report['seconds_recovery']) < 1e-9

    # the report says the same as the mesh
    report = report_of('-o', 'report.mesh', status=RECOVERED)
    mesh = read_mesh('report.mesh')
    assert report['number_of_points'] == len(mesh.points)
    assert report['number_of_tetrahedra'] == len(mesh.tetrahedra)


def test_printing():
    surface = write('printing.off', off_text(*box((0, 0, 0), (3, 4, 5))))
    process = run(surface, '--quiet', '-o', 'printing.mesh', status=RECOVERED)
    assert process.out == '' and process.err == ''
    process = run(surface, status=RECOVERED)
    assert re.search(r'^search ', process.out, re.M) and 'recovered: 0 of 18 edges and 0 of 12 facets' in process.out
    assert 'no mesh is written' in process.out
    assert 'no mesh is written' not in run(surface, '-o', 'printing.mesh', status=RECOVERED).out
    assert 'dihedral angles' in process.out and process.err == '' and '@@' not in process.out
    process = run(surface, '--quiet', '--timing', status=RECOVERED)
    match = re.fullmatch(r'@@rec ([\d.e+-]+)\n@@tmesh ([\d.e+-]+)\n', process.out)
    assert match and 0 <= float(match.group(1)) <= float(match.group(2))
    process = run('--quiet', '--table')
    lines = [line.split() for line in process.out.splitlines()]
    assert lines[0] == ['phase', 'l_max', 'n1', 'n2', 'n3', 'n4']
    assert len(lines) > 1 and all(len(line) == 6 for line in lines)


def test_default_surface():
    process = run('-o', 'default.mesh', status=RECOVERED)
    lost = re.search(r'^search +(\d+) ', process.out, re.M)
    assert lost and int(lost.group(1)) > 0  # there is something to be seen
    mesh = read_mesh('default.mesh')
    check_tetrahedra(mesh)
    assert set(mesh.regions) == {1}
    boundary = {f for f, n in facets_of(mesh.tetrahedra).items() if n == 1}
    assert boundary == {frozenset(t) for t in mesh.triangles}
    assert signed_volume(mesh.points, mesh.tetrahedra) == signed_volume(mesh.points, mesh.triangles)


def test_determinism():
    for name in ('first', 'second'):
        run('-o', name + '.mesh', '-o', name + '.vtu', '--report', name + '.json', '--quiet')
    assert read('first.mesh') == read('second.mesh') and read('first.vtu') == read('second.vtu')
    seconds = re.compile(rb'("seconds[a-z_]*": )[^,}]*')
    assert seconds.sub(rb'\1', read('first.json')) == seconds.sub(rb'\1', read('second.json'))


def test_files():
    check_file_error('there_is_no.off')
    os.mkdir('directory.off')
    check_file_error('directory.off')
    check_file_error(write('surface.txt', 'OFF\n'))
    check_file_error(write('no_extension', 'OFF\n'))
    contents = {'.off': off_text, '.obj': obj_text, '.ply': ply_text, '.stl': stl_text}
    for extension in contents:
        check_file_error(write('empty' + extension, ''))
        check_file_error(write('text' + extension, 'this is no surface\n'))
        check_file_error(write('noise' + extension, bytes((i * i * 7 + i) % 251 for i in range(5000))))
    surface = tetrahedron()
    for extension, content in [('.off', off_text(*surface)), ('.ply', ply_text(*surface)), ('.ply', ply_binary(*surface)),
                               ('.stl', stl_binary(*surface)), ('.stl', stl_text(*surface))]:
        size = len(content)
        for cut in (1, 6, 30, size // 2, size - 12):
            check_file_error(write('truncated' + extension, content[:cut]))
    text = off_text(*surface)
    for old, new in (('4 4', '4000000000000 4'), ('4 4', '4 2000000000'), ('4 4', '-4 4'), ('4 4', '5 4'),
                     ('\n3 0', '\n2000000000 0'), ('\n3 0', '\n-3 0'), ('1 0 0', '1 x 0')):
        check_file_error(write('wrong.off', text.replace(old, new, 1)))

    wide = ply_text(*surface).replace('uchar', 'uint')
    run(write('wide.ply', wide), status=RECOVERED)
    for old, new in (('vertex 4', 'vertex 400000000000'), ('face 4', 'face 5'), ('3 0 2 1', '4000000000 0 2 1'),
                     ('3 0 2 1', '-3 0 2 1'), ('list uint', 'list word'), ('end_header', 'end')):
        check_file_error(write('wrong.ply', wide.replace(old, new, 1)))
    wide = ply_binary(*surface).replace(b'uchar', b'uint').replace(b'\3\0\0\0\0', struct.pack('<IB', 4000000000, 0), 1)
    check_file_error(write('wrong.ply', wide))

    # what is cut off an OBJ file cannot be known; it never crashes
    for cut in range(len(obj_text(*surface))):
        assert run(write('cut.obj', obj_text(*surface)[:cut])).returncode in (0, 1, 2, 3)

    good = write('good.off', text)
    check_file_error(good, '-o', 'no_such_directory/out.mesh')
    check_file_error(good, '--report', 'no_such_directory/report.json')
    os.mkdir('directory.mesh')
    check_file_error(good, '-o', 'directory.mesh')
    if os.path.exists('/dev/full'):
        os.symlink('/dev/full', 'full.mesh')
        check_file_error(good, '--quiet', '-o', 'full.mesh')
    check_file_error('there_is_no.off', '-o', 'untouched.mesh')
    assert not os.path.exists('untouched.mesh')


def check_same_mesh(name, content, expected, note=None):
    """a file is read like another one, whose mesh is there; a note in the summary and the report says what is left out"""
    process = run(write(name, content), '-o', 'same.mesh', status=RECOVERED)
    assert read_mesh('same.mesh')[:4] == read_mesh(expected)[:4], name  # names make other patches
    notes = re.findall(r'^note: (.*)$', process.out, re.M)
    assert notes == ([] if note is None else [note]), process.out
    assert report_of(name, status=RECOVERED)['notes'] == notes


BYTE_ORDER_MARK = b'\xef\xbb\xbf'


def test_byte_order_mark():
    for extension, text in (('off', off_text), ('obj', obj_text), ('ply', ply_text), ('stl', stl_text), ('ply', ply_binary)):
        content = text(*box((0, 0, 0), (1, 2, 4)))
        content = content if isinstance(content, bytes) else content.encode()
        run(write('plain.' + extension, content), '-o', 'plain.mesh', status=RECOVERED)
        check_same_mesh('marked.' + extension, BYTE_ORDER_MARK + content, 'plain.mesh')


def test_line_ends():
    for extension, text in (('off', off_text), ('obj', obj_text), ('ply', ply_text), ('stl', stl_text)):
        content = text(*box((0, 0, 0), (1, 2, 4)))
        run(write('plain.' + extension, content), '-o', 'plain.mesh', status=RECOVERED)
        for end in ('\r', '\r\n'):
            check_same_mesh('other.' + extension, content.replace('\n', end), 'plain.mesh')


def test_obj_statements():
    content = obj_text(*box((0, 0, 0), (1, 2, 4)))
    run(write('plain.obj', content), '-o', 'plain.mesh', status=RECOVERED)
    check_same_mesh('tabs.obj', content.replace(' ', '\t'), 'plain.mesh')
    check_same_mesh('tabs.obj', re.sub(r'(?m)^f (\d+) (\d+) (\d+)', r'f\t\1/1\t\2/1/1 \t\3//1\t', content), 'plain.mesh')
    for end in ('\n', '\r\n'):
        check_same_mesh('continued.obj', re.sub(r'(?m)^(f \d+) ', r'\1 \\' + end, content), 'plain.mesh')
        check_same_mesh('continued.obj', re.sub(r'(?m)^v ', 'v\\\\' + end, content), 'plain.mesh')
    check_same_mesh('path.obj', '# C:\\models\\\nmtllib C:\\\n' + content, 'plain.mesh')  # not continued
    check_same_mesh('lines.obj', 'l 1 2\n' + content + 'l 1 2 \\\n3\n', 'plain.mesh',
                    'lines of the OBJ file that are left out: 2')
    check_file_error(write('odd.obj', content + 'fish 1 2 3\n'))


def test_stl_keywords():
    content = stl_text(*box((0, 0, 0), (1, 2, 4)))
    run(write('plain.stl', content), '-o', 'plain.mesh', status=RECOVERED)
    check_same_mesh('upper.stl', content.upper(), 'plain.mesh')
    check_same_mesh('title.stl', content.title().replace('0 0 0', '0.0E+00 0 0'), 'plain.mesh')
    facets = re.findall(r'facet.*?endfacet\n', content, re.S)
    middle = len(facets) // 2
    mixed = 'solid Facet\n' + ''.join(facets[:middle]) + ''.join(facets[middle:]).upper() + 'endsolid Facet\n'
    check_same_mesh('mixed.stl', mixed, 'plain.mesh')  # half of it was lost without a word
    solids = 'solid a\n' + ''.join(facets[:middle]) + 'solid b\n' + ''.join(facets[middle:]) + 'endsolid b\n'
    check_same_mesh('solids.stl', solids, 'plain.mesh')
    note = 'the STL file has no endsolid: it may have been cut off'
    check_same_mesh('open.stl', content.replace('endsolid test\n', ''), 'plain.mesh', note)
    check_same_mesh('open.stl', content.upper().replace('ENDSOLID TEST\n', ''), 'plain.mesh', note)
    check_file_error(write('cut.stl', content[:content.rindex('endloop')]))


def test_stl_number_of_triangles():
    content = stl_binary(*box((0, 0, 0), (1, 2, 4)))
    run(write('plain.stl', content), '-o', 'plain.mesh', status=RECOVERED)
    for number in (0, 1, 11):
        note = 'triangles that the STL file announces: %d, that it has, and that are read: 12' % number
        check_same_mesh('few.stl', content[:80] + struct.pack('<I', number) + content[84:], 'plain.mesh', note)
    for rest in (b'\0' * 50, b'by a program', b'\0'):
        check_same_mesh('rest.stl', content + rest, 'plain.mesh',
                        'bytes after the last triangle of the STL file that are left out: %d' % len(rest))
    assert 'announces 13 triangles, and it has 12' in check_file_error(
        write('many.stl', content[:80] + struct.pack('<I', 13) + content[84:]))


def test_binary_off():
    points, faces = box((0, 0, 0), (1, 2, 4))
    run(write('plain.off', off_text(points, faces)), '-o', 'plain.mesh', status=RECOVERED)
    color = struct.pack('>4f', 1, 0.5, 0, 1)
    for content in (off_binary(points, faces), off_binary(points, faces, None), off_binary(points, faces, color),
                    off_binary(points, faces, color[:12]), off_binary(points, faces, b'', color, b'COFF'),
                    off_binary(points, faces, color, color[:12], b'COFF'),
                    off_binary(points, faces, b'', color[:12], b'NOFF')):
        check_same_mesh('binary.off', content, 'plain.mesh')
    content = off_binary(points, faces)
    for cut in (1, 14, 30, len(content) // 2, len(content) - 4, len(content) - 1):
        check_file_error(write('cut.off', content[:cut]))
    for position in (11, 15, 23, 23 + 12 * len(points)):  # the numbers of items, a coordinate, a number of vertices
        for word in (b'\xff\xff\xff\xff', b'\x7f\xff\xff\xff'):
            process = run(write('odd.off', content[:position] + word + content[position + 4:]))
            assert process.returncode in (FILE_ERROR, INVALID_INPUT) and len(process.out.splitlines()) <= 1, process
    check_invalid(write('odd.off', off_binary(points, faces[1:] + [(0, 1, 8)])), 'index_out_of_range')


def test_pipe():
    if not hasattr(os, 'mkfifo'):
        return
    for extension, text in (('off', off_text), ('obj', obj_text), ('ply', ply_binary), ('stl', stl_text)):
        content = text(*box((0, 0, 0), (1, 2, 4)))
        run(write('plain.' + extension, content), '-o', 'plain.mesh', status=RECOVERED)
        os.mkfifo('pipe.' + extension)
        writer = threading.Thread(target=write, args=('pipe.' + extension, content))
        writer.start()
        run('pipe.' + extension, '-o', 'pipe.mesh', status=RECOVERED)
        writer.join()
        assert read('pipe.mesh') == read('plain.mesh')


def test_input_is_not_overwritten():
    content = off_text(*box((0, 0, 0), (1, 2, 4)))
    write('input.off', content)
    os.mkdir('folder')
    names = ['input.off', './input.off', 'folder/../input.off', os.path.abspath('input.off'), 'link.mesh', 'link.off',
             'hard.vtu']
    os.symlink('input.off', 'link.mesh')
    os.symlink('link.mesh', 'link.off')
    os.link('input.off', 'hard.vtu')
    for source in ('input.off', 'link.off'):
        for name in names:
            assert 'overwritten' in check_file_error(source, '--report', name), name
            if not name.endswith('.off'):
                assert 'overwritten' in check_file_error(source, '-o', 'other.mesh', '-o', name), name
    assert read('input.off').decode() == content and not os.path.exists('other.mesh')


def test_summary_that_cannot_be_written():
    surface = write('summary.off', off_text(*box((0, 0, 0), (1, 2, 4))))
    closed = {'stdout': subprocess.DEVNULL, 'preexec_fn': lambda: os.close(1)}
    outputs = [closed] + ([{'stdout': open('/dev/full', 'w')}] if os.path.exists('/dev/full') else [])
    for output in outputs:
        for arguments in ([surface], [surface, '-o', 'summary.mesh'], ['--help'], [surface, '--quiet', '--timing']):
            process = subprocess.run([program_tests.PROGRAM, *arguments], stderr=subprocess.PIPE, timeout=300, **output)
            assert process.returncode == FILE_ERROR, (arguments, process)
            assert process.stderr.decode() == program_tests.program_name() + ': cannot write to the standard output\n', process
        check_domain(read_mesh('summary.mesh'), *box((0, 0, 0), (1, 2, 4)))
        process = subprocess.run([program_tests.PROGRAM, surface, '--quiet'], stderr=subprocess.PIPE, timeout=300, **output)
        assert process.returncode == RECOVERED and process.stderr == b''  # nothing is to be written


def test_invalid_coordinates():
    points, faces = box((0, 0, 0), (1, 1, 1))
    for word in ('nan', '-inf', 'Infinity', '1e999'):
        for name, text in (('odd.off', off_text), ('odd.obj', obj_text), ('odd.ply', ply_text)):
            odd = text([(7, 7, 7)] + points, [tuple(v + 1 for v in f) for f in faces])
            odd = odd.replace('1 1 0', '1 %s 0' % word, 1)  # vertex 3 of the box is vertex 4 of the file
            defects = check_invalid(write(name, odd), 'non_finite_coordinate')
            number = 5 if name == 'odd.obj' else 4  # OBJ files count from 1
            assert [d['simplices'][0]['vertices'] for d in defects] == [[number]], defects
    check_invalid(write('odd.stl', stl_text(points, faces).replace('vertex 1 1 0', 'vertex 1 nan 0')),
                  'non_finite_coordinate')
    points[3] = (1, math.nan, 0)
    check_invalid(write('binary_odd.ply', ply_binary(points, faces)), 'non_finite_coordinate')


def test_invalid_faces():
    points, faces = box((0, 0, 0), (1, 1, 1))
    unused = [(7, 7, 7)] + points  # moves the numbers of the file away from those that the library sees
    shifted = [tuple(v + 1 for v in f) for f in faces]

    def check(kind, changed, index, vertices, text=off_text, name='faces.off'):
        defects = check_invalid(write(name, text(unused, changed)), kind)
        first = int(text == obj_text)  # OBJ files count from 1
        assert any(s['index'] == index + first and sorted(s['vertices']) == sorted(v + first for v in vertices)
                   for d in defects for s in d['simplices'] if s['simplex'] == 'facet'), defects
        return defects

    check('not_a_triangle', shifted[:2] + [(1, 2, 3, 5)] + shifted[3:], 2, (1, 2, 3, 5))
    check('not_a_triangle', shifted[:5] + [(1, 2)] + shifted[6:], 5, (1, 2), obj_text, 'faces.obj')
    check('degenerate_facet', shifted[:4] + [(3, 5, 3)] + shifted[5:], 4, (3, 5, 3))
    check('duplicate_facet', shifted + [shifted[2][1:] + shifted[2][:1]], len(faces), shifted[2])
    for name, text in (('faces.off', off_text), ('faces.obj', obj_text), ('faces.ply', ply_text)):
        check('index_out_of_range', shifted[:1] + [(1, 2, 42)] + shifted[2:], 1, (1, 2, 42), text, name)
    check_invalid(write('none.off', 'OFF\n0 0 0\n'), 'empty_input')
    check_invalid(write('flat.off', off_text([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])), 'dimension_less_than_3')

    # points that are merged make a facet degenerate; it keeps the number of the first of them
    merged = unused + [points[1]]
    defects = check_invalid(write('merged.off', off_text(merged, shifted + [(2, 9, 4)])), 'degenerate_facet')
    assert defects[0]['simplices'][0]['index'] == 12 and defects[0]['simplices'][0]['vertices'] == [2, 2, 4], defects


def test_intersections():
    # a dozen needles through a box: every pair is in the report, the first three defects are in the message
    surfaces = [box((0, 0, 0), (40, 40, 40))]
    for i in range(12):
        x = 3 * i + 1
        surfaces.append(([(x, 3, 50), (x + 1, 3, 50), (x, 4, 50), (x + 0.5, 3.25, 30)], tetrahedron()[1]))
    surface = write('needles.off', off_text(*join(*surfaces)))
    defects = check_invalid(surface, 'intersecting_constraints')
    needles = {s['index'] for d in defects for s in d['simplices'] if s['simplex'] == 'facet' and s['index'] >= 12}
    assert {(index - 12) // 4 for index in needles} == set(range(12)), needles
    process = run(surface, status=INVALID_INPUT)
    number = int(re.search(r'(\d+) defects', process.err).group(1))
    lines = process.err.splitlines()
    assert number == len(defects) > 10 and len(lines) == 6, process.err
    assert lines[-2] == '  and %d more: --report lists all of them' % (number - 3) and '--repair' in lines[-1]

    # the same if they are looked for first; then nothing else is done
    assert run(surface, '--list-defects', status=INVALID_INPUT).err == process.err
    report = report_of(surface, '--list-defects', status=INVALID_INPUT)
    assert report['number_of_defects'] == number and report['phases'] == [], report
    run(write('box.off', off_text(*box((0, 0, 0), (40, 40, 40)))), '--list-defects', status=RECOVERED)


# ---------------------------------------------------------------- repair

def shaken(soup, amount):
    """moves each coordinate by up to the amount, never the same way twice"""
    points, faces = soup
    return [tuple(x + amount * ((7 * i + 3 * j) % 11 - 5) / 5 for j, x in enumerate(p)) for i, p in enumerate(points)], faces


def repair(points, faces, *arguments, status=RECOVERED):
    """the mesh, if there is one, and the report of the repair; the summary says as much"""
    name = write('repair.off', off_text(points, faces))
    process = run(name, '--repair', '-o', 'repair.mesh', '-o', 'repair.vtu', *arguments, status=status)
    assert 'repair, with tolerance' in process.out or 'repair: nothing is done' in process.out
    report = report_of(name, '--repair', *arguments, status=status)
    changes = report['repair']
    for key, words in (('merged_vertices', 'merged with another one'), ('degenerate_facets', 'without area dropped'),
                       ('duplicate_facets', 'dropped, there twice'), ('reversed_facets', 'turned over'),
                       ('divided_facets', 'divided, into')):
        number = re.search(r'^  (\d+) \w+ ' + words, process.out, re.M)
        assert changes['number_of_' + key] == len(changes[key]) == (int(number.group(1)) if number else 0), (key, process.out)
    return read_vtu('repair.vtu') if status == RECOVERED else None, report


def is_unchanged(changes):
    return not any(changes['number_of_' + key] for key in (
        'merged_vertices', 'flattened_vertices', 'degenerate_facets', 'duplicate_facets', 'reversed_facets',
        'divided_facets', 'new_points'))


def check_sources(mesh, report, points, faces):
    """each triangle of the boundary is in the plane of the face that it came from"""
    assert len(report['repair']['source_facets']) == len(mesh.triangles)
    assert mesh.numbers == report['repair']['source_facets']
    for triangle, number in zip(mesh.triangles, mesh.numbers):
        plane = [points[v] for v in faces[number]]
        assert all(determinant(plane + [mesh.points[v]]) == 0 for v in triangle)


def test_repair_leaves_valid_surfaces():
    void = join(box((0, 0, 0), (3, 3, 3)), box((1, 1, 1), (2, 2, 2), outward=False))
    two = join(box((0, 0, 0), (3, 3, 3)), box((1, 1, 1), (2, 2, 2)))
    small = box((1, 1, 1), (1 + 2 ** -40, 1 + 2 ** -40, 1 + 2 ** -40))  # much smaller than the tolerance
    for points, faces in (void, two, small, box((0, 0, 0), (1, 1, 1))):
        run(write('valid.off', off_text(points, faces)), '-o', 'valid.mesh', status=RECOVERED)
        mesh, report = repair(points, faces)
        assert read('repair.mesh') == read('valid.mesh') and is_unchanged(report['repair'])
        check_sources(mesh, report, points, faces)
    assert 'repair' not in report_of('valid.off', status=RECOVERED)


def test_repair_merges_points():
    surface = box((0, 0, 0), (1, 2, 4))
    for scale in (1, 2.0 ** -300, 2.0 ** 300):
        points, faces = shaken(soup_of(*surface), 2.0 ** -24)  # as far apart as single precision does it
        points = [tuple(scale * x for x in p) for p in points]
        soup = write('shaken.off', off_text(points, faces))
        assert run(soup).returncode == INVALID_INPUT or report_of(soup, status=RECOVERED)['domain'] == 'convex_hull'
        mesh, report = repair(points, faces)
        check_tetrahedra(mesh)
        changes = report['repair']
        assert report['domain'] == 'regions' and report['number_of_regions'] == 1 and len(mesh.points) == 8
        assert changes['is_tolerance_used'] and changes['tolerance'] == 4 * 2.0 ** -23 * max(max(map(abs, p)) for p in points)
        assert changes['number_of_open_edges_before'] == 36 and changes['number_of_open_edges_after'] == 0
        assert changes['number_of_merged_vertices'] == len(set(points)) - 8 and mesh.numbers == list(range(12))
        for vertex, into in changes['merged_vertices']:
            assert into < vertex and all(abs(x - y) <= changes['tolerance'] for x, y in zip(points[vertex], points[into]))
        corners = [[tuple(abs(round(x / scale)) for x in mesh.points[v]) for v in t] for t in mesh.triangles]
        assert corners == [[surface[0][v] for v in f] for f in surface[1]]
    for arguments in (['--tolerance', '0'], ['--tolerance', '1e-12']):
        changes = report_of(write('apart.off', off_text(*shaken(soup_of(*surface), 1e-3))), '--repair', *arguments,
                            status=run('apart.off', '--repair', *arguments).returncode)['repair']
        assert changes['number_of_merged_vertices'] == 0 and not changes['is_tolerance_used']
    mesh, report = repair(*shaken(soup_of(*surface), 1e-3), '--tolerance', '0.01')
    assert report['number_of_regions'] == 1 and report['repair']['tolerance'] == 0.01 and len(mesh.points) == 8
    repair(*surface, '--tolerance', '1e300')  # a valid surface does not become a point


def test_repair_removes_noise_beside_zero():
    points, faces = soup_of(*box((0, 0, 0), (1, 1, 1)))
    points = [tuple(x or 1e-33 * (i % 3 - 1) for x in p) for i, p in enumerate(points)]
    mesh, report = repair(points, faces)
    assert sorted(mesh.points) == sorted(map(lambda p: tuple(map(float, p)), box((0, 0, 0), (1, 1, 1))[0]))
    assert report['repair']['number_of_flattened_vertices'] > 0 and report['number_of_regions'] == 1
    check_tetrahedra(mesh)


def test_repair_drops_degenerate_triangles():
    points, faces = box((0, 0, 0), (4, 4, 4))
    middle, quarter = len(points), len(points) + 1  # on the edge between the vertices 0 and 1
    points = points + [(2, 0, 0), (1, 0, 0)]
    other = [f for f in faces if {0, 1} <= set(f)]
    assert len(other) == 2
    one = next(i for i, f in enumerate(faces) if (0, 1) in zip(f, f[1:] + f[:1]))
    halves = [tuple(middle if v == w else v for v in faces[one]) for w in (0, 1)]
    soup = faces[:one] + faces[one + 1:] + halves + [(0, middle, 1)]  # closed by a triangle without area
    check_invalid(write('cap.off', off_text(points, soup)), 'degenerate_facet')
    mesh, report = repair(points, soup)
    changes = report['repair']
    assert changes['degenerate_facets'] == [len(soup) - 1] and changes['number_of_open_edges_after'] == 0
    divided, = changes['divided_facets']
    assert {0, 1} <= set(soup[divided]) and changes['number_of_parts_of_divided_facets'] == 2
    assert not changes['is_tolerance_used'] and changes['number_of_new_points'] == 0
    check_tetrahedra(mesh)
    check_sources(mesh, report, points, soup)
    assert report['number_of_regions'] == 1 and volume_of_regions(mesh) == {1: 6 * 64}

    # a fan of them along the edge, one with equal corners, one that stands alone
    fan = soup[:-1] + [(0, quarter, 1), (quarter, middle, 1), (0, quarter, middle), (3, 3, 5), (6, 7, 6)]
    mesh, report = repair(points, fan)
    assert report['number_of_regions'] == 1 and volume_of_regions(mesh) == {1: 6 * 64}
    assert set(report['repair']['degenerate_facets']) == set(range(len(soup) - 1, len(fan)))
    check_sources(mesh, report, points, fan)


def test_repair_leaves_no_gaps_at_degenerate_triangles():
    # five vertices in a row, with triangles between them whose longest edges are parts of each other
    points = [(float(i), 0.0, 0.0) for i in range(5)] + [(1.0, 3.0, 0.0), (2.0, -3.0, 2.0)]
    faces = [(3, 0, 4), (0, 4, 1), (3, 4, 1), (2, 1, 3), (0, 3, 5), (1, 0, 6), (2, 1, 6), (3, 2, 6), (0, 5, 6),
             (3, 6, 5)]
    for order in (faces, faces[::-1], [(b, c, a) for a, b, c in faces], [(c, a, b) for a, b, c in faces]):
        mesh, report = repair(points, order, '--tolerance', '0')
        changes = report['repair']
        assert changes['number_of_open_edges_before'] == changes['number_of_open_edges_after'] == 0
        assert changes['number_of_degenerate_facets'] == 4 and report['number_of_regions'] == 1
        check_tetrahedra(mesh)
        check_sources(mesh, report, points, order)


def test_repair_stitches_edges():
    points, faces = box((0, 0, 0), (4, 4, 4))
    one = next(i for i, f in enumerate(faces) if (0, 1) in zip(f, f[1:] + f[:1]))
    corner, = set(faces[one]) - {0, 1}
    for scale in (1, 2.0 ** -300, 2.0 ** 300):
        beside = [(scale * x, scale * -1e-7, scale * 1e-7) for x in (1, 2, 3.5)]  # not on the edge: there is a gap
        chain = [0, 8, 9, 10, 1]
        soup = faces[:one] + faces[one + 1:] + [(chain[i], chain[i + 1], corner) for i in range(4)]
        scaled = [tuple(scale * x for x in p) for p in points] + beside
        assert report_of(write('gap.off', off_text(scaled, soup)), status=RECOVERED)['domain'] == 'convex_hull'
        mesh, report = repair(scaled, soup)
        changes = report['repair']
        assert changes['number_of_stitched_edges'] == 3 and changes['number_of_merged_vertices'] == 0
        assert changes['number_of_open_edges_before'] == 5 and changes['number_of_open_edges_after'] == 0
        divided, = changes['divided_facets']
        assert {0, 1} <= set(soup[divided]) and mesh.numbers.count(divided) == 4
        assert report['number_of_regions'] == 1 and mesh.points == scaled
        check_tetrahedra(mesh)
        report = repair(scaled, soup, '--tolerance', repr(scale * 1e-9))[1]
        assert is_unchanged(report['repair']) and report['domain'] == 'convex_hull'
    for tolerance in ('1', '1000', '1e300'):  # larger than the edges are
        repair(scaled, soup, '--tolerance', tolerance)


def test_repair_drops_duplicates_and_turns():
    points, faces = box((0, 0, 0), (1, 2, 4))
    for turned in ([0], [3, 7, 8]):
        soup = [f[::-1] if i in turned else f for i, f in enumerate(faces)]
        soup += [soup[5][1:] + soup[5][:1], soup[2][::-1]]
        check_invalid(write('twice.off', off_text(points, soup)), 'duplicate_facet')
        mesh, report = repair(points, soup)
        assert report['repair']['duplicate_facets'] == [12, 13] and report['repair']['reversed_facets'] == turned
        check_domain(mesh, points, faces)


def test_repair_of_intersections():
    surface = join(box((0, 0, 0), (4, 4, 4)), box((2, 2, 2), (6, 6, 6)))
    check_invalid(write('boxes.off', off_text(*surface)), 'intersecting_constraints')
    can = report_of('boxes.off', '--repair', status=run('boxes.off', '--repair').returncode)['repair']['can_resolve_intersections']
    mesh, report = repair(*surface, status=RECOVERED if can else INVALID_INPUT)
    before, after = [report['repair']['number_of_intersections_' + key] for key in ('before', 'after')]
    if not can:
        assert before == after > 0 and report['status'] == 'invalid_input'
        assert 'cannot resolve intersections' in run('repair.off', '--repair', status=INVALID_INPUT).out
        return
    assert before > after == 0 and report['repair']['number_of_new_points'] > 0
    check_tetrahedra(mesh)
    assert sorted(volume_of_regions(mesh).values()) == [6 * 8, 6 * 56, 6 * 56]
    check_sources(mesh, report, *surface)


def test_repair_of_what_is_no_triangle_soup():
    points, faces = box((0, 0, 0), (1, 1, 1))
    for soup in (faces[:-2] + [(0, 6, 4, 2)], faces + [(0, 1, 8)], faces + [(0, 1)]):
        mesh, report = repair(points, soup, status=INVALID_INPUT)
        assert not report['repair']['is_possible'] and is_unchanged(report['repair'])
    process = run(write('nan.off', off_text(points, faces).replace('1 1 1', '1 nan 1')), '--repair', status=INVALID_INPUT)
    assert 'non_finite_coordinate' in process.err
    for soup in ([(0, 0, 1)], [(0, 1, 3)], []):  # nothing is left, or nothing with a volume
        run(write('nothing.off', off_text(points, soup)), '--repair', status=INVALID_INPUT)
    assert run('nan.off', '--repair', '--quiet', status=INVALID_INPUT).out == ''


if __name__ == '__main__':
    run_tests(__doc__, globals())
