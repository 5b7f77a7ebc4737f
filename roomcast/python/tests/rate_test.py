# SPDX-License-Identifier: Apache-2.0
"""Python reads recordings nearly as fast as C++: both read the same files in turn, in one run, and their processor time
is compared. ROOMCAST_READ_FRAME_SETS is the program in C++."""
import os
import subprocess
import time
import unittest

import roomcast
from support import TestCase, run_program

MIN_SHARE = 0.8  # of the rate of C++
ROUNDS = 5


def read_in_python(path):
    sets, frames = 0, 0
    recording = roomcast.open(path)
    begin = time.process_time()
    for frame_set in recording:
        sets += 1
        for frame in frame_set:
            frames += frame.depth.ndim + frame.color.ndim == 5
    return sets, frames, time.process_time() - begin


def read_in_cpp(path):
    command = [os.environ["ROOMCAST_READ_FRAME_SETS"], str(path)]
    out = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    sets, frames, seconds = out.split()
    return int(sets), int(frames), float(seconds)


class Rate(TestCase):
    def assert_nearly_as_fast(self, path):
        times = []
        for _ in range(ROUNDS):
            cpp, python = read_in_cpp(path), read_in_python(path)
            self.assertEqual(python[:2], cpp[:2])
            self.assertGreater(cpp[1], 10)
            times.append((cpp[2], python[2]))
        cpp_s, python_s = (min(column) for column in zip(*times))  # what disturbs a run only adds time
        print(f"{path.name}: {cpp_s:.3f} s in C++, {python_s:.3f} s in Python: {cpp_s / python_s:.2f} of its rate")
        self.assertGreaterEqual(cpp_s / python_s, MIN_SHARE)

    def test_of_a_rig_and_of_a_recorded_room(self):
        folder = self.folder()
        rig, room = folder / "rig", folder / "room.mcap"
        run_program("simulate", rig, "--sensors", 1, "--seconds", 2, "--fps", 10, "--half-color", "--views", 0)
        self.assert_nearly_as_fast(rig)
        url = self.start_hub()
        self.start("sensor", "--source", f"rig:{rig}#s0", "--hub", url, "--verbose").prints("joined")
        run_program("record", room, "--hub", url, "--seconds", 4)
        self.assert_nearly_as_fast(room)


if __name__ == "__main__":
    unittest.main()
