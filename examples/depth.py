#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Joins a room and prints a summary of each sensor's depth: python3 depth.py ws://127.0.0.1:7600 [LIBRARY]

Needs only Python and libroomcast.so.1, called through ctypes.
"""
import ctypes
import sys
from ctypes import POINTER, c_char_p, c_double, c_int, c_int32, c_int64, c_size_t, c_uint8, c_uint16, c_uint32, c_void_p


class Options(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("hub", c_char_p), ("room", c_char_p), ("name", c_char_p), ("token", c_char_p)]


class Pose(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("head", POINTER(c_double)), ("left_hand", POINTER(c_double)), ("right_hand", POINTER(c_double))]


class Sensor(ctypes.Structure):
    _fields_ = [
        ("size", c_size_t), ("name", c_char_p), ("id", c_uint32), ("width", c_int32), ("height", c_int32),
        *[(field, c_double) for field in ("fx", "fy", "cx", "cy", "k1", "k2", "k3", "p1", "p2")],
        ("world_from_depth", c_double * 16), ("placed", c_int32), ("seq", c_uint32), ("capture_ns", c_int64),
        ("depth_mm", POINTER(c_uint16)), ("color_rgb", POINTER(c_uint8)), ("color_seen", POINTER(c_uint8)),
    ]


def load(path="libroomcast.so.1"):
    library = ctypes.CDLL(path)
    library.roomcast_connect.restype = c_void_p
    library.roomcast_connect.argtypes = [POINTER(Options), c_char_p, c_size_t]
    library.roomcast_disconnect.argtypes = [c_void_p]
    library.roomcast_send_pose.argtypes = [c_void_p, POINTER(Pose), c_char_p, c_size_t]
    library.roomcast_wait_frames.restype = c_void_p
    library.roomcast_wait_frames.argtypes = [c_void_p, c_int]
    library.roomcast_free_frames.argtypes = [c_void_p]
    for count in (library.roomcast_sensor_count, library.roomcast_room_sensor_count):
        count.restype = c_size_t
        count.argtypes = [c_void_p]
    library.roomcast_get_sensor.argtypes = [c_void_p, c_size_t, POINTER(Sensor)]
    return library


def stand_at(roomcast, viewer, x, y, z):
    head = (c_double * 16)(1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z, 0, 0, 0, 1)
    pose = Pose(size=ctypes.sizeof(Pose), head=head)
    roomcast.roomcast_send_pose(viewer, ctypes.byref(pose), None, 0)


def wait_for_all_sensors(roomcast, viewer, tries=100):
    """The first pictures of some sensors come later than those of others."""
    frames = None
    for _ in range(tries):
        newer = roomcast.roomcast_wait_frames(viewer, 100)
        if not newer:
            continue
        if frames:
            roomcast.roomcast_free_frames(frames)
        frames = newer
        if roomcast.roomcast_sensor_count(frames) == roomcast.roomcast_room_sensor_count(frames):
            break
    return frames


def main(hub, library="libroomcast.so.1"):
    roomcast = load(library)
    error = ctypes.create_string_buffer(256)
    options = Options(ctypes.sizeof(Options), hub.encode(), None, b"depth.py", None)
    viewer = roomcast.roomcast_connect(ctypes.byref(options), error, len(error))
    if not viewer:
        sys.exit(error.value.decode())
    stand_at(roomcast, viewer, 0.5, 1.5, 2)
    frames = wait_for_all_sensors(roomcast, viewer)
    sensor = Sensor(size=ctypes.sizeof(Sensor))
    number = 0
    while frames and roomcast.roomcast_get_sensor(frames, number, ctypes.byref(sensor)):
        depth = sensor.depth_mm[: sensor.width * sensor.height]
        readings = sorted(value for value in depth if value)
        middle = readings[len(readings) // 2] / 1000 if readings else 0
        print(f"{sensor.name.decode()}: {sensor.width}x{sensor.height}, {len(readings)} readings, median {middle:.2f} m")
        number += 1
    if frames:
        roomcast.roomcast_free_frames(frames)
    roomcast.roomcast_disconnect(viewer)
    return 0 if number else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))
