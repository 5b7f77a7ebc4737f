# SPDX-License-Identifier: Apache-2.0
"""Recordings: frame sets, their arrays, errors."""
import os
import shutil

import numpy as np

import roomcast
from support import FPS, HEIGHT, WIDTH, TestCase, color, depth_mm, room_from_sensor, run_program, write_rig


class Recordings(TestCase):
    def test_gives_every_set_of_a_rig(self):
        with roomcast.open(write_rig(self.folder())) as recording:
            self.assertEqual([sensor.name for sensor in recording.sensors], ["s0", "s1"])
            self.assertEqual(len(recording), 6)
            sets = list(recording)
        self.assertEqual([frames.number for frames in sets], list(range(6)))
        for i, frames in enumerate(sets):
            self.assertEqual(frames.sensors, ["s0", "s1"])
            self.assertTrue(frames.complete)
            for n, frame in enumerate(frames):
                np.testing.assert_array_equal(frame.depth, depth_mm(n, i))
                np.testing.assert_array_equal(frame.color, color(n))
                np.testing.assert_allclose(frame.room_from_sensor, room_from_sensor(n), atol=1e-12)
                self.assertEqual(frame.time_ns, i * 1_000_000_000 // FPS)

    def test_describes_arrays(self):
        frame = next(iter(roomcast.open(write_rig(self.folder()))))["s1"]
        self.assertEqual((frame.depth.dtype, frame.depth.shape), (np.uint16, (HEIGHT, WIDTH)))
        self.assertEqual((frame.color.dtype, frame.color.shape), (np.uint8, (HEIGHT, WIDTH, 3)))
        self.assertEqual((frame.color_seen.dtype, frame.color_seen.shape), (np.uint8, (HEIGHT, WIDTH)))
        self.assertEqual((frame.room_from_sensor.dtype, frame.room_from_sensor.shape), (np.float64, (4, 4)))
        np.testing.assert_array_equal(frame.intrinsics.matrix, [[60, 0, 31.5], [0, 60, 23.5], [0, 0, 1]])
        np.testing.assert_array_equal(frame.intrinsics.distortion, np.zeros(5))
        self.assertEqual((frame.intrinsics.width, frame.intrinsics.height), (WIDTH, HEIGHT))

    def test_arrays_are_read_only_views_of_the_same_memory(self):
        frame = next(iter(roomcast.open(write_rig(self.folder()))))[0]
        self.assertEqual(frame.depth.ctypes.data, frame.depth.ctypes.data)
        self.assertFalse(frame.depth.flags.owndata or frame.color.flags.owndata)
        with self.assertRaises(ValueError):
            frame.depth[0, 0] = 1

    def test_applies_the_depth_scale_of_the_rig(self):
        rig = write_rig(self.folder(), depth_scales=[1.0, 1.1])
        frames = next(iter(roomcast.open(rig)))
        np.testing.assert_array_equal(frames[0].depth, depth_mm(0, 0))
        np.testing.assert_allclose(frames[1].depth, 1.1 * depth_mm(1, 0), atol=0.51)

    def test_begins_where_it_is_told(self):
        recording = roomcast.open(write_rig(self.folder()), start_s=0.35)
        self.assertEqual(len(recording), 2)
        self.assertEqual([frames.time_ns for frames in recording], [400_000_000, 500_000_000])

    def test_every_loop_reads_it_anew(self):
        recording = roomcast.open(write_rig(self.folder()))
        for _ in range(2):
            self.assertEqual([frames.number for frames in recording], list(range(6)))

    def test_sensors_without_a_pose_have_none(self):
        frames = next(iter(roomcast.open(write_rig(self.folder(), placed=False))))
        self.assertIsNone(frames[0].room_from_sensor)

    def test_frames_are_found_by_index_and_name(self):
        frames = next(iter(roomcast.open(write_rig(self.folder()))))
        self.assertEqual((frames[-1].sensor, frames["s0"].sensor), ("s1", "s0"))
        self.assertIn("s0", frames)
        self.assertNotIn("s7", frames)
        with self.assertRaises(IndexError):
            frames[2]
        with self.assertRaises(KeyError):
            frames["s7"]

    def test_reads_a_recorded_room(self):
        file = self.folder() / "room.mcap"
        url = self.start_hub()
        rig = write_rig(self.folder(), instants=4)
        options = ["--hub", url, "--codec", "lossless", "--verbose"]
        sensors = [self.start("sensor", "--source", f"rig:{rig}#s{n}", *options) for n in range(2)]
        for sensor in sensors:
            sensor.prints("joined")
        run_program("record", file, "--hub", url, "--seconds", 2)
        with roomcast.open(file) as recording:
            self.assertIsNone(recording.damage)
            self.assertGreater(recording.began_at_ns, 1_600_000_000 * 10**9)
            self.assertAlmostEqual(recording.duration_s, 2, delta=1)
            with self.assertRaises(TypeError):
                len(recording)
            sets = [frames for frames in recording if len(frames) == 2]
        self.assertGreater(len(sets), 5)
        truth = [[depth_mm(n, i).tobytes() for i in range(4)] for n in range(2)]
        for frames in sets:
            self.assertGreaterEqual(frames.time_ns, recording.began_at_ns)
            for n, frame in enumerate(frames):
                self.assertIn(frame.depth.tobytes(), truth[n])
                self.assertLess(abs(frame.color.astype(int) - color(n)).max(), 12)
        self.check_truncated(file)

    def check_truncated(self, whole):
        """What is left of a file is read, or refused with a sentence."""
        part = self.folder() / "part.mcap"
        for share in (0, 0.001, 0.3, 0.7, 0.95):
            data = whole.read_bytes()
            part.write_bytes(data[: int(share * len(data))])
            try:
                recording = roomcast.open(part)
                self.assertRegex(recording.damage, r"part\.mcap")
                self.assertGreaterEqual(sum(1 for _ in recording), 1 if share > 0.5 else 0)
            except roomcast.Error as error:
                self.assertRegex(str(error), r"part\.mcap")
                self.assertIn(error.code, ("malformed", "unsupported"))


class Errors(TestCase):
    def assert_refused(self, code, sentence, path, **options):
        with self.assertRaisesRegex(roomcast.Error, sentence) as caught:
            list(roomcast.open(path, **options))
        self.assertEqual(caught.exception.code, code)

    def test_a_missing_recording(self):
        self.assert_refused("not_found", "nothing", self.folder() / "nothing.mcap")
        self.assert_refused("not_found", "neither rig.json nor depth.txt", self.folder())

    def test_a_file_of_another_kind(self):
        file = self.folder() / "a.mcap"
        file.write_bytes(os.urandom(5000))
        self.assert_refused("malformed", "a.mcap", file)

    def test_a_damaged_rig(self):
        rig = write_rig(self.folder())
        (rig / "rig.json").write_text('{"version": 1, "sensors": [')
        self.assert_refused("malformed", "rig.json", rig)

    def test_a_damaged_picture_is_told_and_the_rest_is_read(self):
        rig = write_rig(self.folder())
        (rig / "s0/depth/000003.png").write_bytes(b"no picture")
        sets = iter(roomcast.open(rig))
        read, told = 0, 0
        while True:
            try:
                next(sets)
                read += 1
            except StopIteration:
                break
            except roomcast.Error as error:
                self.assertIn("000003.png", str(error))
                told += 1
        self.assertEqual(told, 1)
        self.assertGreaterEqual(read, 4)

    def test_pictures_that_are_gone(self):
        rig = write_rig(self.folder())
        recording = roomcast.open(rig)
        shutil.rmtree(rig / "s1/depth")
        with self.assertRaisesRegex(roomcast.Error, "s1"):
            list(recording)

    def test_a_time_that_is_none(self):
        rig = write_rig(self.folder())
        for start_s in (-1, float("nan"), float("inf")):
            self.assert_refused("invalid_argument", "start_s", rig, start_s=start_s)

    def test_a_path_that_is_none(self):
        for path in (3, None):
            with self.assertRaises(TypeError):
                roomcast.open(path)

    def test_a_name_that_is_not_utf_8(self):
        self.assert_refused("not_found", "a", os.fsencode(self.folder()) + b"/a\xff.mcap")

    def test_a_closed_recording(self):
        with roomcast.open(write_rig(self.folder())) as recording:
            sets = iter(recording)
            next(sets)
        for use in (lambda: next(sets), lambda: iter(recording)):
            with self.assertRaisesRegex(roomcast.Error, "closed"):
                use()


if __name__ == "__main__":
    import unittest

    unittest.main()
