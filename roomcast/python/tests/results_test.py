# SPDX-License-Identifier: Apache-2.0
"""Alignment and measuring: the same as the command line gives, on simulated rooms."""
import json
import signal
import time

import numpy as np

import roomcast
from support import TestCase, run_program, start_python, write_rig


def json_of(*args):
    return json.loads(run_program(*args, "--json").stdout)


class Alignments(TestCase):
    def test_is_the_same_as_of_the_command_line(self):
        rig = self.folder() / "rig"
        run_program("simulate", rig, "--sensors", 2, "--seconds", 1, "--fps", 4, "--half-color", "--views", 0)
        alignment, report = roomcast.align(rig), json_of("align", rig)
        self.assertEqual([sensor.name for sensor in alignment.sensors], ["s0", "s1"])
        for sensor, told in zip(alignment.sensors, report["sensors"]):
            self.assertTrue(sensor.placed)
            np.testing.assert_array_equal(sensor.room_from_sensor.ravel(), told["world_from_depth"])
            for field in ("expected_error_mm", "expected_error_deg", "depth_scale", "depth_scale_standard_error",
                          "overlap", "inliers", "residual_mm", "reason"):
                self.assertEqual(getattr(sensor, field), told[field], field)
        for pair, told in zip(alignment.pairs, report["pairs"]):
            for field in ("a", "b", "accepted", "overlap", "inliers", "residual_mm", "expected_error_mm", "reason"):
                self.assertEqual(getattr(pair, field), told[field], field)
            np.testing.assert_array_equal(pair.b_from_a.ravel(), told["b_from_a"])
        self.assertGreater(alignment["s1"].expected_error_mm, 0)
        with self.assertRaises(KeyError):
            alignment["s7"]

    def test_refuses_what_cannot_be_aligned_and_says_why(self):
        alignment = roomcast.align(write_rig(self.folder()))
        self.assertIsNone(alignment["s1"].room_from_sensor)
        self.assertFalse(alignment["s1"].placed)
        self.assertRegex(alignment["s1"].reason, r"\w+ \w+")

    def test_needs_a_rig(self):
        with self.assertRaisesRegex(roomcast.Error, "rig.json"):
            roomcast.align(self.folder())

    def test_is_interrupted_by_ctrl_c(self):
        rig = write_rig(self.folder(), sensors=6, instants=20)
        program = start_python(
            "import sys, roomcast\n"
            "print('works', flush=True)\n"
            "try:\n"
            "    while True: roomcast.align(sys.argv[1])\n"
            "except KeyboardInterrupt: print('interrupted')",
            rig,
        )
        program.stdout.readline()
        time.sleep(0.2)
        program.send_signal(signal.SIGINT)
        self.assertEqual(program.communicate(timeout=60), ("interrupted\n", ""))


class Distances(TestCase):
    def test_are_the_same_as_of_the_command_line(self):
        rig = write_rig(self.folder())
        told = json_of("measure", rig, "--from", "s0:20,20", "--to", "s1:40,30")
        for a, b in ((("s0", 20, 20), ("s1", 40, 30)), ("s0:20,20", "s1:40,30")):
            distance = roomcast.measure(rig, a, b)
            self.assertEqual(distance.distance_m, told["distance_m"])
            self.assertEqual(distance.expected_error_m, told["expected_error_m"])
            self.assertEqual(distance.by_scale_m, told["by_scale_m"])
            self.assertEqual((list(distance.a.xyz), distance.b.sensor), (told["from"]["world_m"], told["to"]["sensor"]))

    def test_have_the_error_of_the_rooms_scale(self):
        rig = write_rig(self.folder())
        description = json.loads((rig / "rig.json").read_text())
        self.assertIsNone(roomcast.open(rig).sensors[0].scale_error)
        self.assertEqual(roomcast.measure(rig, ("s0", 20, 20), ("s0", 40, 30)).by_scale_m, 0)
        (rig / "rig.json").write_text(json.dumps({**description, "scale_error": 0.02}))
        self.assertEqual(roomcast.open(rig).sensors[0].scale_error, 0.02)
        distance = roomcast.measure(rig, ("s0", 20, 20), ("s0", 40, 30))
        self.assertAlmostEqual(distance.by_scale_m, 0.02 * distance.distance_m)
        self.assertGreater(distance.expected_error_m, distance.by_scale_m)

    def test_between_points_of_the_room(self):
        rig = write_rig(self.folder())
        pixels = roomcast.measure(rig, ("s0", 20, 20), ("s0", 40, 30))
        points = roomcast.measure(rig, pixels.a.xyz, pixels.b.xyz)
        self.assertAlmostEqual(points.distance_m, pixels.distance_m, places=3)

    def test_say_what_is_wrong(self):
        rig = write_rig(self.folder())
        for sentence, a in (
            ("s7", ("s7", 1, 1)),
            ("", ("s0", 9999, 1)),
            ("surface", (50.0, 50.0, 50.0)),
            ("", "nonsense"),
            ("finite", (float("nan"), 0, 0)),
        ):
            with self.assertRaisesRegex(roomcast.Error, sentence):
                roomcast.measure(rig, a, ("s0", 20, 20))
        with self.assertRaises(TypeError):
            roomcast.measure(rig, 3, ("s0", 20, 20))


if __name__ == "__main__":
    import unittest

    unittest.main()
