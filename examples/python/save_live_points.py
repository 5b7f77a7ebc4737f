#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Saves the points of a live room: save_live_points.py ws://127.0.0.1:7600 room.ply [TOKEN]"""
import sys

import roomcast


def main(hub, out, token=""):
    with roomcast.watch(hub, token=token) as room:
        for frames in room:  # the first frames of some sensors come later than those of others
            if len(frames) > 0 and frames.complete:
                break
    cloud = frames.points()
    cloud.write_ply(out)
    print(f"{len(cloud)} points of {len(frames)} sensors")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:4])
    except roomcast.Error as error:
        sys.exit(f"save_live_points.py: {error}")
