#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Is a sensor: sends pictures of a wall with a hole that moves: sensor.py ws://127.0.0.1:7600 my-camera 60"""
import sys
import time

import numpy as np

import roomcast

WIDTH, HEIGHT, FPS = 320, 240, 15
CAMERA = roomcast.Intrinsics(width=WIDTH, height=HEIGHT, fx=280, fy=280, cx=159.5, cy=119.5)
ROOM_FROM_SENSOR = [[1, 0, 0, 0], [0, -1, 0, 1.5], [0, 0, -1, 2], [0, 0, 0, 1]]  # looks along -z


def main(hub, name="my-camera", seconds="60"):
    color = np.zeros((HEIGHT, WIDTH, 3), np.uint8)
    color[..., 0] = np.arange(WIDTH) % 256
    with roomcast.Sensor(
        hub, name, CAMERA, room_from_sensor=ROOM_FROM_SENSOR, fps=FPS, depth_mode="lossless"
    ) as sensor:
        for frame in range(int(FPS * float(seconds))):
            depth = np.full((HEIGHT, WIDTH), 2000, np.uint16)  # millimetres
            depth[:, (np.arange(WIDTH) + 4 * frame) % WIDTH < 40] = 0  # no reading
            report = sensor.send(depth, color)
            time.sleep(1 / FPS)
    print(f"{report.frames_sent} frames sent, {report.frames_skipped} skipped")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:4])
    except roomcast.Error as error:
        sys.exit(f"sensor.py: {error}")
