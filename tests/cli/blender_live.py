# SPDX-License-Identifier: Apache-2.0
"""For blender.test.mjs, inside Blender: watches a room by the add-on and writes what is in the scene as JSON.

blender --background --factory-startup --python blender_live.py -- ADD_ON MODULE HUB OUT
"""
import importlib.util
import json
import sys
import time

import bpy
import numpy as np

add_on, module_folder, hub, out = sys.argv[sys.argv.index("--") + 1 :]
sys.path.insert(0, module_folder)
spec = importlib.util.spec_from_file_location("roomcast_live", add_on)
module = importlib.util.module_from_spec(spec)
spec.loader.exec_module(module)
module.register()  # as Blender does with an add-on
scene = bpy.context.scene
scene.roomcast_hub, scene.roomcast_voxel_m = hub, 0
assert bpy.ops.roomcast.start_live() == {"FINISHED"}
live = module.Showing.live
told = []


def wait_until(what):
    end = time.monotonic() + 20
    while not what():
        assert time.monotonic() < end, "nothing came"
        assert module.Showing.tick() == module.Showing.period_s  # as Blender's timer does, which needs a window
        time.sleep(0.02)


def places(name):
    mesh = bpy.data.objects[name].data
    values = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", values)
    return values


wait_until(lambda: len(live.shown) == 2)
for _ in range(5):
    before = dict(live.shown)
    wait_until(lambda: all(live.shown[sensor] != before[sensor] for sensor in before))
    told.append({name: places(f"roomcast {name}").tolist() for name in live.shown})
wait_until(lambda: live.heads)
head = next(iter(live.heads.values()))
objects = sorted(thing.name for thing in live.collection.objects)
head_at = list(head.matrix_world.translation)
assert bpy.ops.roomcast.stop_live() == {"FINISHED"}
left = sorted(thing.name for thing in live.collection.objects)
assert module.Showing.tick() is None
scene.roomcast_hub = "ws://127.0.0.1:1"
try:
    bpy.ops.roomcast.start_live()
    failure = "no failure"
except RuntimeError as problem:
    failure = str(problem)
module.unregister()
with open(out, "w", encoding="utf-8") as file:
    json.dump({"told": told, "objects": objects, "left": left, "head": head_at, "failure": failure}, file)
