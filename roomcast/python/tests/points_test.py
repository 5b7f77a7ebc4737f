# SPDX-License-Identifier: Apache-2.0
"""Point clouds: the same as `roomcast export` writes."""

import numpy as np

import roomcast
from support import TestCase, depth_mm, room_from_sensor, run_program, write_rig

PLY = np.dtype([("xyz", "<f4", 3), ("normal", "<f4", 3), ("color", "u1", 3)])


def read_ply(path):
    data = path.read_bytes()
    return np.frombuffer(data[data.index(b"end_header\n") + len("end_header\n") :], PLY)


class PointClouds(TestCase):
    def test_agree_with_the_export_of_the_same_sets(self):
        rig, out = write_rig(self.folder()), self.folder() / "out"
        for options, flags in (
            ({}, []),
            ({"keep_doubles": True}, ["--keep-doubles"]),
            ({"voxel_m": 0.05}, ["--voxel", "0.05"]),
            ({"crop": ((-1, 0, -1), (1, 3, 1))}, ["--crop=-1,0,-1,1,3,1"]),
        ):
            folder = out / "".join(flags).replace(",", "_")
            run_program("export", rig, "--format", "ply", "--out", folder, *flags)
            for frames in roomcast.open(rig):
                exported = read_ply(folder / f"set_{frames.number:06}.ply")
                cloud = frames.points(**options)
                self.assertGreater(len(cloud), 100)
                self.assertEqual(len(cloud), len(exported))
                self.assertLess(abs(cloud.xyz - exported["xyz"]).max(), 1e-4)
                np.testing.assert_allclose(cloud.normals, exported["normal"], atol=1e-5)
                np.testing.assert_array_equal(cloud.colors, exported["color"])

    def test_are_where_the_depth_and_the_pose_say(self):
        frame = next(iter(roomcast.open(write_rig(self.folder()))))["s1"]
        y, x = np.mgrid[1:47, 1:63]
        z = depth_mm(1, 0)[1:47, 1:63] / 1000
        in_sensor = np.stack([(x - 31.5) / 60 * z, (y - 23.5) / 60 * z, z], axis=-1).reshape(-1, 3)
        pose = room_from_sensor(1)
        cloud = frame.points()
        self.assertLess(abs(cloud.xyz - (in_sensor @ pose[:3, :3].T + pose[:3, 3])).max(), 1e-4)
        np.testing.assert_allclose(np.linalg.norm(cloud.normals, axis=1), 1, atol=1e-4)
        self.assertEqual((cloud.xyz.dtype, cloud.colors.dtype), (np.float32, np.uint8))
        np.testing.assert_array_equal(np.asarray(cloud), cloud.xyz)
        self.assertEqual(np.asarray(cloud, dtype=np.float64).dtype, np.float64)

    def test_of_a_sensor_without_a_pose_are_in_its_own_frame(self):
        frame = next(iter(roomcast.open(write_rig(self.folder(), placed=False))))[0]
        self.assertGreater(frame.points().xyz[:, 2].min(), 1.4)

    def test_of_sensors_without_poses_have_no_common_cloud(self):
        frames = next(iter(roomcast.open(write_rig(self.folder(), placed=False))))
        self.assertEqual(frames.points().xyz.shape, (0, 3))

    def test_are_written_as_the_export_writes_them(self):
        rig, out = write_rig(self.folder(), instants=1), self.folder()
        run_program("export", rig, "--format", "ply", "--out", out)
        next(iter(roomcast.open(rig))).points().write_ply(out / "own.ply")
        self.assertEqual((out / "own.ply").read_bytes(), (out / "set_000000.ply").read_bytes())

    def test_say_why_they_cannot_be_written(self):
        cloud = next(iter(roomcast.open(write_rig(self.folder())))).points()
        with self.assertRaisesRegex(roomcast.Error, "nowhere"):
            cloud.write_ply(self.folder() / "nowhere/a.ply")

    def test_refuse_options_that_make_no_sense(self):
        frames = next(iter(roomcast.open(write_rig(self.folder()))))
        for options in ({"voxel_m": -1}, {"voxel_m": float("nan")}, {"voxel_m": 2}):
            with self.assertRaisesRegex(roomcast.Error, "voxel"):
                frames.points(**options)
        with self.assertRaises(TypeError):
            frames.points(crop=(1, 2, 3))


if __name__ == "__main__":
    import unittest

    unittest.main()
