#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws depth and colour of all sensors, with matplotlib: plot_depth.py lab.mcap depth.png [SECOND]"""
import sys

import matplotlib
import numpy as np

import roomcast

matplotlib.use("Agg")  # without a display
import matplotlib.pyplot as plt


def main(recording, out, second="0"):
    frames = next(iter(roomcast.open(recording, start_s=float(second))))
    figure, axes = plt.subplots(2, len(frames), squeeze=False, figsize=(5 * len(frames), 7))
    for (upper, lower), frame in zip(axes.T, frames):
        depth_m = np.where(frame.depth == 0, np.nan, frame.depth / 1000)
        figure.colorbar(upper.imshow(depth_m), ax=upper, label="m")
        upper.set_title(frame.sensor)
        if frame.color is not None:
            lower.imshow(frame.color)
    figure.savefig(out)
    print(f"{len(frames)} sensors")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:4])
    except roomcast.Error as error:
        sys.exit(f"plot_depth.py: {error}")
