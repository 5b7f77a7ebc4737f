// SPDX-License-Identifier: Apache-2.0
// The module roomcast._core; roomcast/__init__.py shows its parts.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "roomcast/python/bindings.h"
#include "roomcast/python/errors.h"
#include "roomcast/python/without_gil.h"

PYBIND11_MODULE(_core, module) {
  module.doc() = "The compiled part of the package roomcast.";
  // NumPy is loaded now: two threads that made the first arrays at once would wait for each other.
  (void)pybind11::dtype::of<float>();
  roomcast::python::register_exit(module);
  roomcast::python::add_error(module);
  roomcast::python::add_cameras(module);
  roomcast::python::add_frames(module);
  roomcast::python::add_recordings(module);
  roomcast::python::add_rooms(module);
  roomcast::python::add_sensors(module);
  roomcast::python::add_alignment(module);
  roomcast::python::add_measuring(module);
}
