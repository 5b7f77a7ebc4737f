# SPDX-License-Identifier: Apache-2.0
"""The examples run, are short, and say what is wrong."""
import json
import os
import re
import subprocess
import sys
import unittest
from pathlib import Path

from support import TestCase, depth_mm, run_program, write_rig

EXAMPLES = Path(__file__).parents[3] / "examples/python"


def run_example(name, *args):
    command = [sys.executable, "-X", "dev", str(EXAMPLES / name), *map(str, args)]
    return subprocess.run(command, capture_output=True, text=True, timeout=120)


class Examples(TestCase):
    def prints(self, pattern, name, *args):
        ended = run_example(name, *args)
        self.assertEqual(ended.returncode, 0, ended.stderr)
        self.assertRegex(ended.stdout, pattern)
        return re.search(pattern, ended.stdout)

    def test_saves_the_points_of_a_recording(self):
        out = self.folder() / "room.ply"
        count = int(self.prints(r"^(\d+) points of 2 sensors", "save_points.py", write_rig(self.folder()), out)[1])
        self.assertIn(f"element vertex {count}\n".encode(), out.read_bytes())

    def test_saves_the_points_of_a_live_room(self):
        url, rig, out = self.start_hub(), write_rig(self.folder()), self.folder() / "room.ply"
        for n in range(2):
            self.start("sensor", "--source", f"rig:{rig}#s{n}", "--hub", url, "--verbose").prints("joined")
        count = int(self.prints(r"^(\d+) points of 2 sensors", "save_live_points.py", url, out)[1])
        self.assertIn(f"element vertex {count}\n".encode(), out.read_bytes())

    def test_is_a_sensor_whose_depth_arrives_unchanged(self):
        import roomcast

        url = self.start_hub()
        command = [sys.executable, str(EXAMPLES / "sensor.py"), url, "my-camera", "4"]
        sensor = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        self.addCleanup(sensor.stdout.close)
        self.addCleanup(sensor.wait)
        with roomcast.watch(url) as room:
            depth = next(room)["my-camera"].depth
        self.assertEqual(((depth == 2000).sum(), (depth == 0).sum()), (240 * 280, 240 * 40))
        self.assertGreater(int(re.search(r"^(\d+) frames sent", sensor.stdout.read())[1]), 30)

    def test_aligns_and_measures(self):
        rig = self.folder() / "rig"
        run_program("simulate", rig, "--sensors", 2, "--seconds", 1, "--fps", 4, "--half-color", "--views", 0)
        a, b = "s0:200,200", "s0:300,200"
        told = rf"s0: at .*\ns1: at .* m, \+-\d+ mm\n{a} to {b}: \d+\.\d+ m \+- \d+ mm"
        self.prints(told, "align_and_measure.py", rig, a, b)

    def test_draws_depth(self):
        try:
            import matplotlib  # noqa: F401
        except ImportError:
            self.skipTest("python3-matplotlib is not installed")
        out = self.folder() / "depth.png"
        self.prints("^2 sensors", "plot_depth.py", write_rig(self.folder()), out, 0.2)
        self.assertEqual(out.read_bytes()[:4], b"\x89PNG")

    def test_the_notebook_plots(self):
        try:
            import matplotlib  # noqa: F401
        except ImportError:
            self.skipTest("python3-matplotlib is not installed")
        notebook = json.loads((EXAMPLES / "look_at_a_room.ipynb").read_text(encoding="utf-8"))
        self.assertEqual((notebook["nbformat"], notebook["nbformat_minor"]), (4, 5))
        cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
        self.assertTrue(all(not cell["outputs"] for cell in cells), "it is kept without its outputs")
        program = self.folder() / "cells.py"
        shows = "print(len(plt.get_fignums()), 'figures')\n"
        program.write_text("\n\n".join(cell["source"] for cell in cells) + "\n\n" + shows, encoding="utf-8")
        environment = {**os.environ, "MPLBACKEND": "Agg", "ROOMCAST_RECORDING": str(write_rig(self.folder()))}
        ended = subprocess.run(
            [sys.executable, str(program)], capture_output=True, text=True, timeout=120, env=environment
        )
        self.assertEqual(ended.returncode, 0, ended.stderr)
        self.assertRegex(ended.stdout, r"s0: 64 x 48, .*\n(.*\n)*\d+ points\n3 figures\n$")

    def test_without_a_recording_or_a_hub_says_so_in_one_line(self):
        nowhere, nobody = self.folder() / "nowhere", "ws://127.0.0.1:1"
        for name, args in (
            ("save_points.py", (nowhere, "a.ply")),
            ("save_live_points.py", (nobody, "a.ply")),
            ("sensor.py", (nobody,)),
            ("align_and_measure.py", (nowhere,)),
        ):
            ended = run_example(name, *args)
            self.assertEqual(ended.returncode, 1)
            self.assertRegex(ended.stderr, rf"^{name}: .*(nowhere|127\.0\.0\.1).*\n$")

    def test_are_short_enough_to_read(self):
        examples = list(EXAMPLES.glob("*.py"))
        self.assertEqual(len(examples), 5)
        for example in examples:
            self.assertLess(len(example.read_text().splitlines()), 40, example.name)


if __name__ == "__main__":
    unittest.main()
