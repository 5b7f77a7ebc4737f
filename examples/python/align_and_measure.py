#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Aligns the sensors of a rig, then measures in it: align_and_measure.py RIG [s0:320,240 s1:100,80]"""
import sys

import roomcast


def main(rig, a=None, b=None):
    for sensor in roomcast.align(rig).sensors:
        if sensor.placed:
            x, y, z = sensor.room_from_sensor[:3, 3]
            print(f"{sensor.name}: at {x:.3f}, {y:.3f}, {z:.3f} m, +-{sensor.expected_error_mm:.0f} mm")
        else:
            print(f"{sensor.name}: apart, {sensor.reason}")
    if b:  # by the poses in rig.json
        distance = roomcast.measure(rig, a, b)
        print(f"{a} to {b}: {distance.distance_m:.3f} m +- {1000 * distance.expected_error_m:.0f} mm")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:4])
    except roomcast.Error as error:
        sys.exit(f"align_and_measure.py: {error}")
