#!/usr/bin/env python3
"""Progress, stops, Ctrl-C, and threads that run meanwhile."""
import os
import signal
import threading
import time

from common import MeshTest, box, br, main, np, volumes

POINTS, TRIANGLES, _ = box(n=(8, 8, 8))
FINE = 0.012  # takes much longer than any test may
PHASES = {"insertion", "search", "domain_marking", "forecast", "field_point_insertion", "quality_improvement"}


class InterruptionsTest(MeshTest):
    def test_progress(self):
        calls = []
        m = br.tetrahedralize(POINTS, TRIANGLES, size=0.06, progress=lambda phase, share: calls.append((phase, share)))
        self.assertTrue(m)
        self.assertLessEqual(PHASES, {phase for phase, _ in calls})
        self.assertTrue(all(0 <= share <= 1 for _, share in calls))
        quiet = br.tetrahedralize(POINTS, TRIANGLES, size=0.06)
        self.assertEqual(m.tetrahedra.tobytes(), quiet.tetrahedra.tobytes())

    def test_progress_stops(self):
        m = br.tetrahedralize(POINTS, TRIANGLES, size=FINE, progress=lambda phase, share: not (
            phase == "field_point_insertion" and share > 0))
        self.assertEqual((m.status, bool(m)), ("stopped", False))
        self.assertAlmostEqual(volumes(m.points, m.tetrahedra).sum(), 1.0)
        for false in (False, np.bool_(False)):
            m = br.tetrahedralize(POINTS, TRIANGLES, size=FINE, progress=lambda phase, share: false)
            self.assertEqual(m.status, "stopped")
        m = br.tetrahedralize(POINTS, TRIANGLES, size=0.1, progress=lambda phase, share: 0)
        self.assertEqual(m.status, "meshed")

    def test_control_c(self):
        for call in (lambda: br.tetrahedralize(POINTS, TRIANGLES, size=FINE),
                     lambda: br.tetrahedralize(POINTS, TRIANGLES, size=lambda p: np.full(len(p), FINE))):
            timer = threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT))
            start = time.monotonic()
            timer.start()
            with self.assertRaises(KeyboardInterrupt):
                call()
            self.assertLess(time.monotonic() - start, 5)
            timer.join()

    def test_other_threads_run(self):
        count = [0]
        done = threading.Event()

        def counter():
            while not done.wait(0.002):
                count[0] += 1

        thread = threading.Thread(target=counter)
        thread.start()
        try:
            m = br.tetrahedralize(POINTS, TRIANGLES, size=FINE, time_limit=0.5)
        finally:
            done.set()
            thread.join()
        self.assertEqual(m.status, "stopped")
        self.assertGreater(count[0], 50)

    def test_two_meshes_at_a_time(self):
        expected = br.tetrahedralize(POINTS, TRIANGLES, size=0.08)
        results = []
        threads = [threading.Thread(target=lambda: results.append(br.tetrahedralize(
            POINTS, TRIANGLES, size=lambda p: np.full(len(p), 0.08), progress=lambda phase, share: None)))
            for _ in range(2)]
        threads += [threading.Thread(target=lambda: results.append(br.tetrahedralize(POINTS, TRIANGLES, size=0.08)))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(results), 3)
        self.assertEqual(sum(m.tetrahedra.tobytes() == expected.tetrahedra.tobytes() for m in results) % 2, 1)
        self.assertTrue(all(results))


main()
