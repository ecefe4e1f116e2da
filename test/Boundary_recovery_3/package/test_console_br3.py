#!/usr/bin/env python3
"""Runs the program mesh_surface in a pseudo terminal, and checks what a person sees, line by line, and what is left when the
work is interrupted.

usage: test_console_br3.py PROGRAM
"""
import fcntl
import glob
import os
import pty
import re
import select
import signal
import struct
import subprocess
import sys
import termios
import time
import xml.etree.ElementTree

sys.dont_write_bytecode = True  # the folder of the sources stays as it is
import program_tests
from program_tests import *

HERE = os.path.dirname(os.path.abspath(__file__))
MESHED = RECOVERED
SHOWN = ['--size', '0.03']  # long enough for bars of several steps
LONG = ['--size', '0.008']  # much longer than it takes to interrupt it


class Terminal:
    """The screen of a program that runs in a pseudo terminal, as lines of characters."""
    def __init__(self, *arguments, columns=80):
        self.columns, self.lines, self.column, self.bars, self.text = columns, [''], 0, [], ''
        self.master, slave = pty.openpty()
        fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack('HHHH', 24, columns, 0, 0))
        self.process = subprocess.Popen([program_tests.PROGRAM, *arguments], stdin=slave, stdout=slave, stderr=slave,
                                        preexec_fn=lambda: fcntl.ioctl(0, termios.TIOCSCTTY, 0), start_new_session=True)
        os.close(slave)

    def read(self, seconds):
        """more of what is printed; returns whether there may be some"""
        if not select.select([self.master], [], [], seconds)[0]:
            return True
        try:
            data = os.read(self.master, 65536)
        except OSError:  # what Linux tells when the other end is closed
            return False
        for c in data.decode():
            self.put(c)
        return bool(data)

    def put(self, c):
        self.text += c
        if c == '\r':
            self.keep_bar()
            self.column = 0
        elif c == '\n':
            self.lines.append('')
        else:
            assert c >= ' ', repr(c)  # no codes for colours or the cursor
            if self.column == self.columns:  # the line is wrapped
                self.lines.append('')
                self.column = 0
            line = self.lines[-1].ljust(self.column)
            self.lines[-1] = line[:self.column] + c + line[self.column + 1:]
            self.column += 1

    def keep_bar(self):
        bar = re.fullmatch(r'(\w+) *(?:\[(#*)(\.*)\] )?(\d+) %', self.lines[-1].rstrip())
        if bar:
            self.bars.append((bar.group(1), int(bar.group(4)), len(bar.group(2) or ''), len(bar.group(3) or '')))

    def wait_for(self, text):
        end = time.monotonic() + 60
        while text not in self.text and time.monotonic() < end and self.read(1):
            pass
        assert text in self.text, (text, self.text)

    def type(self, keys):
        os.write(self.master, keys)

    def finish(self):
        """waits for the end; returns the exit status, negative for a signal"""
        end = time.monotonic() + 60
        while self.read(1) and time.monotonic() < end:
            pass
        os.close(self.master)
        return self.process.wait(60)

    def shown(self):
        """what is left on the screen"""
        assert self.column == 0 and self.lines[-1].strip() == '', self.lines
        return [line.rstrip() for line in self.lines[:-1]]


def cube(n=6):
    return write('cube.off', off_text(*grid_box(n)))


def check_bars(bars, length):
    assert len(bars) > 3, bars
    shares = [share for _, share, _, _ in bars]
    assert shares == sorted(shares) and 0 <= shares[0] < shares[-1] <= 100, bars
    for _, share, filled, empty in bars:
        assert filled + empty == length and abs(filled - length * share / 100) <= 1, (share, filled, empty)
    steps = [step for step, _, _, _ in bars]
    order = ['reading', 'insertion', 'recovery', 'regions', 'forecast', 'filling', 'improvement', 'measuring', 'writing']
    assert [order.index(s) for s in steps] == sorted(order.index(s) for s in steps), steps
    assert 'improvement' in steps and len(set(steps)) > 1, steps


def test_good_surface():
    terminal = Terminal(cube(), *SHOWN, '-o', 'cube.vtu')
    assert terminal.finish() == MESHED
    lines = terminal.shown()
    assert terminal.text.count('\n') <= 10, lines
    for line, words in zip(lines, (r'cube\.off: 432 triangles, 218 points', r'about [\d.]+ \w+ tetrahedra are to be expected',
                                   r'mesh: \d+ tetrahedra in 1 region, \d+ points')):
        assert re.match(words, line), lines
    assert 'written: cube.vtu' in lines, lines
    check_bars(terminal.bars, 40)
    assert not glob.glob('*part*')
    check_tetrahedra(read_vtu('cube.vtu'))


def test_pipe_has_no_bar():
    process = run(cube(), '--size', '0.06', status=MESHED)
    assert '\r' not in process.out and '#' not in process.out and process.err == '', process
    terminal = Terminal('cube.off', '--size', '0.06', '--quiet')
    assert terminal.finish() == MESHED and terminal.text == ''


def test_narrow_terminal():
    for columns, length in ((40, 40 - 23), (20, 0)):
        terminal = Terminal(cube(), *SHOWN, columns=columns)
        assert terminal.finish() == MESHED
        check_bars(terminal.bars, length)
        assert not any('#' in line or re.search(r'\w+ +\d+ %$', line) for line in terminal.shown()), terminal.lines


def test_bad_surface():
    write('bad.off', off_text(*join(box((0, 0, 0), (2, 2, 2)), box((1, 1, 1), (3, 3, 3)))))
    terminal = Terminal('bad.off', '-o', 'bad.vtu')
    assert terminal.finish() == INVALID_INPUT
    lines = terminal.shown()
    assert terminal.text.count('\n') <= 10 and any(line.startswith('mesh_surface: ') for line in lines), lines
    assert not os.path.exists('bad.vtu') and not glob.glob('*part*')


def check_interrupted(terminal, expected):
    assert terminal.finish() == -expected, terminal.lines
    lines = terminal.shown()
    assert len(lines) <= 2 and not any('#' in line or '%' in line for line in lines), lines
    assert sorted(os.listdir('.')) == ['cube.msh', 'cube.off'], os.listdir('.')
    assert read('cube.msh') == b'old'  # nothing is lost


def test_interruption():
    write('cube.msh', 'old')
    for send, expected in ((lambda t: t.type(b'\x03'), signal.SIGINT),
                           (lambda t: t.process.terminate(), signal.SIGTERM)):
        terminal = Terminal(cube(), *LONG, '-o', 'cube.msh', '-o', 'cube.vtu', '--report', 'cube.json')
        terminal.wait_for('filling')
        send(terminal)
        check_interrupted(terminal, expected)


def test_interruption_while_files_are_written():
    """A mesh of 100,000 cells takes a tenth of a second for each of many outputs."""
    write('cube.msh', 'old')
    outputs = ['out%d.vtk' % k for k in range(12)]
    terminal = Terminal(cube(), '--size', '0.04', *[word for o in outputs for word in ('-o', o)], '-o', 'cube.msh')
    terminal.wait_for('writing')
    while not glob.glob('*.part1.*') and terminal.process.poll() is None:
        pass
    terminal.type(b'\x03')
    assert terminal.finish() == -signal.SIGINT
    assert not glob.glob('*.part*') and read('cube.msh') == b'old', os.listdir('.')
    for name in glob.glob('out*.vtk'):  # what is there is there as a whole
        assert read(name).endswith(b'\n') and read(name) == read('out0.vtk'), name
    terminal.shown()


def test_interruption_while_gmsh_writes():
    """It works in a folder for temporary files."""
    surface, environment = cube(), dict(os.environ, TMPDIR=os.path.abspath('temporary'))
    os.mkdir('temporary')
    process = subprocess.Popen([program_tests.PROGRAM, surface, '--size', '0.035', '-o', 'cube.inp', '--quiet'], env=environment,
                               stderr=subprocess.DEVNULL)
    while not glob.glob('temporary/*/mesh.msh') and process.poll() is None:
        time.sleep(0.005)
    process.terminate()
    if process.wait() == FILE_ERROR:
        print('skipped: the program was built without libgmsh, or it cannot be loaded')
        return
    assert process.returncode == -signal.SIGTERM
    assert sorted(os.listdir('.')) == ['cube.off', 'temporary'] and os.listdir('temporary') == [], os.listdir('.')


def test_ignored_interruption():
    """as of a job in the background"""
    process = subprocess.Popen([program_tests.PROGRAM, cube(), '--size', '0.06', '-o', 'cube.vtu'], stdout=subprocess.PIPE,
                               preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_IGN))
    process.stdout.readline()
    process.send_signal(signal.SIGINT)
    process.communicate()
    assert process.returncode == MESHED and os.path.exists('cube.vtu')


def test_outputs_that_cannot_be_written():
    """told before the work begins"""
    os.symlink('/dev/full', 'full.vtu')
    os.symlink('/dev/full', 'full.json')
    for arguments, words in ((('-o', 'nowhere/cube.vtu'), 'nowhere/cube.vtu: No such file or directory'),
                             (('-o', 'full.vtu'), 'full.vtu: No space left on device'),
                             (('--report', 'full.json'), 'full.json: No space left on device'),
                             (('-o', 'cube.off/cube.vtu'), 'cube.off/cube.vtu: Not a directory')):
        begin = time.monotonic()
        process = run(cube(), *LONG, *arguments, status=FILE_ERROR)
        assert process.out == '' and process.err == 'mesh_surface: cannot write %s\n' % words, process
        assert time.monotonic() - begin < 10
    assert sorted(os.listdir('.')) == ['cube.off', 'full.json', 'full.vtu'], os.listdir('.')


def test_links_and_permissions_stay():
    os.mkdir('there')
    write('there/cube.vtu', 'old')
    os.chmod('there/cube.vtu', 0o640)
    os.symlink('there/cube.vtu', 'cube.vtu')
    run(cube(), '-o', 'cube.vtu', status=MESHED)
    assert os.path.islink('cube.vtu') and os.stat('there/cube.vtu').st_mode & 0o777 == 0o640
    check_tetrahedra(read_vtu('there/cube.vtu'))
    assert os.listdir('there') == ['cube.vtu']


def test_files_with_several_names_stay_that():
    """and a link to nothing stays a link, also if nothing is written"""
    write('cube.vtu', 'old')
    os.link('cube.vtu', 'same.vtu')
    os.symlink('new.vtu', 'link.vtu')
    run(cube(), *LONG, '-o', 'link.vtu', '-o', 'nowhere/cube.vtu', status=FILE_ERROR)
    assert os.path.islink('link.vtu') and not os.path.exists('new.vtu')
    run('cube.off', '-o', 'cube.vtu', '-o', 'link.vtu', status=MESHED)
    assert os.path.samefile('cube.vtu', 'same.vtu') and os.path.islink('link.vtu')
    assert read('cube.vtu') == read('new.vtu')
    check_tetrahedra(read_vtu('new.vtu'))


def test_numbers_that_no_point_has():
    terminal = Terminal(write('bad.off', 'OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 999999999\n'))
    assert terminal.finish() == INVALID_INPUT
    assert any('index_out_of_range' in line for line in terminal.shown()), terminal.lines


def test_picture():
    """The cut through a cube bares as much as it takes away, and the chart counts each tetrahedron."""
    script = os.path.join(HERE, '..', '..', '..', 'program', 'draw_mesh.py')
    run(cube(3), '--size', '0.2', '-o', 'cube.vtu', '-o', 'cube.msh', '-o', 'cube.mesh', status=MESHED)
    mesh = read_mesh('cube.mesh')
    width, pictures = 300, []
    for name in ('cube.vtu', 'cube.msh', 'cube.mesh'):
        # seen from above, where the upper half is cut off: what is seen is a square, all of it inside of the mesh
        subprocess.run([sys.executable, script, name, 'cube.svg', str(width), '--cut', '0,0,1,0.5', '--view', '-90,90',
                        '--chart'], check=True, timeout=60)
        pictures.append(read('cube.svg').decode())
    assert pictures[0] == pictures[1] == pictures[2]
    root = xml.etree.ElementTree.fromstring(pictures[0])
    tag = '{http://www.w3.org/2000/svg}'
    counts = [int(t.text) for t in root.iter(tag + 'title')]
    assert sum(counts) == len(mesh.tetrahedra) and sum(n > 0 for n in counts) > 1
    bars = [float(r.get('height')) for r in root.iter(tag + 'rect') if r.find(tag + 'title') is not None]
    assert all(abs(h / max(bars) - n / max(counts)) < 0.01 for h, n in zip(bars, counts))
    area = 0
    for path in root.iter(tag + 'path'):
        numbers = list(map(int, re.findall(r'-?\d+', path.get('d'))))
        (x1, y1), (x2, y2) = numbers[2:4], numbers[4:6]
        area += abs(x1 * y2 - x2 * y1) / 2
    side = 2 * (width - 16)  # of the cube, in the units of the picture
    assert abs(area / side ** 2 - 1) < 0.02, area / side ** 2
    for name, content in (('bad.vtu', 'no mesh'), ('bad.txt', ''), ('bad.msh', '$MeshFormat\n2.2 0 8\n')):
        process = subprocess.run([sys.executable, script, write(name, content), 'bad.svg'], capture_output=True, timeout=60)
        assert process.returncode == 1 and process.stderr.startswith(b'draw_mesh.py: ' + name.encode()), process
        assert not os.path.exists('bad.svg')


if __name__ == '__main__':
    run_tests(__doc__, globals())
