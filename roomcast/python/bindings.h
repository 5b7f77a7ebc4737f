// SPDX-License-Identifier: Apache-2.0
// The parts of the module: each function adds its classes and functions. Their docstrings are the
// reference for Python's users; `roomcast/__init__.pyi` gives their types. Threading: called once,
// when the module is imported.
#pragma once

#include <pybind11/pybind11.h>

namespace roomcast::python {

void add_cameras(pybind11::module_& module);     // Intrinsics, SensorInfo
void add_frames(pybind11::module_& module);      // FrameSet, Frame, PointCloud
void add_recordings(pybind11::module_& module);  // open(): Recording, FrameSets
void add_rooms(pybind11::module_& module);       // watch(): Room, Person, Mark, Voice
void add_sensors(pybind11::module_& module);     // Sensor, SendReport
void add_alignment(pybind11::module_& module);   // align(): Alignment, AlignedSensor, AlignedPair
void add_measuring(pybind11::module_& module);   // measure(): Distance, Place

}  // namespace roomcast::python
