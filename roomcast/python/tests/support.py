# SPDX-License-Identifier: Apache-2.0
"""For tests: small rigs, the program, hubs. The environment names the program: ROOMCAST_BIN."""
import json
import os
import re
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib
from pathlib import Path

import numpy as np

PROGRAM = os.environ["ROOMCAST_BIN"]
WIDTH, HEIGHT, FPS = 64, 48, 10


def png(array):
    """A PNG of 16-bit grey or 8-bit RGB, rows without filter."""
    height, width = array.shape[:2]
    rows = array.astype(">u2").tobytes() if array.ndim == 2 else array.tobytes()
    stride = len(rows) // height
    data = b"".join(b"\0" + rows[y * stride : (y + 1) * stride] for y in range(height))
    bits, kind = (16, 0) if array.ndim == 2 else (8, 2)

    def chunk(name, body):
        return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))

    header = struct.pack(">IIBBBBB", width, height, bits, kind, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(data)) + chunk(b"IEND", b"")


def depth_mm(sensor, instant):
    y, x = np.mgrid[:HEIGHT, :WIDTH]
    return (1500 + 100 * sensor + 10 * instant + x + y).astype(np.uint16)


def color(sensor):
    picture = np.zeros((HEIGHT, WIDTH, 3), np.uint8)
    picture[...] = (60 + 20 * sensor, 120, 30)
    return picture


def room_from_sensor(sensor):
    """Two metres from the middle of the room, 1.5 m high, looking across it."""
    sin, cos = round(np.sin(sensor * np.pi / 2)), round(np.cos(sensor * np.pi / 2))
    matrix = np.eye(4)
    matrix[:3] = np.column_stack([(cos, 0, -sin), (0, -1, 0), (-sin, 0, -cos), (2 * sin, 1.5, 2 * cos)])
    return matrix


def write_rig(folder, sensors=2, instants=6, depth_scales=None, placed=True, enlarged=1):
    """A rig whose colour is in the depth grid; returns its path. `enlarged`: each pixel becomes so many, squared."""
    rig = Path(folder) / "rig"
    camera = dict(width=enlarged * WIDTH, height=enlarged * HEIGHT, fx=60 * enlarged, fy=60 * enlarged)
    camera.update(cx=enlarged * 32 - 0.5, cy=enlarged * 24 - 0.5)
    entries = []
    for n in range(sensors):
        for kind in ("depth", "rgb"):
            (rig / f"s{n}" / kind).mkdir(parents=True)
        (rig / f"s{n}/camera.json").write_text(
            json.dumps(dict(depth=camera, color=camera, depth_scale_to_metre=0.001, invalid_depth=[0],
                            color_is_registered=True))
        )
        for kind, picture in (("depth", lambda i: depth_mm(n, i)), ("rgb", lambda i: color(n))):
            lines = []
            for i in range(instants):
                (rig / f"s{n}/{kind}/{i:06}.png").write_bytes(png(picture(i).repeat(enlarged, 0).repeat(enlarged, 1)))
                lines.append(f"{100 + i / FPS:.6f} {kind}/{i:06}.png\n")
            (rig / f"s{n}/{kind}.txt").write_text("".join(lines))
        pose = room_from_sensor(n).ravel().tolist() if placed else None
        entry = dict(id=f"s{n}", path=f"s{n}", world_from_depth=pose)
        if depth_scales:
            entry["depth_scale"] = depth_scales[n]
        entries.append(entry)
    (rig / "rig.json").write_text(json.dumps(dict(version=1, fps=FPS, sensors=entries)))
    return rig


def run_program(*args):
    return subprocess.run([PROGRAM, *map(str, args)], check=True, capture_output=True, text=True, timeout=60)


def run_python(code, *args, timeout=60):
    """Runs code in an interpreter of its own, under its development mode."""
    return subprocess.run([sys.executable, "-X", "dev", "-W", "error", "-c", code, *map(str, args)],
                          capture_output=True, text=True, timeout=timeout)


def start_python(code, *args):
    """The same, without waiting for its end."""
    command = [sys.executable, "-X", "dev", "-c", code, *map(str, args)]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


class Background:
    """A running roomcast."""

    def __init__(self, *args):
        self.process = subprocess.Popen(
            [PROGRAM, *map(str, args)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
        )

    def prints(self, pattern):
        text = ""
        for line in self.process.stdout:
            text += line
            found = re.search(pattern, line)
            if found:
                return found
        raise AssertionError(f"{self.process.args} ended before it printed {pattern}:\n{text}")

    def stop(self):
        self.process.kill()
        self.process.wait()
        self.process.stdout.close()


class TestCase(unittest.TestCase):
    def folder(self):
        folder = tempfile.TemporaryDirectory(prefix="roomcast-python-")
        self.addCleanup(folder.cleanup)
        return Path(folder.name)

    def start(self, *args):
        program = Background(*args)
        self.addCleanup(program.stop)
        return program

    def start_hub(self, *options):
        """Returns the address of a hub of its own."""
        self.hub = self.start("hub", "--listen", "127.0.0.1:0", "--data", self.folder(), *options)
        return "ws://127.0.0.1:" + self.hub.prints(r"open https?://127\.0\.0\.1:(\d+)/")[1]
