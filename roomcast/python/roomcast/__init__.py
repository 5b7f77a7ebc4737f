# SPDX-License-Identifier: Apache-2.0
"""Live rooms from several RGB-D sensors: recordings, live rooms, sensors, alignment, measuring.

Units: metres, seconds and nanoseconds; depth is in millimetres along the optical axis, 0 where there
is no reading. The room's frame: right-handed, y up, floor at y = 0. A sensor's frame: x right, y
down, z forward. a_from_b maps points of frame b to frame a. Errors are raised as roomcast.Error.

    import roomcast

    for frames in roomcast.open("lab.mcap"):
        for frame in frames:
            print(frame.sensor, frame.time_ns, frame.depth.shape)
"""
from roomcast._core import (
    Error,
    Frame,
    FrameSet,
    FrameSets,
    Intrinsics,
    PointCloud,
    Recording,
    SensorInfo,
    open,
)

__all__ = [
    "Error",
    "Frame",
    "FrameSet",
    "FrameSets",
    "Intrinsics",
    "PointCloud",
    "Recording",
    "SensorInfo",
    "open",
]
