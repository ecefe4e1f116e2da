"""What the tests of the programs have in common: surfaces, writers, readers, checks, and a way to run the programs.

Every mesh is read back by parsers of this file and checked with exact rational arithmetic.
"""
import collections
import contextlib
import json
import math
import os
import re
import struct
import subprocess
import sys
import tempfile
import traceback
import urllib.parse
import xml.etree.ElementTree
from fractions import Fraction

PROGRAM = ''
RECOVERED, FILE_ERROR, INVALID_INPUT, INCOMPLETE = 0, 1, 2, 3


# ---------------------------------------------------------------- surfaces

def box(low, high, outward=True):
    """the vertices and triangles of a box"""
    points = [tuple(high[i] if corner >> i & 1 else low[i] for i in range(3)) for corner in range(8)]
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    faces = [t for q in quads for t in ((q[0], q[1], q[2]), (q[0], q[2], q[3]))]
    return points, faces if outward else [(a, c, b) for a, b, c in faces]


def grid_box(n):
    """the surface of a cube of edge 1, with n * n squares on each side"""
    index, points, faces = {}, [], []

    def vertex(p):
        if p not in index:
            index[p] = len(points)
            points.append(tuple(x / n for x in p))
        return index[p]
    for axis in range(3):
        for side in (0, n):
            for i in range(n):
                for j in range(n):
                    corners = []
                    for u, v in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                        p = [u, v]
                        p.insert(axis, side)
                        corners.append(vertex(tuple(p)))
                    if (side == 0) != (axis == 1):
                        corners.reverse()
                    faces += [tuple(corners[:3]), (corners[0], corners[2], corners[3])]
    return points, faces


def join(*surfaces):
    """one soup of several ones; points are not merged"""
    points, faces = [], []
    for p, f in surfaces:
        faces += [tuple(v + len(points) for v in t) for t in f]
        points += p
    return points, faces


def tetrahedron():
    return [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]


def schonhardt():
    """a twisted prism: no tetrahedralization without further points has its edges a_i b_(i+1)"""
    def ring(z, turn):
        return [(math.cos(math.radians(120 * i + turn)), math.sin(math.radians(120 * i + turn)), z) for i in range(3)]
    faces = [(0, 2, 1), (3, 4, 5)]
    for i in range(3):
        j = (i + 1) % 3
        faces += [(i, j, j + 3), (i, j + 3, i + 3)]
    return ring(0, 0) + ring(1, 30), faces


def twisted_box(outward):
    """a box, and inside it a twisted prism that bounds a void or a second region"""
    points, faces = schonhardt()
    return join(box((-3, -3, -3), (3, 3, 3)), (points, faces if outward else [(a, c, b) for a, b, c in faces]))


def soup_of(points, faces):
    """the same surface with vertices of its own for each face, as in an STL file"""
    return [points[v] for f in faces for v in f], [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(len(faces))]


def signed_volume(points, cells):
    """six times the sum of the exact volumes of simplices; triangles are joined to the origin"""
    return sum(determinant([(0, 0, 0)] + [points[v] for v in c] if len(c) == 3 else [points[v] for v in c])
               for c in cells)


def integers(points):
    """the points, all scaled by the same power of two: calculations are exact, and much faster than with fractions"""
    scale = max(x.as_integer_ratio()[1] for p in points for x in p)
    return [tuple(x.as_integer_ratio()[0] * (scale // x.as_integer_ratio()[1]) for x in p) for p in points]


def determinant(corners):
    origin, *others = [[x if isinstance(x, int) else Fraction(x) for x in p] for p in corners]
    a, b, c = [[x - o for x, o in zip(p, origin)] for p in others]
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
            + a[2] * (b[0] * c[1] - b[1] * c[0]))


# ---------------------------------------------------------------- writing of inputs

def off_text(points, faces):
    return ('OFF\n%d %d 0\n' % (len(points), len(faces)) + ''.join('%r %r %r\n' % tuple(p) for p in points)
            + ''.join('%d %s\n' % (len(f), ' '.join(map(str, f))) for f in faces))


def obj_text(points, faces):
    return (''.join('v %r %r %r\n' % tuple(p) for p in points)
            + ''.join('f %s\n' % ' '.join(str(v + 1) for v in f) for f in faces))


def ply_header(points, faces, kind):
    return ('ply\nformat %s 1.0\nelement vertex %d\nproperty double x\nproperty double y\nproperty double z\n'
            'element face %d\nproperty list uchar int vertex_indices\nend_header\n' % (kind, len(points), len(faces)))


def ply_text(points, faces):
    return ply_header(points, faces, 'ascii') + off_text(points, faces).split('\n', 2)[2]


def ply_binary(points, faces):
    return (ply_header(points, faces, 'binary_little_endian').encode()
            + b''.join(struct.pack('<3d', *p) for p in points)
            + b''.join(struct.pack('<B%di' % len(f), len(f), *f) for f in faces))


def stl_text(points, faces):
    facets = ''.join('facet normal 0 0 0\nouter loop\n' + ''.join('vertex %r %r %r\n' % tuple(points[v]) for v in f)
                     + 'endloop\nendfacet\n' for f in faces)
    return 'solid test\n' + facets + 'endsolid test\n'


def stl_binary(points, faces):
    return (b'\0' * 80 + struct.pack('<I', len(faces))
            + b''.join(struct.pack('<12fH', 0, 0, 0, *[x for v in f for x in points[v]], 0) for f in faces))


def off_binary(points, faces, colors_of_faces=b'', colors_of_vertices=b'', keyword=b'OFF'):
    """big endian; without colors of faces their number is there, as 0; it is not if they are None"""
    number = b'' if colors_of_faces is None else struct.pack('>i', len(colors_of_faces) // 4) + colors_of_faces
    return (keyword + b' BINARY\n' + struct.pack('>3i', len(points), len(faces), 0)
            + b''.join(struct.pack('>3f', *p) + colors_of_vertices for p in points)
            + b''.join(struct.pack('>%di' % (1 + len(f)), len(f), *f) + number for f in faces))


# ---------------------------------------------------------------- reading of outputs

class Mesh(collections.namedtuple('Mesh', 'points tetrahedra regions triangles patches')):
    """what every format has; `numbers` are those of the triangles in the input, where the format has them"""
    numbers = None

    def with_numbers(self, numbers):
        self.numbers = list(numbers)
        return self


def read_mesh(name):
    words = iter(open(name, encoding='utf-8').read().split())
    assert [next(words) for _ in range(4)] == ['MeshVersionFormatted', '2', 'Dimension', '3']

    def section(keyword, size):
        assert next(words) == keyword
        return [[next(words) for _ in range(size)] for _ in range(int(next(words)))]
    vertices = section('Vertices', 4)
    triangles = section('Triangles', 4)
    tetrahedra = section('Tetrahedra', 5)
    assert next(words) == 'End' and next(words, None) is None
    return Mesh([tuple(map(float, v[:3])) for v in vertices],
                [tuple(int(i) - 1 for i in t[:4]) for t in tetrahedra], [int(t[4]) for t in tetrahedra],
                [tuple(int(i) - 1 for i in t[:3]) for t in triangles], [int(t[3]) for t in triangles])


def split_cells(cells, regions, patches, numbers, points):
    """the mesh of VTK's cells: tetrahedra first, then triangles, which have the region of a tetrahedron beside them"""
    n = sum(len(c) == 4 for c in cells)
    assert all(len(c) == 4 for c in cells[:n]) and all(len(c) == 3 for c in cells[n:])
    assert patches[:n] == [0] * n and len(regions) == len(patches) == len(numbers) == len(cells)
    assert numbers[:n] == [-1] * n
    beside = collections.defaultdict(list)
    for t, region in zip(cells[:n], regions):
        for i in range(4):
            beside[frozenset(t[:i] + t[i + 1:])].append(region)
    for t, region in zip(cells[n:], regions[n:]):
        assert region == min((r for r in beside[frozenset(t)] if r != 0), default=0)
    return Mesh(points, cells[:n], regions[:n], cells[n:], patches[n:]).with_numbers(numbers[n:])


def read_vtk(name):
    lines = open(name, encoding='utf-8').read().split('\n')
    assert lines[0].startswith('# vtk DataFile Version') and lines[2:4] == ['ASCII', 'DATASET UNSTRUCTURED_GRID']
    words = iter(' '.join(lines[4:]).split())

    def expect(*expected):
        for word in expected:
            assert next(words) == word, word
    names = {}
    keyword = next(words)
    if keyword == 'FIELD':
        expect('FieldData')
        for _ in range(int(next(words))):
            name = urllib.parse.unquote(next(words))
            expect('2')
            number = int(next(words))
            expect('int')
            names[name] = [(int(next(words)), int(next(words))) for _ in range(number)]
        keyword = next(words)
    assert keyword == 'POINTS'
    n = int(next(words))
    expect('double')
    points = [tuple(float(next(words)) for _ in range(3)) for _ in range(n)]
    expect('CELLS')
    m, size = int(next(words)), int(next(words))
    cells = [tuple(int(next(words)) for _ in range(int(next(words)))) for _ in range(m)]
    assert size == sum(len(c) + 1 for c in cells)
    expect('CELL_TYPES', str(m), *['10' if len(c) == 4 else '5' for c in cells])
    expect('CELL_DATA', str(m), 'SCALARS', 'region', 'int', '1', 'LOOKUP_TABLE', 'default')
    regions = [int(next(words)) for _ in range(m)]
    expect('FIELD', 'FieldData', '2', 'patch', '1', str(m), 'int')
    patches = [int(next(words)) for _ in range(m)]
    expect('triangle', '1', str(m), 'long')
    numbers = [int(next(words)) for _ in range(m)]
    assert next(words, None) is None
    mesh = split_cells(cells, regions, patches, numbers, points)
    mesh.names = names
    return mesh


def read_vtu(name):
    """the arrays are raw bytes behind the XML, which cannot be parsed with them"""
    text, mark, data = read(name).partition(b'<AppendedData encoding="raw">\n_')
    data, end, rest = data.rpartition(b'\n</AppendedData>')
    assert mark and end and rest == b'\n</VTKFile>\n'
    root = xml.etree.ElementTree.fromstring(text + b'</VTKFile>')
    assert root.tag == 'VTKFile' and root.get('type') == 'UnstructuredGrid' and root.get('header_type') == 'UInt64'
    order = {'LittleEndian': '<', 'BigEndian': '>'}[root.get('byte_order')]
    assert {'<': 'little', '>': 'big'}[order] == sys.byteorder
    piece = root.find('UnstructuredGrid/Piece')
    n, m = int(piece.get('NumberOfPoints')), int(piece.get('NumberOfCells'))
    used = []

    def array(path, kind, code, size):
        element = piece.find(path)
        assert element.get('format') == 'appended' and element.get('type') == kind
        begin = int(element.get('offset')) + 8
        length, = struct.unpack_from(order + 'Q', data, begin - 8)
        used.append((begin - 8, begin + length))
        assert size is None or length == size * struct.calcsize(code)
        return struct.unpack_from('%s%d%s' % (order, length // struct.calcsize(code), code), data, begin)
    x = array('Points/DataArray', 'Float64', 'd', 3 * n)
    v = array("Cells/DataArray[@Name='connectivity']", 'Int64', 'q', None)
    ends = array("Cells/DataArray[@Name='offsets']", 'Int64', 'q', m)
    types = array("Cells/DataArray[@Name='types']", 'UInt8', 'B', m)
    regions = array("CellData/DataArray[@Name='region']", 'Int32', 'i', m)
    patches = array("CellData/DataArray[@Name='patch']", 'Int32', 'i', m)
    numbers = array("CellData/DataArray[@Name='triangle']", 'Int64', 'q', m)
    used.sort()
    assert [begin for begin, _ in used] == [0] + [end for _, end in used[:-1]] and used[-1][1] == len(data)
    cells = [v[begin:end] for begin, end in zip((0,) + ends, ends)]
    assert ends[-1:] in ((), (len(v),)) and list(types) == [10 if len(c) == 4 else 5 for c in cells]
    mesh = split_cells(cells, list(regions), list(patches), list(numbers), [tuple(x[3 * i:3 * i + 3]) for i in range(n)])
    mesh.names = {}
    for element in root.findall('UnstructuredGrid/FieldData/DataArray'):
        values = list(map(int, element.text.split()))
        assert element.get('NumberOfComponents') == '2' and len(values) == 2 * int(element.get('NumberOfTuples'))
        mesh.names[element.get('Name')] = list(zip(values[::2], values[1::2]))
    return mesh


def volume_of_regions(mesh):
    volumes = collections.Counter()
    for t, region in zip(mesh.tetrahedra, mesh.regions):
        volumes[region] += signed_volume(mesh.points, [t])
    return volumes


# A mesh; the names of the volumes and patches of its tetrahedra and triangles; for each node the entity that has it.
Gmsh_mesh = collections.namedtuple('Gmsh_mesh', 'mesh volumes patches owners')


class Gmsh_words:
    """the numbers of a section, as text or binary"""
    def __init__(self, data, is_binary):
        self.data, self.is_binary, self.position = data if is_binary else data.split(), is_binary, 0

    def take(self, code, n=1):
        if self.is_binary:
            values = struct.unpack_from('=%d%s' % (n, code), self.data, self.position)
            self.position += struct.calcsize('=%d%s' % (n, code))
        else:
            values = [(float if code == 'd' else int)(word) for word in self.data[self.position:self.position + n]]
            assert len(values) == n
            self.position += n
        return tuple(values)

    def take_one(self, code):
        return self.take(code)[0]

    def check_end(self):
        assert self.position == len(self.data), (self.position, len(self.data))


def read_msh_sections(name):
    """the sections of a file in Gmsh's format 4.1, as bytes, and whether they are binary"""
    data, sections = read(name), {}
    while data.strip():
        keyword, _, data = data.lstrip().partition(b'\n')
        content, mark, data = data.partition(b'\n$End' + keyword[1:] + b'\n')
        assert keyword.startswith(b'$') and mark, keyword
        name = keyword[1:].decode()
        sections[name if name not in sections else name + ' 2'] = content
    version, is_binary, size = sections.pop('MeshFormat').split()[:3]
    assert version == b'4.1' and size == b'8'
    return sections, is_binary == b'1'


def read_msh(name):
    sections, is_binary = read_msh_sections(name)
    names = {}
    lines = sections.pop('PhysicalNames').decode().split('\n')
    for line in lines[1:]:
        dimension, tag, quoted = line.split(' ', 2)
        names[int(dimension), int(tag)] = quoted.strip('"')
    assert len(names) == int(lines[0])

    words = Gmsh_words(sections.pop('Entities'), is_binary)
    counts, group_of, boxes = words.take('Q', 4), {}, {}
    assert counts[:2] == (0, 0)
    for dimension in (2, 3):
        for _ in range(counts[dimension]):
            tag = words.take_one('i')
            boxes[dimension, tag] = words.take('d', 6)
            assert words.take_one('Q') == 1
            group_of[dimension, tag] = words.take_one('i')
            words.take('i', words.take_one('Q'))  # surfaces around
    words.check_end()

    words = Gmsh_words(sections.pop('Nodes'), is_binary)
    blocks, n, low, high = words.take('Q', 4)
    assert (low, high) == (1, n)
    points, owners, order = {}, {}, []
    for _ in range(blocks):
        dimension, entity, parametric = words.take('i', 3)
        tags = words.take('Q', words.take_one('Q'))
        assert parametric == 0 and (dimension, entity) in group_of
        for tag in tags:
            points[tag] = words.take('d', 3)
            owners[tag] = (dimension, entity)
        order += tags
    words.check_end()
    assert sorted(points) == list(range(1, n + 1))

    words = Gmsh_words(sections.pop('Elements'), is_binary)
    blocks, m, low, high = words.take('Q', 4)
    assert (low, high) == (1, m)
    elements = {}
    for _ in range(blocks):
        dimension, entity, kind = words.take('i', 3)
        assert (dimension, kind) in ((2, 2), (3, 4))
        for _ in range(words.take_one('Q')):
            tag = words.take_one('Q')
            assert tag not in elements
            vertices = words.take('Q', dimension + 1)
            elements[tag] = (dimension, entity, tuple(v - 1 for v in vertices))
            box = boxes[dimension, entity]
            assert all(box[i] <= points[v][i] <= box[3 + i] for v in vertices for i in range(3))
    words.check_end()
    assert sorted(elements) == list(range(1, m + 1))
    triangles = [tag for tag, element in sorted(elements.items()) if element[0] == 2]
    tetrahedra = [tag for tag, element in sorted(elements.items()) if element[0] == 3]
    assert triangles + tetrahedra == list(range(1, m + 1))

    patches = [group_of[elements[t][:2]] for t in triangles]
    numbers = None
    if not is_binary:
        assert order == sorted(order)
        text = sections.pop('ElementData').decode().split('\n')
        assert text[:8] == ['1', '"region"', '1', '0', '3', '0', '1', str(m)]
        regions = {int(tag): int(region) for tag, region in map(str.split, text[8:])}
        assert all(names[3, group_of[elements[t][:2]]] == 'outside' if regions[t] == 0 else regions[t] == elements[t][1]
                   for t in tetrahedra)
        text = sections.pop('ElementData 2').decode().split('\n')
        assert text[:8] == ['1', '"triangle"', '1', '0', '3', '0', '1', str(m)]
        assert [int(line.split()[0]) for line in text[8:]] == list(elements)  # in their order, as meshio wants it
        values = sorted(tuple(map(int, line.split())) for line in text[8:])
        assert {number for _, number in values[len(triangles):]} <= {-1}
        numbers = [number for _, number in values[:len(triangles)]]
    assert not sections, sections.keys()
    return Gmsh_mesh(Mesh([points[v] for v in range(1, n + 1)], [elements[t][2] for t in tetrahedra],
                          [elements[t][1] for t in tetrahedra], [elements[t][2] for t in triangles], patches).with_numbers(numbers or []),
                     [names[3, group_of[elements[t][:2]]] for t in tetrahedra], [names[2, patch] for patch in patches],
                     [owners[v] for v in range(1, n + 1)])


def facets_of(tetrahedra):
    """how many tetrahedra have each facet"""
    count = collections.Counter()
    for t in tetrahedra:
        count.update(frozenset(t[:i] + t[i + 1:]) for i in range(4))
    return count


def check_tetrahedra(mesh):
    assert all(0 <= v < len(mesh.points) for t in mesh.tetrahedra for v in t)
    points = integers(mesh.points)
    assert all(signed_volume(points, [t]) > 0 for t in mesh.tetrahedra)
    assert max(facets_of(mesh.tetrahedra).values()) <= 2
    assert len(mesh.regions) == len(mesh.tetrahedra)


def check_domain(mesh, points, faces):
    """the mesh of a domain that is bounded by all the faces of a surface, which has no equal points"""
    check_tetrahedra(mesh)
    assert mesh.points[:len(points)] == [tuple(map(float, p)) for p in points]
    assert mesh.triangles == [tuple(f) for f in faces]
    assert mesh.numbers in (None, list(range(len(faces))))
    boundary = {f for f, n in facets_of(mesh.tetrahedra).items() if n == 1}
    assert boundary == {frozenset(f) for f in faces}
    assert signed_volume(mesh.points, mesh.tetrahedra) == signed_volume(points, faces)


# ---------------------------------------------------------------- running the program

def program_name():
    return os.path.basename(PROGRAM)


def run(*arguments, status=None):
    process = subprocess.run([PROGRAM, *arguments], capture_output=True, timeout=300, stdin=subprocess.DEVNULL)
    if status is not None:
        assert process.returncode == status, (arguments, process)
    process.out = process.stdout.decode(errors='replace')
    process.err = process.stderr.decode(errors='replace')
    return process


def write(name, content):
    with open(name, 'wb') as f:
        f.write(content.encode() if isinstance(content, str) else content)
    return name


def read(name):
    with open(name, 'rb') as f:
        return f.read()


def check_file_error(*arguments):
    """status 1, one line on stderr, nothing on stdout"""
    process = run(*arguments, status=FILE_ERROR)
    assert process.out == '' and re.fullmatch(re.escape(program_name()) + r': [^\n]+\n', process.err), process
    return process.err


def report_of(*arguments, status):
    run(*arguments, '--report', 'report.json', '--quiet', status=status)

    def refuse(constant):
        raise AssertionError(constant + ' is no JSON')
    return json.loads(read('report.json').decode('utf-8'), parse_constant=refuse)


def check_invalid(name, kind):
    """status 2, the kind of defect in the message and in the report; no mesh is written"""
    process = run(name, '-o', 'never.mesh', status=INVALID_INPUT)
    assert all(re.match(r'note: |[\w.]+: \d+ triangles?, \d+ points?', line) for line in process.out.splitlines()), process
    assert kind in process.err and not os.path.exists('never.mesh'), process
    report = report_of(name, status=INVALID_INPUT)
    assert report['status'] == 'invalid_input' and report['number_of_tetrahedra'] == 0
    defects = [d for d in report['defects'] if d['kind'] == kind]
    assert defects, (name, report)
    return defects


@contextlib.contextmanager
def temporary_folder():
    here = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            yield
        finally:
            os.chdir(here)


def run_tests(usage, tests):
    """runs the functions among the given names whose names begin with test_, or those that the command line names"""
    global PROGRAM
    if len(sys.argv) < 2:
        sys.exit(usage)
    PROGRAM = os.path.abspath(sys.argv[1])
    failures = 0
    for name, test in sorted(tests.items()):
        if not name.startswith('test_') or (len(sys.argv) > 2 and name not in sys.argv[2:]):
            continue
        with temporary_folder():
            try:
                test()
                print(name, 'passed', flush=True)
            except (AssertionError, subprocess.TimeoutExpired, ValueError, OSError, StopIteration, KeyError):
                traceback.print_exc()
                print(name, 'FAILED', flush=True)
                failures += 1
    sys.exit(1 if failures else 0)
