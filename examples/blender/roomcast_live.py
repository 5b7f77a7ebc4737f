# SPDX-License-Identifier: Apache-2.0
"""Shows a live room in Blender 3.4 or newer: the points of each sensor, and the heads of the people there.

As an add-on: install roomcast_sequence.py and then this file (Edit > Preferences > Add-ons > Install); the panel is in the
3D view's sidebar, tab roomcast.
As a script:  blender --python roomcast_live.py -- ws://HOST:PORT [--token TOKEN] [--room NAME] [--voxel 0.01] [--fps 10]
With --background it takes one complete picture of the room: add --save FILE.blend, or go on with --render-output.

Needs the Python module of roomcast (Debian: python3-roomcast; or --module FOLDER). What was received last stays in the scene.
roomcast has y up and Blender z up: (x, y, z) becomes (x, -z, y).
"""
import argparse
import os
import sys
import time

import bpy
import numpy as np

if "__file__" in globals():
    sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from roomcast_sequence import COLORS, linear, point_nodes

bl_info = {
    "name": "roomcast live",
    "description": "Shows a live room",
    "blender": (3, 4, 0),
    "category": "3D View",
    "location": "3D View > Sidebar > roomcast",
}

HEAD_RADIUS_M = 0.11
BLENDER_FROM_ROOM = np.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]], float)


def load_module(folder=None):
    """The module roomcast; ImportError with a remedy."""
    if folder:
        sys.path.insert(0, folder)
    try:
        import roomcast
    except ImportError as problem:
        raise ImportError(f"Blender's Python has no module roomcast (Debian: apt install python3-roomcast): {problem}") from problem
    return roomcast


class LiveRoom:
    """A room that is watched, and its objects in the scene. Use from Blender's main thread."""

    def __init__(self, url, token="", room="", voxel_m=0.0, module=None):
        self.voxel_m = voxel_m
        self.module = load_module(module)
        try:
            self.room = self.module.watch(url, token=token, room=room, name="Blender")
        except self.module.Error as problem:
            raise RuntimeError(str(problem)) from problem
        self.collection = bpy.data.collections.get("roomcast live") or bpy.data.collections.new("roomcast live")
        if self.collection.name not in bpy.context.scene.collection.children:
            bpy.context.scene.collection.children.link(self.collection)
        self.shown = {}  # capture time of what is shown, by sensor
        self.heads = {}  # objects, by person's ID

    def update(self, timeout_s=0):
        """Shows what is newest. Returns the frame set, or None if nothing new came. Raises RuntimeError when it is over."""
        try:
            frames = self.room.newest(timeout_s=timeout_s)
        except self.module.Error as problem:
            raise RuntimeError(str(problem)) from problem
        for frame in frames or []:
            if frame.room_from_sensor is not None and self.shown.get(frame.sensor) != frame.time_ns:
                self.shown[frame.sensor] = frame.time_ns
                self.show_points(frame.sensor, frame.points(voxel_m=self.voxel_m))
        self.show_people()
        return frames

    def show_points(self, sensor, cloud):
        """Replaces the vertices of the sensor's object."""
        shown = self.collection.objects.get(f"roomcast {sensor}")
        if not shown:
            shown = bpy.data.objects.new(f"roomcast {sensor}", bpy.data.meshes.new(f"roomcast {sensor}"))
            shown.modifiers.new("points", "NODES").node_group = point_nodes()
            self.collection.objects.link(shown)
        mesh = shown.data
        mesh.clear_geometry()
        mesh.vertices.add(len(cloud))
        places = np.stack([cloud.xyz[:, 0], -cloud.xyz[:, 2], cloud.xyz[:, 1]], axis=1)
        mesh.vertices.foreach_set("co", places.ravel())
        colors = np.ones((len(cloud), 4), np.float32)
        colors[:, :3] = linear(cloud.colors / np.float32(255))
        attribute = mesh.attributes.get(COLORS) or mesh.attributes.new(COLORS, "FLOAT_COLOR", "POINT")
        attribute.data.foreach_set("color", colors.ravel())
        mesh.update()

    def show_people(self):
        """A ball for each head that is known; removes those of people who left."""
        people = {person.id: person for person in self.room.people if not person.is_self and person.room_from_head is not None}
        for gone in set(self.heads) - set(people):
            remove(self.heads.pop(gone))
        for number, person in people.items():
            if number not in self.heads:
                self.heads[number] = self.make_head(person)
            self.heads[number].matrix_world = (BLENDER_FROM_ROOM @ person.room_from_head).T

    def make_head(self, person):
        bpy.ops.mesh.primitive_uv_sphere_add(radius=HEAD_RADIUS_M, segments=16, ring_count=8)
        head = bpy.context.object
        for other in head.users_collection:
            other.objects.unlink(head)
        self.collection.objects.link(head)
        head.name = f"roomcast person {person.name or person.id}"
        head.color = (*linear(np.array(person.color) / 255), 1)
        return head

    def close(self):
        self.room.close()
        for head in self.heads.values():
            remove(head)
        self.heads.clear()


def remove(thing):
    mesh = thing.data
    bpy.data.objects.remove(thing)
    bpy.data.meshes.remove(mesh)


class Showing:
    """The room that the panel shows, if any, and its timer."""

    live = None
    problem = ""
    period_s = 0.1

    @classmethod
    def start(cls, fps, *args, **options):
        cls.stop()
        cls.live, cls.problem, cls.period_s = LiveRoom(*args, **options), "", 1 / fps
        bpy.app.timers.register(cls.tick, persistent=True)

    @classmethod
    def tick(cls):
        """Blender calls this again after as many seconds as it returns; None: no more."""
        if not cls.live:
            return None
        try:
            cls.live.update()
            cls.problem = cls.live.room.problem or ""
        except (RuntimeError, ReferenceError) as failure:  # over for good, or its objects were deleted
            cls.problem = str(failure)
            cls.stop()
            return None
        return cls.period_s

    @classmethod
    def stop(cls):
        live, cls.live = cls.live, None
        if live:
            live.close()


class StartLive(bpy.types.Operator):
    """Show the room of this hub"""

    bl_idname = "roomcast.start_live"
    bl_label = "Show the room"

    def execute(self, context):
        scene = context.scene
        try:
            Showing.start(scene.roomcast_fps, scene.roomcast_hub, scene.roomcast_token, scene.roomcast_room, scene.roomcast_voxel_m)
        except (ImportError, RuntimeError) as problem:
            self.report({"ERROR"}, str(problem))
            return {"CANCELLED"}
        return {"FINISHED"}


class StopLive(bpy.types.Operator):
    """Leave the room; what was received last stays"""

    bl_idname = "roomcast.stop_live"
    bl_label = "Leave the room"

    def execute(self, context):
        Showing.stop()
        return {"FINISHED"}


class LivePanel(bpy.types.Panel):
    bl_idname = "VIEW3D_PT_roomcast_live"
    bl_label = "roomcast"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "roomcast"

    def draw(self, context):
        for name in PROPERTIES:
            self.layout.prop(context.scene, name)
        self.layout.operator(StopLive.bl_idname if Showing.live else StartLive.bl_idname)
        if Showing.problem:
            self.layout.label(text=Showing.problem, icon="ERROR")


PROPERTIES = {
    "roomcast_hub": bpy.props.StringProperty(name="Hub", default="ws://127.0.0.1:7600"),
    "roomcast_room": bpy.props.StringProperty(name="Room", description="Empty: the hub's only one"),
    "roomcast_token": bpy.props.StringProperty(name="Token", subtype="PASSWORD", options={"SKIP_SAVE"}),
    "roomcast_voxel_m": bpy.props.FloatProperty(name="Cells (m)", description="0: every point", default=0.01, min=0, max=1),
    "roomcast_fps": bpy.props.FloatProperty(name="Pictures a second", default=10, min=0.1, max=60),
}
CLASSES = (StartLive, StopLive, LivePanel)


def register():
    for name, value in PROPERTIES.items():
        setattr(bpy.types.Scene, name, value)
    for one in CLASSES:
        bpy.utils.register_class(one)


def unregister():
    Showing.stop()
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)
    for name in PROPERTIES:
        delattr(bpy.types.Scene, name)


def take_picture(live, patience_s=20):
    """Waits until every sensor that sends is in the scene."""
    until = time.monotonic() + patience_s
    while time.monotonic() < until:
        frames = live.update(timeout_s=1)
        if frames and frames.complete:
            return frames
    raise TimeoutError("no complete picture of the room came: does a sensor send?")


def main(arguments):
    parser = argparse.ArgumentParser(prog="blender --python roomcast_live.py --", description=__doc__.splitlines()[0])
    parser.add_argument("hub")
    parser.add_argument("--token", default="")
    parser.add_argument("--room", default="")
    parser.add_argument("--voxel", type=float, default=0.0, help="size of a cell in metres; 0: every point")
    parser.add_argument("--fps", type=float, default=10, help="pictures a second")
    parser.add_argument("--module", help="folder of the Python module, if it is not installed")
    parser.add_argument("--save", help="with --background: a .blend file to write")
    options = parser.parse_args(arguments)
    try:
        if not bpy.app.background:
            register()
            return Showing.start(max(0.1, options.fps), options.hub, options.token, options.room, options.voxel, options.module)
        live = LiveRoom(options.hub, options.token, options.room, options.voxel, options.module)
        frames = take_picture(live)
        if options.save:
            live.room.may_record or sys.exit("roomcast_live.py: this room does not let viewers record")
            bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath(options.save))
        print(f"{len(frames)} sensors, {sum(len(frame.points(voxel_m=options.voxel)) for frame in frames)} points")
        live.close()
    except (ImportError, RuntimeError, TimeoutError, ValueError) as problem:
        sys.exit(f"roomcast_live.py: {problem}")


if __name__ == "__main__" and "--" in sys.argv:
    main(sys.argv[sys.argv.index("--") + 1 :])
