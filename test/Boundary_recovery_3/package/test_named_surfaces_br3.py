#!/usr/bin/env python3
"""Runs the program mesh_surface on surfaces with names, polygons and places, in every format that it reads, and checks that
what had a name has it in every format that is written.

usage: test_named_surfaces_br3.py PROGRAM
"""
import collections
import json
import math
import shutil
import struct
import subprocess
import sys

sys.dont_write_bytecode = True  # the folder of the sources stays as it is
import program_tests
from program_tests import *

MESHED = RECOVERED
POINTS = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
# the faces of a cube, turned outward
QUADS = {'bottom': (0, 2, 6, 4), 'top': (1, 5, 7, 3), 'front side': (0, 4, 5, 1), 'back "side"': (2, 3, 7, 6),
         'left': (0, 1, 3, 2), 'right': (4, 6, 7, 5)}
NAMES = list(QUADS)


def triangles():
    """the triangles of the cube, and the name of each"""
    pairs = [(name, t) for name, (a, b, c, d) in QUADS.items() for t in ((a, b, c), (a, c, d))]
    return [t for _, t in pairs], [name for name, _ in pairs]


def read_all(name, *arguments, status=MESHED):
    """the mesh in all formats, the names of the patches of the triangles, and what was printed"""
    process = run(name, '-o', 'out.mesh', '-o', 'out.vtu', '-o', 'out.vtk', '-o', 'out.msh', *arguments, status=status)
    medit, vtu, vtk, gmsh = read_mesh('out.mesh'), read_vtu('out.vtu'), read_vtk('out.vtk'), read_msh('out.msh')
    assert medit == vtu == vtk and vtu.numbers == vtk.numbers == gmsh.mesh.numbers
    assert gmsh.mesh[:4] == vtu[:4] and all(p in (0, q) for p, q in zip(vtu.patches, gmsh.mesh.patches))
    assert vtu.names == vtk.names
    check_tetrahedra(vtu)
    name_of = {number: text for text, values in vtu.names.items() for number, dimension in values if dimension == 2}
    names = [name_of.get(patch) for patch in vtu.patches]
    for name, patch, in_gmsh in zip(names, vtu.patches, gmsh.patches):
        assert in_gmsh == (name.replace('"', "'") if name else 'patch_%d' % patch if patch else 'boundary_of_region_1')
    return vtu, names, process.out


def check_names(name, expected, faces=None, first=0):
    mesh, names, _ = read_all(name)
    assert names == expected, (name, names)
    assert mesh.triangles == [tuple(f) for f in faces or triangles()[0]]
    assert mesh.numbers == [first + i for i in range(len(expected))]


# ---------------------------------------------------------------- names in files

def solid(name, faces):
    return 'solid %s\n%sendsolid %s\n' % (name, stl_text(POINTS, faces).partition('\n')[2].rpartition('endsolid')[0], name)


def stl_with_solids():
    faces, names = triangles()
    return ''.join(solid(name, [f for f, n in zip(faces, names) if n == name]) for name in NAMES)


def test_solids_of_stl():
    mesh, names, _ = read_all(write('solids.stl', stl_with_solids()))
    assert names == triangles()[1]
    corners = [tuple(tuple(map(int, mesh.points[v])) for v in t) for t in mesh.triangles]
    assert corners == [tuple(POINTS[v] for v in t) for t in triangles()[0]]
    for text in (stl_with_solids().replace('\n', '\r\n'), stl_with_solids().replace('solid ', 'SOLID\t')):
        assert read_all(write('solids.stl', text))[1] == triangles()[1]
    # one solid tells nothing apart: sharp edges do
    mesh, names, _ = read_all(write('one.stl', stl_text(POINTS, triangles()[0])))
    assert set(names) == {None} and mesh.patches == [1 + i // 2 for i in range(12)]
    unnamed = ''.join(solid('', [f]) for f in triangles()[0])
    assert read_all(write('unnamed.stl', unnamed))[1] == ['solid_%d' % (i + 1) for i in range(12)]


def test_encodings():
    """what is written is UTF-8, whatever the input is"""
    names = {'caf\u00e9 \u4e2d': 'utf-8', 'caf\u00e9 \u00fc': 'latin-1'}
    for name, encoding in names.items():
        content = stl_with_solids().replace('top', name).encode(encoding)
        assert set(read_all(write('encoded.stl', content))[1]) == {name} | set(NAMES) - {'top'}
    content = stl_with_solids().encode()
    for file_name in (b'caf\xc3\xa9.stl', b'caf\xe9.stl'):
        with open(file_name, 'wb') as f:
            f.write(content)
        run(file_name, '--report', 'report.json', status=MESHED)
        assert json.loads(read('report.json').decode('utf-8'))['input'] == 'caf\u00e9.stl'


def obj_with(lines):
    text = ''.join('v %d %d %d\n' % p for p in POINTS)
    for t, name in zip(*triangles()):
        text += lines(name) + 'f %d %d %d\n' % tuple(v + 1 for v in t)
    return text


def test_names_of_obj():
    expected = triangles()[1]
    check_names(write('groups.obj', obj_with(lambda name: 'g %s\n' % name)), expected, first=1)
    check_names(write('materials.obj', obj_with(lambda name: 'usemtl %s\n' % name)), expected, first=1)
    check_names(write('objects.obj', obj_with(lambda name: 'o\t%s\r\n' % name)), expected, first=1)
    two = obj_with(lambda name: 'g %s\nusemtl %s\n' % (name, 'steel' if name == 'top' else 'air'))
    check_names(write('two.obj', two), [n + (':steel' if n == 'top' else ':air') for n in expected], first=1)
    same = obj_with(lambda name: 'o %s\nusemtl %s\n' % (name, name))
    check_names(write('same.obj', same), expected, first=1)
    # what all have is not part of the names, and that is told
    mesh, names, out = read_all(write('common.obj', 'o Cube\n' + obj_with(lambda name: 'g %s\n' % name)))
    assert names == expected and 'Cube' in out
    some = obj_with(lambda name: 'g %s\n' % (name if name == 'top' else ''))
    check_names(write('some.obj', some), [n if n == 'top' else None for n in expected], first=1)


def test_property_of_ply():
    faces, names = triangles()
    numbers = [10 + NAMES.index(n) for n in names]
    header = ply_header(POINTS, faces, 'ascii').replace('end_header', 'property int patch\nend_header')
    vertices = ''.join('%r %r %r\n' % p for p in POINTS)
    text = header + vertices + ''.join('3 %d %d %d %d\n' % (*f, n) for f, n in zip(faces, numbers))
    assert read_all(write('numbers.ply', text))[0].patches == numbers
    for kind, sign in (('binary_little_endian', '<'), ('binary_big_endian', '>')):
        header = ply_header(POINTS, faces, kind).replace('end_header', 'property short patch\nend_header')
        data = header.encode() + b''.join(struct.pack(sign + '3d', *p) for p in POINTS)
        data += b''.join(struct.pack(sign + 'B3ih', 3, *f, n - 11) for f, n in zip(faces, numbers))
        mesh, found, _ = read_all(write('binary.ply', data))
        assert found == [str(n - 11) for n in numbers], (found, mesh.patches, mesh.names)  # patches are positive: -1, 0, ... are names
    header = ply_header(POINTS, faces, 'ascii').replace('end_header', 'property int patch\nproperty uchar red\nproperty int id\nend_header')
    text = header + vertices + ''.join('3 %d %d %d %d 255 7\n' % (*f, n) for f, n in zip(faces, numbers))
    mesh, _, out = read_all(write('several.ply', text))
    assert mesh.patches == numbers and 'left out' in out and ': id' in out


def test_groups_of_msh():
    faces, names = triangles()
    tags = {name: 3 + i for i, name in enumerate(NAMES)}
    groups = '$PhysicalNames\n7\n1 1 "a curve"\n' + ''.join('2 %d "%s"\n' % (tags[n], n) for n in NAMES) + '$EndPhysicalNames\n'
    nodes = ''.join('%d %d %d %d\n' % (10 * i + 1, *p) for i, p in enumerate(POINTS))
    old = '$MeshFormat\n2.2 0 8\n$EndMeshFormat\n%s$Nodes\n8\n%s$EndNodes\n$Elements\n14\n1 15 2 0 1 1\n2 1 2 1 1 1 11\n' % (groups, nodes)
    old += ''.join('%d 2 2 %d 1 %s\n' % (i + 3, tags[n], ' '.join(str(10 * v + 1) for v in f))
                   for i, (f, n) in enumerate(zip(faces, names))) + '$EndElements\n'
    check_names(write('old.msh', old), names, first=1)
    entities = '$Entities\n1 0 6 0\n1 0 0 0 0\n' + ''.join('%d 0 0 0 1 1 1 1 %d 0\n' % (i + 1, tags[n]) for i, n in enumerate(NAMES))
    new = '$MeshFormat\n4.1 0 8\n$EndMeshFormat\n%s%s$EndEntities\n$Nodes\n1 8 1 71\n2 1 0 8\n' % (groups, entities)
    new += ''.join('%d\n' % (10 * i + 1) for i in range(8)) + ''.join('%d %d %d\n' % p for p in POINTS)
    new += '$EndNodes\n$Elements\n7 13 1 13\n0 1 15 1\n1 1\n' + ''.join(
        '2 %d 2 2\n' % (i + 1) + ''.join('%d %s\n' % (2 + 2 * i + k, ' '.join(str(10 * v + 1) for v in f))
                                         for k, f in enumerate(faces[2 * i:2 * i + 2])) for i in range(6)) + '$EndElements\n'
    check_names(write('new.msh', new), names, first=1)
    without = old.replace(groups, '')
    mesh, found, _ = read_all(write('without.msh', without))
    assert mesh.patches == [tags[n] for n in names] and set(found) == {None}
    for damaged in (old[:len(old) // 2], new[:len(new) // 2], old.replace('2.2 0', '2.2 1'), new.replace('4.1', '4.0'),
                    old.replace(' 71\n', ' 72\n'), '$Nodes'):
        assert 'cannot read' in check_file_error(write('damaged.msh', damaged), '-o', 'never.msh')


def test_what_is_written_is_read():
    """the surfaces of meshes that were written"""
    expected = triangles()[1]
    read_all(write('groups.obj', obj_with(lambda name: 'g %s\n' % name)), '-o', 'again.msh2')
    shutil.copy('out.msh', 'again.msh')
    shutil.copy('out.mesh', 'again.mesh')
    mesh, names, out = read_all('again.msh')
    assert names == [n.replace('"', "'") for n in expected] and 'tetrahedra and other cells' in out
    assert read_all('again.mesh')[0].patches == mesh.patches
    other, names, _ = read_all('again.msh2')
    assert other.patches == mesh.patches and names == [n.replace('"', "'") for n in expected]
    if shutil.which('gmsh'):
        subprocess.run(['gmsh', '-v', '0', 'again.msh', '-save', '-format', 'msh22', '-o', 'old.msh'], check=True,
                       stdin=subprocess.DEVNULL)
        assert set(read_all('old.msh')[1]) == set(n.replace('"', "'") for n in expected)
        subprocess.run(['gmsh', '-v', '0', 'again.msh2', '-save', '-format', 'msh41', '-o', 'new.msh'], check=True,
                       stdin=subprocess.DEVNULL)
        assert set(read_all('new.msh')[1]) == set(n.replace('"', "'") for n in expected)


def test_references_of_mesh():
    faces, names = triangles()
    text = 'MeshVersionFormatted 2\n# a comment\nDimension\n3\nVertices\n8\n' + ''.join('%d %d %d 0\n' % p for p in POINTS)
    text += 'Corners\n2\n1\n2\nTriangles\n12\n' + ''.join('%d %d %d %d\n' % (*[v + 1 for v in f], 5 + NAMES.index(n))
                                                       for f, n in zip(faces, names)) + 'End\n'
    assert read_all(write('references.mesh', text))[0].patches == [5 + NAMES.index(n) for n in names]
    quads = text.split('Corners')[0] + 'Quadrilaterals\n6\n' + ''.join('%d %d %d %d %d\n' % (*[v + 1 for v in q], i + 1)
                                                                      for i, q in enumerate(QUADS.values())) + 'End\n'
    mesh, _, out = read_all(write('quads.mesh', quads))
    assert mesh.patches == [1 + i // 2 for i in range(12)] and mesh.numbers == mesh.patches
    assert 'polygons divided into triangles: 6' in out
    assert 'line' in check_file_error(write('damaged.mesh', text[:200]))


POLY = """# a plate with a hole, as facets with a hole each, and a box inside that is a region
%d 3 0 1
%s
# facets
%d 1
%s
# holes of the volume
%s
# regions
%s
"""


def test_poly_of_tetgen():
    outer = [(x, y, z) for z in (0, 1) for x, y in ((0, 0), (3, 0), (3, 3), (0, 3))]
    inner = [(x, y, z) for z in (0, 1) for x, y in ((1, 1), (2, 1), (2, 2), (1, 2))]
    points = outer + inner

    def numbers(indices, first):
        return '%d %s' % (len(indices), ' '.join(str(v + first) for v in indices))
    sides = [[i, (i + 1) % 4, 4 + (i + 1) % 4, 4 + i] for i in range(4)]
    walls = [[8 + v for v in reversed(side)] for side in sides]
    for first in (0, 1):
        nodes = '\n'.join('%d %d %d %d 0' % (i + first, *p) for i, p in enumerate(points))
        flat = ''.join('2 1 %d\n%s\n%s\n1 1.5 1.5 %d\n' % (7 + z, numbers(range(4 * z, 4 * z + 4)[::2 * z - 1], first),
                                                           numbers(range(8 + 4 * z, 12 + 4 * z), first), z) for z in (0, 1))
        facets = flat + ''.join('1 0 %d\n%s\n' % (marker, numbers(side, first))
                                for marker, group in ((1, sides), (2, walls)) for side in group)
        text = POLY % (len(points), nodes, 10, facets, '0', '1\n1 0.5 0.5 0.5 steel 0.1')
        mesh, _, out = read_all(write('plate.poly', text))
        assert volume_of_regions(mesh) == {1: 6 * 8} and 'largest volumes' in out
        assert mesh.names == {'steel': [(1, 3)]}
        assert collections.Counter(mesh.patches) == {7: 8, 8: 8, 1: 8, 2: 8}
        assert sorted(set(mesh.numbers)) == [i + first for i in range(10)]
        # the points in a file of their own
        write('apart.node', '%d 3 0 1\n%s\n' % (len(points), nodes))
        write('apart.poly', text.replace('%d 3 0 1\n%s\n' % (len(points), nodes), '0 3 0 1\n'))
        assert read_all('apart.poly')[0] == mesh
        # two boxes, the inner one a hole
        smesh = POLY % (8 + 8, '\n'.join('%d %r %r %r' % (i + first, *p) for i, p in enumerate(
            [(x, y, z) for x, y, z in POINTS] + [(x / 4 + 0.25, y / 4 + 0.25, z / 4 + 0.25) for x, y, z in POINTS])), 12,
            '\n'.join(numbers([v + 8 * k for v in q], first) + ' %d' % (k + 1) for k in (0, 1) for q in QUADS.values()),
            '1\n1 0.4 0.4 0.4', '0')
        mesh = read_all(write('hole.smesh', smesh))[0]
        assert volume_of_regions(mesh) == {1: 6 - 6 / 64} and collections.Counter(mesh.patches) == {1: 12, 2: 12}
    crossing = text.replace(numbers(range(8, 12), 1), numbers((8, 10, 9, 11), 1))
    assert 'facet 1' in check_file_error(write('crossing.poly', crossing))
    assert 'no points' in check_file_error(write('none.poly', '0 3 0 0\n'))


# ---------------------------------------------------------------- polygons

def test_polygons():
    quads = list(QUADS.values())
    mesh, _, out = read_all(write('cube.obj', obj_text(POINTS, quads)))
    assert mesh.numbers == [1 + i // 2 for i in range(12)] and mesh.patches == [1 + i // 2 for i in range(12)]
    assert volume_of_regions(mesh) == {1: 6}
    for name, text in (('cube.off', off_text(POINTS, quads)), ('cube.ply', ply_text(POINTS, quads))):
        assert read_all(write(name, text))[0].numbers == [i // 2 for i in range(12)]
    # a star: not convex, so that not each corner may be cut off
    star = [(0, 0), (4, 1), (8, 0), (6, 4), (8, 8), (4, 6), (0, 8), (2, 4)]
    n = len(star)
    points = [(x, y, z) for z in (0, 3) for x, y in star]
    prism = [tuple(range(n))[::-1], tuple(range(n, 2 * n))] + [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    mesh = read_all(write('star.off', off_text(points, prism)))[0]
    area = sum(star[i][0] * star[(i + 1) % n][1] - star[(i + 1) % n][0] * star[i][1] for i in range(n))
    assert volume_of_regions(mesh) == {1: area * 3 * 3}
    assert collections.Counter(mesh.numbers) == {0: 6, 1: 6, **{2 + i: 2 for i in range(n)}}


def refused(name, text, number, word):
    process = run(write(name, text), status=INVALID_INPUT)
    assert word in process.out and 'face %d' % number in process.out and str(number) in process.err, process
    return process


def test_polygons_that_are_refused():
    quads = list(QUADS.values())
    bent = [p if p != (1, 1, 1) else (1, 1, 1.5) for p in POINTS]
    refused('bent.obj', obj_text(bent, quads), 2, 'not flat')
    assert volume_of_regions(read_all('bent.obj', '--repair')[0])[1] > 6
    rounded = [tuple(struct.unpack('f', struct.pack('f', x / 3))[0] for x in p) for p in POINTS]
    read_all(write('rounded.off', off_text(rounded, quads)))
    crossing = quads[:3] + [(2, 7, 3, 6)] + quads[4:]
    refused('crossing.off', off_text(POINTS, crossing), 3, 'cross or touch')
    run('crossing.off', '--repair', status=INVALID_INPUT)
    # a hole, as a polygon with a cut that it passes twice
    points = [(x, y, 0) for x, y in ((0, 0), (3, 0), (3, 3), (0, 3), (1, 1), (1, 2), (2, 2), (2, 1))] + [(1.5, 1.5, 9)]
    cut = [(0, 1, 2, 3, 0, 4, 5, 6, 7, 4)] + [(i, (i + 1) % 4, 8) for i in range(4)]
    refused('hole.off', off_text(points, cut), 0, 'holes')


# ---------------------------------------------------------------- regions and sharp edges

def test_regions_and_voids():
    surface = join(box((1, 1, 1), (2, 2, 2)), box((0, 0, 0), (3, 3, 3)))
    name = write('boxes.off', off_text(*surface))
    inner, outer = ('1.5', '1.5', '1.5'), ('0.5', '.5', '0.5')
    mesh, _, _ = read_all(name, '--region', 'the core', *inner, '--region', 'shell', *outer)
    assert mesh.names == {'the core': [(1, 3)], 'shell': [(2, 3)]}
    assert set(read_msh('out.msh').volumes) == {'the core', 'shell'}
    assert volume_of_regions(mesh) == {1: 6, 2: 6 * 26}
    assert read_all(name, '--region', 'both', *inner, '--region', 'both', *outer)[0].names == {'both': [(1, 3), (2, 3)]}
    assert set(read_msh('out.msh').volumes) == {'both'}  # one group
    mesh = read_all(name, '--void', *inner)[0]
    assert volume_of_regions(mesh) == {1: 6 * 26} and len(mesh.triangles) == 24
    mesh = read_all(name, '--void', *outer, '--region', 'core', *inner)[0]
    assert volume_of_regions(mesh) == {1: 6} and mesh.names == {'core': [(1, 3)]}
    for arguments, word in ((['--region', 'out', '-1', '-.5', '0'], 'of out is in no region'),
                            (['--region', 'wall', '1', '1.5', '1.5'], 'of wall is in no region'),
                            (['--region', 'a', *inner, '--region', 'b', *inner], 'has the name a'),
                            (['--void', *inner, '--region', 'core', *inner], 'of core is in no region'),
                            (['--void', '9', '9', '9'], 'no region has the place (9 9 9)')):
        process = run(name, '-o', 'never.msh', *arguments, status=INVALID_INPUT)
        assert word in process.err, process
    assert 'no region' in run(name, '--void', *inner, '--void', *outer).err
    for arguments in (['--region', 'a', '1', '2'], ['--void', '1', '2'], ['--void', '1', '2', 'x']):
        check_file_error(name, *arguments)


def test_sharp_edges():
    n = 24
    ring = [(math.cos(2 * math.pi * i / n), math.sin(2 * math.pi * i / n)) for i in range(n)]
    points = [(x, y, z) for z in (0, 2) for x, y in ring]
    faces = [tuple(range(n))[::-1], tuple(range(n, 2 * n))]
    faces += [t for i in range(n) for t in ((i, (i + 1) % n, n + i), ((i + 1) % n, n + (i + 1) % n, n + i))]
    name = write('cylinder.off', off_text(points, faces))
    mesh = read_all(name)[0]
    assert mesh.patches == (n - 2) * [1] + (n - 2) * [2] + 2 * n * [3]
    assert set(read_all(name, '--patch-angle', '100')[0].patches) == {1}
    assert len(set(read_all(name, '--patch-angle', '10')[0].patches)) == 2 + n
    check_file_error(name, '--patch-angle', '200')
    turned = [face[::-1] if i % 3 == 0 else face for i, face in enumerate(faces)]  # whichever way they are turned
    assert read_all(write('turned.off', off_text(points, turned)))[0].patches == mesh.patches


if __name__ == '__main__':
    run_tests(__doc__, globals())
