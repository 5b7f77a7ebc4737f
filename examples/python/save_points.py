#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Saves the point cloud of a recording's first complete frame set: save_points.py lab.mcap room.ply"""
import sys

import roomcast


def main(recording, out):
    with roomcast.open(recording) as room:
        for frames in room:
            if frames.complete:
                break
        else:
            sys.exit(f"{recording}: no frame set has all sensors")
    cloud = frames.points(voxel_m=0.01)
    cloud.write_ply(out)
    low, high = cloud.xyz.min(axis=0), cloud.xyz.max(axis=0)
    print(f"{len(cloud)} points of {len(frames)} sensors, from {low.round(2)} to {high.round(2)} m")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:3])
    except roomcast.Error as error:
        sys.exit(f"save_points.py: {error}")
