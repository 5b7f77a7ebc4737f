# SPDX-License-Identifier: Apache-2.0
"""Loads what `roomcast export` wrote as an animation in Blender 3.4 or newer: set_NNNNNN.ply, set_NNNNNN.glb, or a mesh.

As an add-on: Edit > Preferences > Add-ons > Install, then File > Import > roomcast export.
As a script:  blender --python roomcast_sequence.py -- FOLDER [--fps 30] [--every N]

Each set is visible from its instant to that of the next set. The instant is the capture time that the file tells; where it
tells none, the sets follow one another, one a frame. roomcast has y up and Blender z up: (x, y, z) becomes (x, -z, y).
"""
import argparse
import json
import re
import struct
import sys
from datetime import datetime, timezone
from pathlib import Path

import bpy
import numpy as np

bl_info = {
    "name": "roomcast export",
    "description": "Loads point clouds and meshes of a room over time",
    "blender": (3, 4, 0),
    "category": "Import-Export",
    "location": "File > Import > roomcast export",
}

POINT_RADIUS_M = 0.004
COLORS = "rgb"  # Cycles draws points black whose colours are bytes, or are called "color"
PLY_TYPES = {"float": "<f4", "uchar": "u1"}


def time_s(text):
    """Seconds since 1970 of "2026-11-26T12:00:00.123456789Z", None for None."""
    match = re.fullmatch(r"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d)\.(\d{9})Z", text or "")
    if not match:
        return None
    whole = datetime.fromisoformat(match[1]).replace(tzinfo=timezone.utc).timestamp()
    return whole + int(match[2]) * 1e-9


def read_ply(path):
    """The vertices of a binary PLY file of roomcast, as a structured array; its capture time in seconds, or None."""
    data = path.read_bytes()
    header, end, body = data.partition(b"end_header\n")
    lines = header.decode("ascii", "replace").splitlines()
    count = next((int(line.split()[2]) for line in lines if line.startswith("element vertex ")), None)
    if not end or lines[:2] != ["ply", "format binary_little_endian 1.0"] or count is None:
        raise ValueError(f"{path} is no PLY file of roomcast export")
    fields = [line.split() for line in lines if line.startswith("property ") and not line.startswith("property list")]
    dtype = np.dtype([(name, PLY_TYPES[kind]) for _, kind, name in fields])
    if len(body) < count * dtype.itemsize:
        raise ValueError(f"{path} ends too early")
    captured = next((line.split()[2] for line in lines if line.startswith("comment captured ")), None)
    return np.frombuffer(body, dtype, count), time_s(captured)


def captured_in_glb(path):
    """The capture time of a GLB file in seconds, or None."""
    with open(path, "rb") as file:
        magic, version, _, length, kind = struct.unpack("<4sIIII", file.read(20).ljust(20, b"\0"))
        if magic != b"glTF" or version != 2 or kind != 0x4E4F534A:
            raise ValueError(f"{path} is no GLB file")
        document = json.loads(file.read(length))
    return time_s(document.get("scenes", [{}])[0].get("extras", {}).get("captured"))


def point_material():
    """Emits the colour of each point."""
    material = bpy.data.materials.get("roomcast points")
    if material:
        return material
    material = bpy.data.materials.new("roomcast points")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    color, emission, output = (nodes.new(kind) for kind in ("ShaderNodeAttribute", "ShaderNodeEmission", "ShaderNodeOutputMaterial"))
    color.attribute_name = COLORS
    links.new(color.outputs["Color"], emission.inputs["Color"])
    links.new(emission.outputs["Emission"], output.inputs["Surface"])
    return material


def point_nodes():
    """Geometry nodes that draw vertices as small spheres."""
    group = bpy.data.node_groups.get("roomcast points")
    if group:
        return group
    group = bpy.data.node_groups.new("roomcast points", "GeometryNodeTree")
    if hasattr(group, "interface"):  # Blender 4
        group.interface.new_socket("Geometry", in_out="INPUT", socket_type="NodeSocketGeometry")
        group.interface.new_socket("Geometry", in_out="OUTPUT", socket_type="NodeSocketGeometry")
    else:
        group.inputs.new("NodeSocketGeometry", "Geometry")
        group.outputs.new("NodeSocketGeometry", "Geometry")
    begin, points, paint, end = (
        group.nodes.new(kind)
        for kind in ("NodeGroupInput", "GeometryNodeMeshToPoints", "GeometryNodeSetMaterial", "NodeGroupOutput")
    )
    points.inputs["Radius"].default_value = POINT_RADIUS_M
    paint.inputs["Material"].default_value = point_material()
    group.links.new(begin.outputs[0], points.inputs["Mesh"])
    group.links.new(points.outputs[0], paint.inputs["Geometry"])
    group.links.new(paint.outputs[0], end.inputs[0])
    return group


def load_cloud(path, collection):
    """Adds a point cloud as an object with coloured vertices. Returns its capture time."""
    vertices, captured = read_ply(path)
    mesh = bpy.data.meshes.new(path.stem)
    mesh.vertices.add(len(vertices))
    places = np.stack([vertices["x"], -vertices["z"], vertices["y"]], axis=1)
    mesh.vertices.foreach_set("co", places.ravel())
    colors = np.ones((len(vertices), 4), np.float32)
    for channel, name in enumerate(("red", "green", "blue")):
        colors[:, channel] = linear(vertices[name] / np.float32(255))
    mesh.attributes.new(COLORS, "FLOAT_COLOR", "POINT").data.foreach_set("color", colors.ravel())
    mesh.update()
    shown = bpy.data.objects.new(path.stem, mesh)
    shown.modifiers.new("points", "NODES").node_group = point_nodes()
    collection.objects.link(shown)
    return captured


def linear(srgb):
    """Light of an sRGB value, both from 0 to 1: the colours of attributes are linear when many are set at once."""
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


def load_meshes(path, collection):
    """Adds the meshes of a GLB file by Blender's own importer, which turns them. Returns their capture time."""
    captured = captured_in_glb(path)
    if not hasattr(np, "bool"):
        np.bool = bool  # Blender 3.4's importer asks for it; NumPy 1.24, with which Debian 12 runs it, has dropped it
    before = set(bpy.data.objects)
    bpy.ops.import_scene.gltf(filepath=str(path))
    for added in set(bpy.data.objects) - before:
        for other in added.users_collection:
            other.objects.unlink(added)
        collection.objects.link(added)
    return captured


def files_in(folder, every=1):
    """The files of a folder in their order: sets, or a mesh."""
    folder = Path(folder)
    for pattern in ("set_*.glb", "set_*.ply", "room.glb"):
        files = sorted(folder.glob(pattern))
        if files:
            return files[::every]
    raise FileNotFoundError(f"{folder} has no set_NNNNNN.glb, set_NNNNNN.ply or room.glb of roomcast export")


def show_between(thing, begin, end):
    """Makes an object visible from frame `begin` to before frame `end` (None: to the end)."""
    for frame, hidden in ((begin - 1, True), (begin, False), (end, True)):
        if frame is None:
            continue
        for path in ("hide_viewport", "hide_render"):
            setattr(thing, path, hidden)
            thing.keyframe_insert(path, frame=frame)


def load(folder, fps=30, every=1):
    """Loads a folder of roomcast export into the scene. Returns the collections, one for each file."""
    files = files_in(folder, every)
    scene = bpy.context.scene
    parent = bpy.data.collections.new(Path(folder).name or "roomcast")
    scene.collection.children.link(parent)
    loaded = []
    for path in files:
        collection = bpy.data.collections.new(path.stem)
        parent.children.link(collection)
        captured = load_cloud(path, collection) if path.suffix == ".ply" else load_meshes(path, collection)
        loaded.append((collection, captured))
    scene.render.fps = fps
    begins = frames_of([captured for _, captured in loaded], fps)
    for i, (collection, _) in enumerate(loaded):
        if len(loaded) > 1:
            for thing in collection.objects:
                show_between(thing, begins[i], begins[i + 1] if i + 1 < len(loaded) else None)
    scene.frame_start, scene.frame_end = 1, begins[-1]
    scene.frame_set(1)
    return [collection for collection, _ in loaded]


def frames_of(captured, fps):
    """The frame from which each set is shown, counted from 1, no two the same."""
    begins = []
    for i, time in enumerate(captured):
        frame = 1 + i if time is None or captured[0] is None else 1 + round((time - captured[0]) * fps)
        begins.append(max(frame, begins[-1] + 1) if begins else frame)
    return begins


class ImportRoomcast(bpy.types.Operator):
    """Load a folder of roomcast export"""

    bl_idname = "import_scene.roomcast"
    bl_label = "roomcast export"
    bl_options = {"UNDO"}

    directory: bpy.props.StringProperty(subtype="DIR_PATH")
    fps: bpy.props.IntProperty(name="Frames per second", default=30, min=1, max=240)
    every: bpy.props.IntProperty(name="Every n-th set", default=1, min=1)

    def execute(self, context):
        try:
            load(self.directory, self.fps, self.every)
        except (OSError, ValueError, KeyError) as problem:
            self.report({"ERROR"}, str(problem))
            return {"CANCELLED"}
        return {"FINISHED"}

    def invoke(self, context, event):
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}


def add_to_menu(menu, context):
    menu.layout.operator(ImportRoomcast.bl_idname, text="roomcast export (folder)")


def register():
    bpy.utils.register_class(ImportRoomcast)
    bpy.types.TOPBAR_MT_file_import.append(add_to_menu)


def unregister():
    bpy.types.TOPBAR_MT_file_import.remove(add_to_menu)
    bpy.utils.unregister_class(ImportRoomcast)


def main(arguments):
    parser = argparse.ArgumentParser(prog="blender --python roomcast_sequence.py --", description=__doc__.splitlines()[0])
    parser.add_argument("folder")
    parser.add_argument("--fps", type=int, default=30)
    parser.add_argument("--every", type=int, default=1, help="only every n-th set")
    options = parser.parse_args(arguments)
    try:
        collections = load(options.folder, max(1, options.fps), max(1, options.every))
    except (OSError, ValueError, KeyError) as problem:
        sys.exit(f"roomcast_sequence.py: {problem}")
    print(f"{len(collections)} sets, frames 1 to {bpy.context.scene.frame_end}")


if __name__ == "__main__" and "--" in sys.argv:
    main(sys.argv[sys.argv.index("--") + 1 :])
