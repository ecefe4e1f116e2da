#!/usr/bin/env python3
"""Reads what mesh_surface writes by the readers of others, Gmsh, meshio and VTK: names, regions, patches, numbers of
triangles, and coordinates bit for bit, in each format and in both orders. What is not installed is left out, and that is
told.

usage: test_other_readers_br3.py PROGRAM
"""
import collections
import functools
import json
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True  # the folder of the sources stays as it is
from program_tests import *

MESHED = RECOVERED
EDGES = ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))  # in the order of VTK, meshio and MEDIT
REGIONS = {1: 'the "core"', 2: 'sh\u00e4ll'}
PATCHES = {1: 'inlet', 2: 'w\u00e4ll of it', 3: 'out "let"'}
SHEET = 3

# Prints as JSON what a module of Python reads of the file that is its second argument, if there is one.
READER = """
import json, sys
name = sys.argv[2] if len(sys.argv) > 2 else None

def by_meshio():
    import meshio
    if name is None:
        return
    mesh = meshio.read(name, file_format='gmsh' if name.endswith('.msh2') else None)
    cells, data = [], {key: [] for key in mesh.cell_data}
    for i, block in enumerate(mesh.cells):
        cells += block.data.tolist()
        for key in data:
            data[key] += [int(x) for x in mesh.cell_data[key][i]]
    names = {key: [[int(x) for x in value.reshape(-1)]] for key, value in mesh.field_data.items()}
    print(json.dumps({'points': mesh.points.tolist(), 'cells': cells, 'data': data, 'names': names}))

def by_VTK():
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
    from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader
    from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
    if name is None:
        return
    reader = vtkXMLUnstructuredGridReader() if name.endswith('.vtu') else vtkUnstructuredGridReader()
    reader.SetFileName(name)
    sizes = vtkCellSizeFilter()
    sizes.SetInputConnection(reader.GetOutputPort())
    sizes.Update()
    grid, measured = reader.GetOutput(), sizes.GetOutput().GetCellData().GetArray('Volume')
    cells = []
    for i in range(grid.GetNumberOfCells()):
        ids = grid.GetCell(i).GetPointIds()
        cells.append([ids.GetId(k) for k in range(ids.GetNumberOfIds())])
        assert grid.GetCellType(i) == {3: 5, 4: 10, 6: 22, 10: 24}[len(cells[-1])]
    def rows(array):
        return [[int(x) for x in array.GetTuple(i)] for i in range(array.GetNumberOfTuples())]
    def arrays(data):
        return {data.GetArrayName(i): rows(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}
    print(json.dumps({'points': [grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())], 'cells': cells,
                      'data': {key: [row[0] for row in value] for key, value in arrays(grid.GetCellData()).items()},
                      'names': arrays(grid.GetFieldData()),
                      'volume': sum(measured.GetTuple1(i) for i in range(grid.GetNumberOfCells()))}))

{'meshio': by_meshio, 'VTK': by_VTK}[sys.argv[1]]()
"""


@functools.lru_cache(maxsize=None)
def interpreter(module):
    """a Python that has the module: Debian's packages are for that of Debian"""
    for python in (sys.executable, '/usr/bin/python3'):
        if os.path.exists(python) and subprocess.run([python, '-c', READER, module], capture_output=True).returncode == 0:
            return python
    print('skipped:', module, 'is not installed')
    return None


def read_by(module, name):
    process = subprocess.run([interpreter(module), '-c', READER, module, name], capture_output=True, timeout=300)
    assert process.returncode == 0, (name, process)
    return json.loads(process.stdout.decode().strip().split('\n')[-1])  # after what meshio says of names in .su2


def gmsh(*arguments):
    process = subprocess.run(['gmsh', '-v', '4', *arguments], capture_output=True, timeout=300, stdin=subprocess.DEVNULL)
    output = process.stdout + process.stderr
    assert process.returncode == 0 and b'Error' not in output and b'Warning' not in output, process
    return output.decode()


@functools.lru_cache(maxsize=None)
def has_gmsh():
    if not shutil.which('gmsh'):
        print('skipped: gmsh is not installed')
    return shutil.which('gmsh') is not None


def has_readers(*modules):
    return all([interpreter(module) for module in modules])


# ---------------------------------------------------------------- what is written

def surface():
    """a box in a box, and a sheet: points whose coordinates need all digits, triangles, and the patch of each"""
    inner, outer = box((0.1, 1 / 7, -1e-9), (1 / 3, 0.7, 0.3)), box((-1, -2 / 3, -0.7), (1.1, 4 / 3, 1e6 / 999999))
    sheet = [(0.7, 0.1, 0.2), (0.8, 1 / 9, 0.2), (0.75, 0.7, 0.3)], [(0, 1, 2)]
    points, faces = join(inner, outer, sheet)
    patches = [1] * 12 + [2] * 8 + [1] * 4 + [SHEET]
    return points, faces, patches


def write_surface(name='in.obj'):
    points, faces, patches = surface()
    text = ''.join('v %r %r %r\n' % tuple(p) for p in points)
    for f, patch in zip(faces, patches):
        text += 'g %s\nf %d %d %d\n' % (PATCHES[patch], *(v + 1 for v in f))
    return write(name, text)


def mesh_in_all_formats(order):
    arguments = [x for extension in ('msh', 'msh2', 'vtu', 'vtk', 'mesh') for x in ('-o', 'out.' + extension)]
    return run(write_surface(), '--size', '0.5', '--order', order, '--region', REGIONS[1], '0.2', '0.4', '0.1', '--region',
               REGIONS[2], '1', '0', '0', *arguments, status=MESHED)


class Expected:
    """the mesh as we read it, and what is known of its surface"""
    def __init__(self):
        run(write_surface(), '--size', '0.5', '-o', 'first.mesh', status=MESHED)
        self.mesh = read_mesh('first.mesh')
        points, faces, patches = surface()
        assert self.mesh.points[:len(points)] == [tuple(map(float, p)) for p in points]
        assert self.mesh.triangles == [tuple(f) for f in faces]
        beside = collections.defaultdict(list)
        for t, region in zip(self.mesh.tetrahedra, self.mesh.regions):
            for i in range(4):
                beside[frozenset(t[:i] + t[i + 1:])].append(region)
        # patches are numbered in the order in which their names come
        self.triangles = {f: {'patch': patch, 'triangle': i + 1, 'region': min(beside[frozenset(f)])}
                          for i, (f, patch) in enumerate(zip(faces, patches))}
        self.tetrahedra = {t: {'patch': 0, 'triangle': -1, 'region': region}
                           for t, region in zip(self.mesh.tetrahedra, self.mesh.regions)}
        self.volume = math.prod((2.1, 2, 1e6 / 999999 + 0.7))
        number_of_edges = len({frozenset((c[i], c[j])) for c in [*self.tetrahedra, *self.triangles] for i, j in EDGES
                               if j < len(c)})
        self.number_of_points = {'1': len(self.mesh.points), '2': len(self.mesh.points) + number_of_edges}

    def check_points(self, points, cells, order):
        """coordinates bit for bit, and each node of an edge in the middle of its ends"""
        points = [tuple(p) for p in points]
        assert points[:len(self.mesh.points)] == self.mesh.points
        assert len(points) == self.number_of_points[order] and len(set(points)) == len(points)
        edges = {}
        for cell in cells:
            corners = 4 if len(cell) in (4, 10) else 3
            assert len(cell) == (corners if order == '1' else {4: 10, 3: 6}[corners])
            for (i, j), node in zip(EDGES, cell[corners:]):
                u, v = cell[i], cell[j]
                assert points[node] == tuple((x + y) / 2 for x, y in zip(points[u], points[v])), (cell, i, j)
                assert edges.setdefault(frozenset((u, v)), node) == node

    def check_cells(self, cells, data, order):
        """the corners of each cell in their order, and what is told of it; `data` has some of our arrays"""
        found = set()
        for i, cell in enumerate(cells):
            corners = tuple(cell if order == '1' else cell[:4] if len(cell) == 10 else cell[:3])
            expected = (self.tetrahedra if len(corners) == 4 else self.triangles)[corners]
            for key, values in data.items():
                assert values[i] == expected[key], (corners, key, values[i], expected)
            found.add(corners)
        assert len(cells) == len(found) == len(self.tetrahedra) + len(self.triangles)


def name_in_gmsh(name):
    return name.replace('"', "'")


GMSH_NAMES = {**{name_in_gmsh(name): [[patch, 2]] for patch, name in PATCHES.items()},
              **{name_in_gmsh(name): [[region, 3]] for region, name in REGIONS.items()}}
VTK_NAMES = {**{name: [[patch, 2]] for patch, name in PATCHES.items()},
             **{name: [[region, 3]] for region, name in REGIONS.items()}}


def check_groups(expected, cells, data):
    """Gmsh's groups and entities: that of a triangle is its patch, that of a tetrahedron its region"""
    for cell, group in zip(cells, data):
        if len(cell) in (4, 10):
            assert group == expected.tetrahedra[tuple(cell[:4])]['region']
        else:
            assert group == expected.triangles[tuple(cell[:3])]['patch']


def in_order_of(known, points, cells):
    """points and cells with the numbers that the known points have: Gmsh writes points in an order of its own"""
    number = {p: i for i, p in enumerate(known)}
    for p in map(tuple, points):
        number.setdefault(p, len(number))
    return list(number), [[number[tuple(points[v])] for v in cell] for cell in cells]


def check_file(module, name, order, expected):
    """a file as a module reads it; of those that Gmsh has written, the name tells that"""
    found = read_by(module, name)
    cells, data = found['cells'], found['data']
    if name.startswith('from_'):
        assert len(found['points']) == expected.number_of_points[order]
        found['points'], cells = in_order_of(expected.mesh.points, found['points'], cells)
    expected.check_points(found['points'], cells, order)
    ours = {key: data[key] for key in ('region', 'patch', 'triangle') if key in data}
    expected.check_cells(cells, ours, order)
    if name.endswith(('.vtu', '.vtk')):
        assert set(data) == {'region', 'patch', 'triangle'}
        assert found['names'] == VTK_NAMES or (module == 'meshio' and name.endswith('.vtk')), found['names']
    elif name.endswith('.mesh'):
        check_groups(expected, cells, data['medit:ref'])
    elif 'medit' in name:
        check_groups(expected, cells, data['gmsh:geometrical'])
    else:
        check_groups(expected, cells, data['gmsh:physical'])
        assert found['names'] == GMSH_NAMES, found['names']
        assert ('triangle' in data and 'region' in data) == (name == 'out.msh')
    if module == 'VTK':
        assert math.isclose(found['volume'], expected.volume, rel_tol=1e-12), found['volume']


def check_all_readers(order):
    expected = Expected()
    mesh_in_all_formats(order)
    if has_readers('meshio'):
        # of MEDIT's files, it knows those of first order
        for name in ['out.msh', 'out.msh2', 'out.vtu', 'out.vtk'] + ['out.mesh'] * (order == '1'):
            check_file('meshio', name, order, expected)
    if has_readers('VTK'):
        for name in ('out.vtu', 'out.vtk'):
            check_file('VTK', name, order, expected)
    if has_gmsh() and has_readers('meshio'):
        for name, again in (('out.msh', 'from_msh.msh'), ('out.msh2', 'from_msh2.msh'), ('out.mesh', 'from_medit.msh')):
            gmsh(name, '-save', '-format', 'msh41', '-bin', '-o', again)
            check_file('meshio', again, order, expected)
    if has_gmsh():
        gmsh('-check', 'out.msh')


def test_first_order():
    check_all_readers('1')


def test_second_order():
    check_all_readers('2')


# ---------------------------------------------------------------- what Gmsh writes for us

def is_built_with_libgmsh():
    process = run(write('box.off', off_text(*box((0, 0, 0), (1, 1, 1)))), '-o', 'box.inp')
    if process.returncode == MESHED:
        return True
    assert process.returncode == FILE_ERROR and not os.path.exists('box.inp'), process
    assert 'libgmsh' in process.err and 'box.inp (known are .mesh, .msh' in process.err, process
    print('skipped: the program was built without libgmsh, or it cannot be loaded')
    return False


def name_of_set(name):
    return name_in_gmsh(name).replace(' ', '_')


def are_close(p, q):
    """Gmsh writes about 14 digits"""
    return all(math.isclose(x, y, rel_tol=1e-12, abs_tol=1e-12) for x, y in zip(p, q))


def read_inp(name):
    """points, and cells with the sets of elements that have them, of a file of Abaqus"""
    points, cells, sets, keyword, options = {}, {}, collections.defaultdict(set), '', {}
    for line in read(name).decode().split('\n'):
        words = [word.strip() for word in line.strip().strip(',').split(',')]
        if line.startswith('*'):
            keyword, options = words[0], dict(word.split('=') for word in words[1:])
        elif keyword == '*NODE':
            points[int(words[0])] = tuple(map(float, words[1:]))
        elif keyword == '*ELEMENT':
            cells[int(words[0])] = [int(word) for word in words[1:]]
        elif keyword == '*ELSET' and words != ['']:
            for word in words:
                sets[int(word)].add(options['ELSET'])
    order = sorted(points)
    assert order == list(range(1, len(order) + 1))
    return [points[i] for i in order], [([v - 1 for v in cell], sets[i]) for i, cell in sorted(cells.items())]


def test_formats_of_libgmsh():
    if not is_built_with_libgmsh():
        return
    expected = Expected()
    arguments = ('in.obj', '--size', '0.5', '--region', REGIONS[1], '0.2', '0.4', '0.1', '--region', REGIONS[2], '1', '0', '0')
    names = {('patch', p): name_of_set(n) for p, n in PATCHES.items()}
    names.update({('region', r): name_of_set(n) for r, n in REGIONS.items()})
    for order in ('1', '2'):
        run(*arguments, '--order', order, '-o', 'out.inp', '-o', 'out.unv', '-o', 'out.bdf', '-o', 'out.KEY', status=MESHED)
        assert all(os.path.getsize('out.' + extension) > 10000 for extension in ('unv', 'bdf', 'KEY'))
        run(*arguments, '--order', order, '-o', os.path.abspath('again.inp'), status=MESHED)
        assert read('again.inp') == read('out.inp')
        points, cells = read_inp('out.inp')
        n = len(expected.mesh.points)
        assert len(points) == expected.number_of_points[order]
        assert all(are_close(p, q) for p, q in zip(points, expected.mesh.points))
        for nodes, sets in cells:
            corners = tuple(nodes[:4] if len(nodes) in (4, 10) else nodes[:3])
            for (i, j), node in zip(EDGES, nodes[len(corners):]):
                assert node >= n and are_close(points[node], [(x + y) / 2 for x, y in zip(points[corners[i]], points[corners[j]])])
            kind, cell = (('region', expected.tetrahedra) if len(corners) == 4 else ('patch', expected.triangles))
            assert names[kind, cell[corners][kind]] in sets
        assert len(cells) == len(expected.tetrahedra) + len(expected.triangles)
    run(*arguments, '-o', 'out.su2', status=MESHED)
    words = read('out.su2').decode()
    assert all('MARKER_TAG= %s\n' % name_of_set(name) in words for name in PATCHES.values())
    assert 'no elements of second order: never.su2' in check_file_error('in.obj', '--order', '2', '-o', 'never.su2')
    if has_readers('meshio'):
        found = read_by('meshio', 'out.su2')
        assert len(found['cells']) == len(expected.tetrahedra) + len(expected.triangles)
        known, points = ([tuple(round(x, 10) + 0.0 for x in p) for p in mesh] for mesh in (expected.mesh.points, found['points']))
        assert len(known) == len(points) == len(set(points))
        _, cells = in_order_of(known, points, found['cells'])
        assert {tuple(c) for c in cells if len(c) == 4} == set(expected.tetrahedra)
    assert 'cannot write' in check_file_error('in.obj', '-o', os.path.join('no such folder', 'out.inp'))
    if os.path.exists('/dev/full'):
        os.symlink('/dev/full', 'full.inp')
        assert 'cannot write full.inp' in run('in.obj', '-o', 'full.inp', '--quiet', status=FILE_ERROR).err


# ---------------------------------------------------------------- second order

def jacobians(name):
    """the smallest determinant of all tetrahedra, by Gmsh, and the smallest quotient of the smallest and the largest one
    of a tetrahedron: 1 if all are straight"""
    write('jacobians.geo', ('Merge "%s";\n' + ''.join('Plugin(AnalyseMeshQuality).%s;\n' % option for option in (
        'JacobianDeterminant = 1', 'CreateView = 0', 'Recompute = 1', 'DimensionOfElements = 3', 'Run'))) % name)
    lines = gmsh('jacobians.geo', '-').split('\n')
    return [float(next(line for line in lines if re.search(r'\b%s +=' % figure, line)).split('=')[1].split(',')[0])
            for figure in ('minJ', 'minJ/maxJ')]


def test_positive_jacobians():
    if not has_gmsh():
        return
    mesh_in_all_formats('2')
    for name in ('out.msh', 'out.msh2', 'out.mesh'):
        smallest, quotient = jacobians(name)
        assert smallest > 0 and quotient > 0.999999, (name, smallest, quotient)
    # in VTK's order of nodes, they would not be
    head, mark, tail = read('out.msh2').decode().partition('$Elements\n')
    lines = [line.split() for line in tail.split('\n')]
    wrong = '\n'.join(' '.join(words[:-2] + [words[-1], words[-2]] if words[1:2] == ['11'] else words) for words in lines)
    write('wrong.msh2', head + mark + wrong)
    assert jacobians('wrong.msh2')[0] < 0


def test_defaults_and_refusals():
    name = write('box.off', off_text(*box((0, 0, 0), (1, 1, 1))))
    run(name, '-o', 'default.msh', status=MESHED)
    run(name, '-o', 'one.msh', '--order', '1', status=MESHED)
    assert read('one.msh') == read('default.msh')
    assert '--order is one of 1|2' in check_file_error(name, '-o', 'never.msh', '--order', '3')
    # sub-domains are no matter, and the figures are those of the mesh, not of the file
    run(name, '-o', 'two.mesh', '--order', '2', '--subdomains', '2', '--size', '0.2', '--report', 'two.json', status=MESHED)
    run(name, '-o', 'first.mesh', '--subdomains', '2', '--size', '0.2', '--report', 'one.json', status=MESHED)
    one, two = json.loads(read('one.json')), json.loads(read('two.json'))
    assert (one['order'], two['order']) == (1, 2) and one['number_of_points'] == two['number_of_points']
    assert read('two.mesh').count(b'\n') > read('first.mesh').count(b'\n') + 6 * one['number_of_points']


if __name__ == '__main__':
    run_tests(__doc__, globals())
