#!/usr/bin/env python3
"""Runs the program mesh_surface_mpi with several ranks on this machine: the mesh, its pieces, and what may go wrong.

usage: test_mesh_surface_mpi_br3.py PROGRAM MPIEXEC MESH_SURFACE

Every mesh is read back by parsers of program_tests.py and checked with
exact rational arithmetic. Gmsh and VTK read the pieces, too, where they are installed.
"""
import glob
import hashlib
import itertools
import json
import math
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True  # the folder of the sources stays as it is
from program_tests import box, check_tetrahedra, grid_box, join, off_text, read_mesh, signed_volume

PROGRAM, MPIEXEC, MESH_SURFACE = sys.argv[1:]
SUBDOMAINS = 6
ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT='1', OMPI_ALLOW_RUN_AS_ROOT_CONFIRM='1')
MESHED, FILE_ERROR, INVALID_INPUT, FAILED = 0, 1, 2, 3


def boxes():
    """six boxes in a larger one, a sheet in the first of them, and a triangle that bounds nothing"""
    inner = [box((2 * i, 2 * j, 0), (2 * i + 1, 2 * j + 1, 1)) for i, j in itertools.product(range(3), range(2))]
    sheets = ([(0.2, 0.2, 0.2), (0.4, 0.2, 0.2), (0.2, 0.5, 0.2), (9, 9, 9), (10, 9, 9), (9, 10, 9)],
              [(0, 1, 2), (3, 4, 5)])
    return join(*inner, box((-1, -1, -1), (6, 4, 2)), sheets)


def row_of_boxes():
    """eight boxes that do not touch"""
    return join(*[box((2 * i, 0, 0), (2 * i + 1, 1, 1)) for i in range(8)])


def row_of_grids():
    """four cubes of fine triangles that do not touch"""
    points, faces = grid_box(6)
    return join(*[([(x + 2 * i, y, z) for x, y, z in points], faces) for i in range(4)])


def write(name, surface):
    with open(name, 'w') as file:
        file.write(off_text(*surface))
    return name


def command(ranks, *arguments, before=()):
    return [MPIEXEC, '-n', str(ranks), '--oversubscribe', *before, PROGRAM, *arguments]


def run(ranks, *arguments, status=MESHED):
    """waits for no second until what is left of a run that failed is killed"""
    environment = dict(ENVIRONMENT, OMPI_MCA_odls_base_sigkill_timeout='0')
    process = subprocess.run(command(ranks, *arguments), capture_output=True, text=True, timeout=300, env=environment,
                             stdin=subprocess.DEVNULL)
    assert process.returncode == status, process
    return process.stdout, process.stderr


def report_of(ranks, *arguments):
    run(ranks, *arguments, '--quiet', '--report', 'report.json')
    with open('report.json') as file:
        return json.load(file)


def bytes_of(*names):
    return [open(name, 'rb').read() for name in names]


def hashes(folder):
    """of all the files that a run wrote"""
    return {name: hashlib.sha256(open(os.path.join(folder, name), 'rb').read()).hexdigest()
            for name in sorted(os.listdir(folder))}


# ---------------------------------------------------------------- the mesh

def test_ranks_and_threads_do_not_change_the_mesh():
    surface = boxes()
    write('boxes.off', surface)
    results = []
    for ranks in 1, 2, 3, 4:
        for options in (), ('--work', 'work_%d' % ranks, '--threads', str(1 + ranks % 3)):
            folder = 'ranks_%d_%d' % (ranks, len(options))
            os.mkdir(folder)
            outputs = [a for e in ('mesh', 'pvtu', 'msh') for a in ('-o', os.path.join(folder, 'm.' + e))]
            report = report_of(ranks, 'boxes.off', '--size', '0.5', '--subdomains', str(SUBDOMAINS), '--pieces', *outputs, *options)
            assert report['number_of_ranks'] == ranks == len(report['peak_memory_of_ranks'])
            assert report['number_of_stored_tasks'] == 0 and len(report['rounds']) == 14
            results.append(hashes(folder))
            assert results[-1] == results[0] and len(results[0]) == 3 + SUBDOMAINS
    mesh = read_mesh('ranks_1_0/m.mesh')
    check_tetrahedra(mesh)
    check_surface(mesh, surface)
    assert sorted(set(mesh.regions)) == list(range(1, 8))
    assert signed_volume(mesh.points, mesh.tetrahedra) == 6 * 7 * 5 * 3
    assert report['number_of_tetrahedra'] == len(mesh.tetrahedra) == sum(report['histogram_of_dihedral_angles']) / 6
    assert not glob.glob(os.path.join(ENVIRONMENT['TMPDIR'], 'mesh_surface_mpi_*'))


def section(words, keyword, size):
    """a section of a MEDIT file, as rows of numbers"""
    begin = words.index(keyword) + 2
    n = int(words[begin - 1])
    return [tuple(map(float, words[begin + size * i:begin + size * (i + 1)])) for i in range(n)]


def test_second_order():
    write('boxes.off', boxes())
    common = ('boxes.off', '--size', '0.7', '--subdomains', str(SUBDOMAINS), '--pieces')
    run(2, *common, '-o', 'first.mesh')
    run(3, *common, '--order', '2', '-o', 'second.mesh', '-o', 'second.msh')
    first, words = read_mesh('first.mesh'), open('second.mesh').read().split()
    points = [row[:3] for row in section(words, 'Vertices', 4)]
    assert points[:len(first.points)] == first.points
    for keyword, corners, simplices, references in (('TetrahedraP2', 4, first.tetrahedra, first.regions),
                                                    ('TrianglesP2', 3, first.triangles, first.patches)):
        rows = section(words, keyword, corners * (corners + 1) // 2 + 1)
        assert [tuple(int(v) - 1 for v in row[:corners]) for row in rows] == simplices
        assert [int(row[-1]) for row in rows] == references
        for t, row in zip(simplices, rows):
            for (i, j), node in zip(((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)), row[corners:-1]):
                middle = tuple((x + y) / 2 for x, y in zip(first.points[t[i]], first.points[t[j]]))
                assert int(node) > len(first.points) and points[int(node) - 1] == middle
    if shutil.which('gmsh'):
        checked = subprocess.run(['gmsh', '-v', '2', '-check', 'second.msh'], capture_output=True, text=True, timeout=300,
                                 stdin=subprocess.DEVNULL)
        messages = (checked.stdout + checked.stderr).splitlines() # the triangle that bounds nothing is told
        assert checked.returncode == 0 and len(messages) == 1 and '6 nodes not connected to any 3D' in messages[0], checked
    _, message = run(1, *common, '--order', '2', '-o', 'never.pvtu', status=FILE_ERROR)
    assert 'not in pieces: never.pvtu' in message and not os.path.exists('never.pvtu')


def by_points(mesh):
    return sorted((sorted(mesh.points[v] for v in t), r) for t, r in zip(mesh.tetrahedra, mesh.regions))


def test_same_mesh_as_that_of_mesh_surface():
    write('boxes.off', boxes())
    arguments = 'boxes.off', '--quiet', '--size', '0.4', '--subdomains', '5'
    run(2, *arguments, '--threads', '2', '-o', 'mpi.mesh')
    subprocess.run([MESH_SURFACE, *arguments, '-o', 'one.mesh'], check=True, timeout=300, stdin=subprocess.DEVNULL)
    assert by_points(read_mesh('mpi.mesh')) == by_points(read_mesh('one.mesh'))


def test_names_and_places():
    write('boxes.off', boxes())
    arguments = 'boxes.off', '--quiet', '--size', '0.4', '--subdomains', '5'
    first = ('0.5', '0.5', '0.5')
    run(2, *arguments, '--region', 'steel', *first, '-o', 'm.msh', '-o', 'm.pvtu')
    assert '"steel"' in open('m.msh').read() and 'Name="steel"' in open('m_1.vtu', errors='replace').read()
    run(2, *arguments, '--void', *first, '-o', 'void.mesh')
    subprocess.run([MESH_SURFACE, *arguments, '--void', *first, '-o', 'one.mesh'], check=True, timeout=300,
                   stdin=subprocess.DEVNULL)
    assert by_points(read_mesh('void.mesh')) == by_points(read_mesh('one.mesh'))
    assert 'in no region' in run(2, *arguments, '--region', 'out', '-9', '0', '0', status=INVALID_INPUT)[1]


def check_surface(mesh, surface):
    """points and triangles are those of the surface; each facet has two sides, or is a triangle"""
    points, faces = surface
    assert mesh.points[:len(points)] == [tuple(map(float, p)) for p in points]
    assert mesh.triangles == [tuple(f) for f in faces]
    sides = {}
    for t, region in zip(mesh.tetrahedra, mesh.regions):
        for facet in itertools.combinations(sorted(t), 3):
            sides.setdefault(facet, []).append(region)
    triangles = set(tuple(sorted(t)) for t in mesh.triangles)
    for facet, regions in sides.items():
        assert len(regions) == 2 or facet in triangles
        assert len(set(regions)) == 1 or facet in triangles


def test_work_is_shared():
    write('row.off', row_of_boxes())
    report = report_of(2, 'row.off', '--size', '0.12')
    assert report['number_of_subdomains'] == 16
    assert set(task['rank'] for task in report['rounds'][0]['tasks']) == {0, 1}
    for threads, least, most in (1, 0, 1), (2, 1.2, 2.1):  # tasks at the same time, even if there is one core only
        first = report_of(1, 'row.off', '--size', '0.12', '--threads', str(threads), '--no-improvement')['rounds'][0]
        assert least * first['seconds_tasks'] < sum(task['seconds'] for task in first['tasks']) < most * first['seconds_tasks']


def test_one_subdomain_and_no_field_points():
    surface = boxes()
    write('boxes.off', surface)
    for arguments in ('--subdomains', '1', '--size', '1'), ('--no-field-points',), ('--no-improvement', '--size', '.8'):
        run(2, 'boxes.off', '--quiet', '-o', 'm.mesh', *arguments)
        mesh = read_mesh('m.mesh')
        check_tetrahedra(mesh)
        check_surface(mesh, surface)


def test_small_sources_and_number_of_vertices():
    """the forecast does not know how many vertices there will be; with as many as there are, and one less"""
    write('row.off', row_of_grids())
    with open('sources.txt', 'w') as file:
        file.writelines('point %r 0.3 0.4 0.003 0.01 5\n' % (2 * i + 0.3) for i in range(4))
    arguments = 'row.off', '--size', '0.2', '--sources', 'sources.txt', '--subdomains', '4', '--no-improvement'
    report = report_of(2, *arguments, '-o', 'free.mesh')
    assert report['is_field_resolved']
    points = read_mesh('free.mesh').points
    for i in range(4):
        assert min(math.dist(p, (2 * i + 0.3, 0.3, 0.4)) for p in points) < 0.01
    for ranks in 1, 3:
        work = '--work', 'work_%d' % ranks
        for _ in 'new', 'stored':
            report = report_of(ranks, *arguments, *work, '--max-vertices', str(len(points)), '-o', 'm.mesh')
            assert report['is_field_resolved'] and bytes_of('m.mesh') == bytes_of('free.mesh')
        os.remove('m.mesh')
        message = 'the mesh needs more than %d vertices' % (len(points) - 1)
        assert message in run(ranks, *arguments, '--max-vertices', str(len(points) - 1), '-o', 'm.mesh', status=FAILED)[1]
        assert not os.path.exists('m.mesh')
    run(2, *arguments[:-1], '--quiet', '--max-vertices', str(len(points)), '-o', 'm.mesh')
    check_tetrahedra(read_mesh('m.mesh'))
    assert len(read_mesh('m.mesh').points) <= len(points)


# ---------------------------------------------------------------- other readers

VTK_READER = """
import json, sys
from vtkmodules.vtkIOXML import vtkXMLPUnstructuredGridReader
if len(sys.argv) > 1:
    reader = vtkXMLPUnstructuredGridReader()
    reader.SetFileName(sys.argv[1])
    reader.Update()
    grid = reader.GetOutput()
    values = lambda array: [array.GetValue(i) for i in range(array.GetNumberOfValues())]
    ids, data = values(grid.GetPointData().GetGlobalIds()), grid.GetCellData()
    cells = [grid.GetCell(c) for c in range(grid.GetNumberOfCells())]
    json.dump([[[ids[i], grid.GetPoint(i)] for i in range(grid.GetNumberOfPoints())],
               [[grid.GetCell(c).GetPointId(k) for k in range(grid.GetCell(c).GetNumberOfPoints())]
                for c in range(grid.GetNumberOfCells())],
               ids] + [values(data.GetArray(name)) for name in ('region', 'patch', 'part')], sys.stdout)
"""


def test_pieces_with_vtk():
    python = next((p for p in ('/usr/bin/python3', sys.executable)
                   if subprocess.run([p, '-c', VTK_READER], capture_output=True).returncode == 0), None)
    if python is None:
        print('skipped: VTK is not installed')
        return
    write('boxes.off', boxes())
    run(2, 'boxes.off', '--size', '0.3', '--quiet', '--subdomains', str(SUBDOMAINS), '-o', 'm.pvtu', '-o', 'm.mesh')
    mesh = read_mesh('m.mesh')
    points, cells, ids, regions, patches, parts = json.loads(
        subprocess.run([python, '-c', VTK_READER, 'm.pvtu'], capture_output=True, check=True).stdout)
    number_of = {p: i for i, p in enumerate(mesh.points)}
    merged = {}  # the number in the merged mesh for each global one: those of the surface are the same
    for i, p in points:
        assert merged.setdefault(i, number_of[tuple(p)]) == number_of[tuple(p)]
        assert i >= len(boxes()[0]) or merged[i] == i
    assert len(set(merged.values())) == len(merged) == len(mesh.points)
    cells = [tuple(merged[ids[v]] for v in c) for c in cells]
    tetrahedra = [(c, r) for c, r in zip(cells, regions) if len(c) == 4]
    assert sorted(tetrahedra) == sorted(zip(mesh.tetrahedra, mesh.regions))
    triangles = [(c, p) for c, p in zip(cells, patches) if len(c) == 3]
    assert sorted(triangles) == sorted(zip(mesh.triangles, mesh.patches))
    assert set(parts) == set(range(1, SUBDOMAINS + 1))


def numbers(text, section):
    lines = text.split('$' + section + '\n')[1].split('\n$End')[0].split('\n')
    return [[float(x) for x in line.split()] for line in lines]


def elements_of(text):
    """the simplices of a .msh file, with the points that the file says and the entity of each"""
    points, simplices = {}, []
    lines = numbers(text, 'Nodes')
    i = 1
    while i < len(lines):
        n = int(lines[i][3])
        for k in range(n):
            points[int(lines[i + 1 + k][0])] = tuple(lines[i + 1 + n + k])
        i += 1 + 2 * n
    lines = numbers(text, 'Elements')
    i = 1
    while i < len(lines):
        dimension, tag, _, n = map(int, lines[i])
        simplices += [(dimension, tag, tuple(points[int(v)] for v in e[1:])) for e in lines[i + 1:i + 1 + n]]
        i += 1 + n
    return simplices


def parts_of(text):
    """of each partitioned entity, by dimension and tag: its parent, and its parts"""
    lines = numbers(text, 'PartitionedEntities')
    entities = {}
    surfaces, volumes = map(int, lines[2][2:])
    for i, line in enumerate(lines[3:]):
        n = int(line[3])
        entities[3 if i >= surfaces else 2, int(line[0])] = (int(line[1]), int(line[2])), tuple(map(int, line[4:4 + n]))
    assert len(entities) == surfaces + volumes
    return int(lines[0][0]), entities


def test_parts_with_gmsh():
    write('boxes.off', boxes())
    run(2, 'boxes.off', '--size', '0.3', '--quiet', '--subdomains', str(SUBDOMAINS), '--pieces', '-o', 'm.msh', '-o', 'm.mesh')
    mesh = read_mesh('m.mesh')
    text = open('m.msh').read()
    check_parts(mesh, text)
    if not shutil.which('gmsh'):
        print('skipped: gmsh is not installed')
        return
    process = subprocess.run(['gmsh', '-v', '4', '-check', 'm.msh'], capture_output=True, text=True, timeout=300,
                             stdin=subprocess.DEVNULL)
    said = process.stdout + process.stderr
    assert process.returncode == 0 and 'Error' not in said and '%d partitions' % SUBDOMAINS in said, process
    assert '%d elements' % (len(mesh.tetrahedra) + len(mesh.triangles)) in said, said
    gmsh = subprocess.run(['gmsh', '-v', '2', '-0', '-save_all', 'm.msh', '-o', 'again.msh'], capture_output=True,
                          timeout=300, stdin=subprocess.DEVNULL)
    assert gmsh.returncode == 0, gmsh
    check_parts(mesh, open('again.msh').read())


def test_no_sub_domain_is_empty():
    """when they are small, zones are as large as several of them"""
    write('boxes.off', boxes())
    for number in 7, 24:
        texts = []
        for ranks in 1, 3:
            run(ranks, 'boxes.off', '--size', '0.5', '--quiet', '--subdomains', str(number), '--pieces',
                '-o', 'm.msh', '-o', 'm.mesh')
            texts.append(open('m.msh').read())
        assert texts[0] == texts[1]
        check_parts(read_mesh('m.mesh'), texts[0], number)


def in_order(tetrahedra):
    """Gmsh writes 16 digits, and may begin with another vertex"""
    return sorted((sorted(tuple(float('%.16g' % x) + 0. for x in p) for p in points), part) for points, part in tetrahedra)


def check_parts(mesh, text, number=SUBDOMAINS):
    """the tetrahedra are those of the mesh, and triangles are of the parts on both sides"""
    count, entities = parts_of(text)
    assert count == number
    found, parts_of_facet, triangles = [], {}, []
    for dimension, tag, points in elements_of(text):
        parent, parts = entities[dimension, tag]
        assert parent[0] == dimension
        if dimension == 3:
            found.append((points, parent[1]))
            assert len(parts) == 1
            for facet in itertools.combinations(points, 3):
                parts_of_facet.setdefault(frozenset(facet), set()).update(parts)
        else:
            triangles.append((frozenset(points), parts))
    assert in_order(found) == in_order([(tuple(mesh.points[v] for v in t), r)
                                        for t, r in zip(mesh.tetrahedra, mesh.regions)])
    assert set.union(*parts_of_facet.values()) == set(range(1, number + 1))
    assert len(triangles) == len(mesh.triangles)
    for points, parts in triangles:
        assert set(parts) == parts_of_facet.get(points, {1})  # what bounds nothing is in the first one


# ---------------------------------------------------------------- what may go wrong

IGNORE_LIMIT = 'sh', '-c', 'trap "" XFSZ; exec "$@"', 'sh'  # of the length of files: then it is like a full disk


def start(ranks, *arguments, before=()):
    return subprocess.Popen(command(ranks, *arguments, before=before), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                            env=ENVIRONMENT, stdin=subprocess.DEVNULL)


def processes_below(parent):
    """the ranks, in their order, as mpirun starts them one after the other"""
    children = open('/proc/%d/task/%d/children' % (parent, parent)).read().split()
    return [int(c) for c in children if os.path.basename(PROGRAM) in open('/proc/%s/cmdline' % c).read()]


def parts_in(folder):
    return glob.glob(os.path.join(folder, '*.part'))


def results_in(folder):
    return glob.glob(os.path.join(folder, '*_result_*.part'))


def wait_for_results(process, folder, count):
    deadline = time.time() + 200
    while len(results_in(folder)) < count:
        assert process.poll() is None and time.time() < deadline, process.communicate()
        time.sleep(0.005)


def test_killed_rank():
    write('boxes.off', boxes())
    arguments = 'boxes.off', '--size', '0.3', '--quiet', '--subdomains', '8', '--work', 'work', '-o', 'm.mesh'
    process = start(2, *arguments, '--threads', '2')
    wait_for_results(process, 'work', 2)
    os.kill(processes_below(process.pid)[1], signal.SIGKILL)
    begin = time.time()
    _, said = process.communicate(timeout=60)
    assert time.time() - begin < 10
    assert process.returncode != 0 and not os.path.exists('m.mesh')
    task = r'(sub-domain \d+|the seam of the sub-domains \d+(, \d+)+)'
    assert re.search(r'rank 1 was ended from outside while it meshed %s( and %s)?\n' % (task, task), said), said
    plans = sorted(glob.glob(os.path.join('work', '*_plan_*.part')))
    finished = len(results_in('work'))
    assert len(plans) == 1 and finished >= 2
    report = report_of(2, *arguments)
    assert report['number_of_stored_tasks'] == finished  # the others, and only these, were done again
    first = bytes_of('m.mesh')
    again = report_of(1, *arguments)
    assert again['number_of_stored_tasks'] == again['number_of_tasks'] > 0 and bytes_of('m.mesh') == first
    run(1, *[a for a in arguments if a not in ('--work', 'work')])
    assert bytes_of('m.mesh') == first
    # other sizes, or a damaged file, are not taken for what is there
    damaged = sorted(results_in('work'))[0]
    with open(damaged, 'r+b') as file:
        file.truncate(os.path.getsize(damaged) - 1)
    again = report_of(2, *arguments)
    assert again['number_of_stored_tasks'] == again['number_of_tasks'] - 1 and bytes_of('m.mesh') == first
    assert report_of(1, 'boxes.off', '--size', '0.6', '--work', 'work')['number_of_stored_tasks'] == 0


def test_temporary_folder_after_a_failure():
    write('boxes.off', boxes())
    process = start(2, 'boxes.off', '--size', '0.25', '--quiet', '--subdomains', '8', '-o', 'm.mesh')
    folders = os.path.join(ENVIRONMENT['TMPDIR'], 'mesh_surface_mpi_*')
    wait_for_results(process, folders, 2)
    assert len(glob.glob(folders)) == 1
    os.kill(processes_below(process.pid)[1], signal.SIGKILL)
    process.communicate(timeout=60)
    assert process.returncode != 0 and not glob.glob(folders)


def test_rank_without_memory():
    write('boxes.off', boxes())
    process = start(2, 'boxes.off', '--size', '0.25', '--quiet', '--subdomains', '8', '--work', 'work', '-o', 'm.mesh')
    wait_for_results(process, 'work', 2)
    victim = processes_below(process.pid)[1]
    used = int(open('/proc/%d/statm' % victim).read().split()[0]) * resource.getpagesize()
    resource.prlimit(victim, resource.RLIMIT_AS, (used, used))
    _, said = process.communicate(timeout=120)
    assert process.returncode != 0
    assert re.search(r'mesh_surface_mpi(, rank 1: |: .* failed on rank 1: )', said), said
    assert not os.path.exists('m.mesh')


def test_different_inputs():
    for name, shift in ('a.off', 0), ('b.off', 0.5):
        write(name, box((shift, 0, 0), (1 + shift, 1, 1)))
    arguments = '--quiet', '-o', 'm.mesh', '--work', 'work'
    process = subprocess.run([MPIEXEC, '--oversubscribe', '-n', '1', PROGRAM, 'a.off', *arguments,
                              ':', '-n', '1', PROGRAM, 'b.off', *arguments],
                             capture_output=True, text=True, timeout=100, env=ENVIRONMENT, stdin=subprocess.DEVNULL)
    message = 'rank 1 has another surface, or other sizes or options, than rank 0'
    assert process.returncode == FILE_ERROR and process.stderr.count(message) == 2, process
    assert not os.path.exists('m.mesh') and not os.path.exists('work')


def test_full_disk():
    """of the work, by a limit of the length of files; of the output, by a device that is always full"""
    write('row.off', row_of_boxes())
    process = start(1, 'row.off', '--size', '0.12', '--quiet', '--subdomains', '8', '--work', 'work', before=IGNORE_LIMIT)
    wait_for_results(process, 'work', 1)
    resource.prlimit(processes_below(process.pid)[0], resource.RLIMIT_FSIZE, (4096, 4096))
    _, said = process.communicate(timeout=60)
    assert process.returncode != 0
    assert re.search(r'mesh_surface_mpi: (.* failed on rank 0: )?cannot write .*\.unfinished: File too large', said), said
    assert len(os.listdir('work')) == len(parts_in('work')) > 0
    os.symlink('/dev/full', 'full.mesh')
    assert 'cannot write full.mesh' in run(2, 'row.off', '--size', '0.3', '-o', 'full.mesh', status=FILE_ERROR)[1]
    os.symlink('/dev/full', 'piece_3.vtu')
    assert 'cannot write piece.pvtu' in run(2, 'row.off', '--size', '0.3', '-o', 'piece.pvtu', status=FILE_ERROR)[1]
    assert not os.path.exists('piece.pvtu')


def test_bad_arguments():
    write('box.off', box((0, 0, 0), (1, 1, 1)))
    assert 'a positive number' in run(2, 'box.off', '--threads', '0', status=FILE_ERROR)[1]
    assert '--subdomains needs at least 1' in run(1, 'box.off', '--subdomains', '0', status=FILE_ERROR)[1]
    assert re.search('not expected: .*--time-limit', run(2, 'box.off', '--time-limit', '3', status=FILE_ERROR)[1])
    assert 'unknown output format' in run(2, 'box.off', '-o', 'm.txt', status=FILE_ERROR)[1]
    assert 'no_such_file.off' in run(2, 'no_such_file.off', status=FILE_ERROR)[1]
    assert 'cannot make the folder box.off' in run(2, 'box.off', '--work', 'box.off', status=FILE_ERROR)[1]
    write('open.off', (box((0, 0, 0), (1, 1, 1))[0], box((0, 0, 0), (1, 1, 1))[1][1:]))
    assert 'bounds no region' in run(2, 'open.off', status=FAILED)[1]
    write('crossing.off', join(box((0, 0, 0), (1, 1, 1)), box((0.5, 0.5, 0.5), (2, 2, 2))))
    assert 'invalid input' in run(2, 'crossing.off', status=INVALID_INPUT)[1]


def main():
    for name, test in sorted(globals().items()):
        if name.startswith('test_'):
            with tempfile.TemporaryDirectory() as folder:
                os.chdir(folder)
                ENVIRONMENT['TMPDIR'] = os.path.join(folder, 'tmp') # other runs have folders of their own in the usual one
                os.mkdir(ENVIRONMENT['TMPDIR'])
                begin = time.time()
                test()
                os.chdir('/')
                print('%s: %.1f s' % (name, time.time() - begin), flush=True)


if __name__ == '__main__':
    main()
