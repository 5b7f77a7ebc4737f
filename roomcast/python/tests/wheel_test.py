# SPDX-License-Identifier: Apache-2.0
"""The wheel installs into a fresh virtual environment, and what is installed works there.

NumPy is the system's: nothing is fetched.
"""
import importlib.util
import os
import subprocess
import sys
import unittest
from pathlib import Path

import roomcast
from support import TestCase, write_rig

BUILD = Path(roomcast.__file__).parents[2]
WHEEL = Path(__file__).parents[3] / "packaging/wheel.py"


def run(*command):
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    ended = subprocess.run([*map(str, command)], capture_output=True, text=True, env=environment, timeout=150)
    if ended.returncode != 0:
        raise AssertionError(f"{command}: {ended.stdout}{ended.stderr}")
    return ended.stdout.strip()


@unittest.skipUnless(importlib.util.find_spec("ensurepip"), "python3-venv is not installed")
class Wheel(TestCase):
    def test_is_installed_used_and_removed(self):
        folder = self.folder()
        wheel = run(sys.executable, WHEEL, BUILD, folder)
        self.assertEqual(run(sys.executable, WHEEL, BUILD, folder / "again").rpartition("/")[2], Path(wheel).name)
        self.assertEqual(Path(wheel).read_bytes(), (folder / "again" / Path(wheel).name).read_bytes())
        run(sys.executable, "-m", "venv", "--system-site-packages", folder / "venv")
        python = folder / "venv/bin/python3"
        run(python, "-m", "pip", "install", "--no-index", "--disable-pip-version-check", wheel)
        code = (
            "import roomcast, sys; print(roomcast.__file__)\n"
            "print(sum(len(frames.points()) for frames in roomcast.open(sys.argv[1])))"
        )
        place, points = run(python, "-X", "dev", "-c", code, write_rig(self.folder())).split("\n")
        self.assertTrue(place.startswith(str(folder / "venv")), place)
        self.assertGreater(int(points), 1000)
        run(python, "-m", "pip", "uninstall", "--yes", "roomcast")
        self.assertFalse(list((folder / "venv").rglob("*roomcast*")))


if __name__ == "__main__":
    unittest.main()
