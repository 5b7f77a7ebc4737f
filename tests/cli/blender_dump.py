# SPDX-License-Identifier: Apache-2.0
"""For blender.test.mjs, inside Blender: loads folders of roomcast export and writes what is in the scene as JSON.

blender --background --factory-startup --python blender_dump.py -- ADD_ON OUT FOLDER [PICTURE]
"""
import importlib.util
import json
import sys

import bpy
import numpy as np

add_on, out, folder, *picture = sys.argv[sys.argv.index("--") + 1 :]
spec = importlib.util.spec_from_file_location("roomcast_sequence", add_on)
module = importlib.util.module_from_spec(spec)
spec.loader.exec_module(module)
module.register()  # as Blender does with an add-on
for thing in list(bpy.data.objects):
    bpy.data.objects.remove(thing)
assert bpy.ops.import_scene.roomcast(directory=folder, fps=10) == {"FINISHED"}
scene = bpy.context.scene


def describe(thing):
    mesh = thing.data
    local = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", local)
    world = np.array(thing.matrix_world)
    places = local.reshape(-1, 3) @ world[:3, :3].T + world[:3, 3]
    described = {"name": thing.name, "positions": places.ravel().tolist(), "triangles": len(mesh.polygons)}
    if "rgb" in mesh.attributes:  # linear light
        described["colors"] = [c for value in mesh.attributes["rgb"].data[:3] for c in value.color]
    described["materials"] = [material.name for material in mesh.materials]
    return described


collections = [c for c in bpy.data.collections if c.name.startswith(("set_", "room"))]
visible = []
for frame in range(scene.frame_start, scene.frame_end + 1):
    scene.frame_set(frame)
    visible.append([c.name for c in collections if c.objects and not any(thing.hide_render for thing in c.objects)])
with open(out, "w", encoding="utf-8") as file:
    first = [describe(thing) for thing in collections[0].objects if thing.type == "MESH"]
    json.dump({"sets": [c.name for c in collections], "visible": visible, "first": first}, file)

if picture:
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.lens = 20
    camera.location, camera.rotation_euler = (0, -2, 1.6), (1.45, 0, 0)
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_denoising = 4, False
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 320, 240, 100
    scene.view_settings.view_transform = "Standard"
    scene.render.filepath = picture[0]
    scene.frame_set(scene.frame_start)
    bpy.ops.render.render(write_still=True)
