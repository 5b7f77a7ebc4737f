# SPDX-License-Identifier: Apache-2.0
"""Arrays outlive what they came from; threads and the interpreter's end do no harm."""
import gc
import sys
import threading
import time
import weakref

import numpy as np

import roomcast
from support import TestCase, depth_mm, run_python, write_rig


class Lifetimes(TestCase):
    def test_arrays_outlive_frames_iterator_and_recording(self):
        with roomcast.open(write_rig(self.folder())) as recording:
            arrays = [
                (n, frames.number, frame.depth, frame.points().xyz)
                for frames in recording
                for n, frame in enumerate(frames)
            ]
        del recording
        gc.collect()
        for n, i, depth, xyz in arrays:
            np.testing.assert_array_equal(depth, depth_mm(n, i))
            self.assertTrue(np.isfinite(xyz).all())

    def test_parts_of_arrays_keep_the_whole_alive(self):
        row = next(iter(roomcast.open(write_rig(self.folder()))))[0].depth[10, ::2]
        gc.collect()
        np.testing.assert_array_equal(row, depth_mm(0, 0)[10, ::2])

    def test_pictures_are_freed_with_their_last_array(self):
        """Holding one array of each set must not hold more than its frame."""
        recording = roomcast.open(write_rig(self.folder()))
        sets = iter(recording)
        frames = next(sets)
        ends = weakref.ref(frames)
        depth = frames[0].depth
        del frames
        gc.collect()
        self.assertIsNone(ends())
        np.testing.assert_array_equal(depth, depth_mm(0, 0))

    def test_references_do_not_leak(self):
        rig = write_rig(self.folder())
        frame = next(iter(roomcast.open(rig)))[0]
        before = sys.getrefcount(None), sys.getrefcount(frame)
        for _ in range(1000):
            frame.depth, frame.color, frame.room_from_sensor, frame.intrinsics
        self.assertLess(abs(sys.getrefcount(None) - before[0]), 100)
        self.assertEqual(sys.getrefcount(frame), before[1])

    def test_threads_share_an_iterator(self):
        sets, numbers = iter(roomcast.open(write_rig(self.folder(), instants=40))), []
        threads = [threading.Thread(target=lambda: numbers.extend(frames.number for frames in sets)) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(sorted(numbers), list(range(40)))

    def test_threads_make_clouds_of_one_set(self):
        frames = next(iter(roomcast.open(write_rig(self.folder()))))
        truth, clouds = frames.points().xyz, []
        options = [{}, {"keep_doubles": True}, {"voxel_m": 0.1}, {}]
        threads = [threading.Thread(target=lambda o=o: clouds.append((o, frames.points(**o).xyz))) for o in 4 * options]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(clouds), 16)
        for chosen, xyz in clouds:
            if not chosen:
                np.testing.assert_array_equal(xyz, truth)

    def test_others_run_while_a_recording_is_read(self):
        """Reading leaves the interpreter to other threads."""
        recording = roomcast.open(write_rig(self.folder(), instants=12, enlarged=16))  # some 10 ms each
        counted, done = 0, threading.Event()
        thread = threading.Thread(target=lambda: (list(recording), done.set()))
        interval = sys.getswitchinterval()
        sys.setswitchinterval(60)  # only a thread that gives way lets others run
        self.addCleanup(sys.setswitchinterval, interval)
        thread.start()
        while not done.is_set():
            counted += 1
            time.sleep(0)
        thread.join()
        self.assertGreater(counted, 3)


READS_FOR_EVER = """
import sys, threading, time
import roomcast
started = threading.Event()
def read():
    while True:
        for frames in roomcast.open(sys.argv[1]):
            kept = [frame.points().xyz for frame in frames]
            started.set()
for _ in range(3):
    threading.Thread(target=read, daemon=True).start()
started.wait()
time.sleep(float(sys.argv[2]))
"""


class InterpretersEnd(TestCase):
    def assert_ends_well(self, code, *args):
        ended = run_python(code, *args)
        self.assertEqual((ended.returncode, ended.stderr), (0, ""))

    def test_with_all_kinds_of_objects_alive(self):
        self.assert_ends_well(
            "import sys, roomcast\n"
            "recording = roomcast.open(sys.argv[1])\n"
            "sets = iter(recording); frames = next(sets); frame = frames[0]\n"
            "depth = frame.depth; cloud = frames.points()\n"
            "cycle = [recording, sets, frames, depth, cloud.xyz]; cycle.append(cycle)\n",
            write_rig(self.folder()),
        )

    def test_while_daemon_threads_read(self):
        rig = write_rig(self.folder())
        for seconds in (0, 0.01, 0.02, 0.05, 0.1):
            self.assert_ends_well(READS_FOR_EVER, rig, seconds)

    def test_with_an_exception_on_the_way(self):
        code = "import sys, roomcast\nfor frames in roomcast.open(sys.argv[1]): raise ValueError('mine')"
        ended = run_python(code, write_rig(self.folder()))
        self.assertEqual(ended.returncode, 1)
        self.assertIn("ValueError: mine", ended.stderr)


if __name__ == "__main__":
    import unittest

    unittest.main()
