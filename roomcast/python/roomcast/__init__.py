# SPDX-License-Identifier: Apache-2.0
"""Live rooms from several RGB-D sensors: recordings, live rooms, sensors, alignment, measuring.

Units: metres, seconds and nanoseconds; depth is in millimetres along the optical axis, 0 where there
is no reading. The room's frame: right-handed, y up, floor at y = 0. A sensor's frame: x right, y
down, z forward. a_from_b maps points of frame b to frame a. Errors are raised as roomcast.Error.

    import roomcast

    for frames in roomcast.open("lab.mcap"):
        for frame in frames:
            print(frame.sensor, frame.time_ns, frame.depth.shape)
"""
import atexit as _atexit
import weakref as _weakref

from roomcast import _core
from roomcast._core import (
    AlignedPair,
    AlignedSensor,
    Alignment,
    Distance,
    Error,
    Frame,
    FrameSet,
    FrameSets,
    Intrinsics,
    Mark,
    Person,
    Place,
    PointCloud,
    Recording,
    Room,
    SendReport,
    SensorInfo,
    Voice,
    align,
    measure,
    open,
)

__all__ = [
    "AlignedPair",
    "AlignedSensor",
    "Alignment",
    "Distance",
    "Error",
    "Frame",
    "FrameSet",
    "FrameSets",
    "Intrinsics",
    "Mark",
    "Person",
    "Place",
    "PointCloud",
    "Recording",
    "Room",
    "SendReport",
    "Sensor",
    "SensorInfo",
    "Voice",
    "align",
    "measure",
    "open",
    "watch",
]

_connected = _weakref.WeakSet()  # what has threads on the network


def watch(url, *, token="", room="", name="Python", hears=False, author_key=""):
    joined = _core.watch(url, token=token, room=room, name=name, hears=hears, author_key=author_key)
    _connected.add(joined)
    return joined


watch.__doc__ = _core.watch.__doc__.partition("\n\n")[2]


class Sensor(_core.Sensor):
    __doc__ = _core.Sensor.__doc__

    def __init__(self, *args, **options):
        super().__init__(*args, **options)
        _connected.add(self)


@_atexit.register
def _close_all():
    """Ends the network's threads before the interpreter ends."""
    for connection in list(_connected):
        connection.close()


for _public in (name for name in __all__ if name != "Error"):
    globals()[_public].__module__ = __name__
