#!/usr/bin/env python3
"""Memory stays bounded over repeated calls, whatever their end is; arrays of the caller have no references left."""
import os
import signal
import sys
import threading

from common import MeshTest, box, br, main, np

POINTS, TRIANGLES, _ = box(n=(8, 8, 8))
FEW_POINTS, LARGE_TRIANGLES, _ = box(n=(2, 2, 2))
PAGE = os.sysconf("SC_PAGE_SIZE")


def resident():
    """The memory of this process in bytes, None where it is not told."""
    try:
        with open("/proc/self/statm") as file:
            return int(file.read().split()[1]) * PAGE
    except OSError:
        return None


def raising(p):
    if len(p) != len(POINTS) and p[0, 0] > 0.5:
        raise LookupError("in the middle of the work")
    return np.full(len(p), 0.1)


def interrupt():
    timer = threading.Timer(0.1, lambda: os.kill(os.getpid(), signal.SIGINT))
    timer.start()
    try:
        br.tetrahedralize(POINTS, TRIANGLES, size=0.015)
    except KeyboardInterrupt:
        pass
    finally:
        timer.join()


def invalid():
    try:
        br.tetrahedralize(np.concatenate([POINTS, FEW_POINTS + 0.3]),
                          np.concatenate([TRIANGLES, LARGE_TRIANGLES + len(POINTS)]))
    except br.InvalidSurface:
        pass


def raise_in_size():
    try:
        br.tetrahedralize(POINTS, TRIANGLES, size=raising)
    except LookupError:
        pass


def mesh():
    br.tetrahedralize(POINTS, TRIANGLES, size=0.1)


class LeaksTest(MeshTest):
    def check(self, call, repeats, bound):
        if resident() is None:
            self.skipTest("the system does not tell the memory of a process")
        for _ in range(3):
            call()
        before = resident()
        for _ in range(repeats):
            call()
        growth = resident() - before
        print("%d bytes more after %d calls" % (growth, repeats), file=sys.stderr)
        self.assertLess(growth, bound)

    def test_meshes(self):
        self.check(mesh, 20, 8 << 20)

    def test_the_triangulation_goes(self):
        if resident() is None or not sys.platform.startswith("linux"):
            self.skipTest("the system does not tell the memory of a process")
        before = resident()
        m = br.tetrahedralize(POINTS, TRIANGLES, size=0.03, improve=False)
        arrays = sum(a.nbytes for a in (m.points, m.tetrahedra, m.regions, m.triangles))
        print("arrays of %d bytes, %d bytes more" % (arrays, resident() - before), file=sys.stderr)
        self.assertLess(resident() - before, arrays + (24 << 20))

    def test_invalid_surfaces(self):
        self.check(invalid, 15, 8 << 20)

    def test_exceptions(self):
        self.check(raise_in_size, 30, 8 << 20)

    def test_control_c(self):
        self.check(interrupt, 10, 24 << 20)

    def test_references(self):
        points, triangles, sizes = POINTS.copy(), TRIANGLES.copy(), np.full(len(POINTS), 0.2)
        before = [sys.getrefcount(a) for a in (points, triangles, sizes, raising)]
        m = br.tetrahedralize(points, triangles, size=sizes)
        for _ in range(3):
            self.assertRaises(LookupError, br.tetrahedralize, points, triangles, size=raising)
        self.assertEqual([sys.getrefcount(a) for a in (points, triangles, sizes, raising)], before)
        inside = m.points
        del m
        self.assertTrue(np.isfinite(inside).all())


main()
