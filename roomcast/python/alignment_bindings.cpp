// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <stop_token>
#include <string>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "roomcast/python/arrays.h"
#include "roomcast/python/bindings.h"
#include "roomcast/python/errors.h"
#include "roomcast/python/waiting.h"
#include "roomcast/recording/align/recorded_alignment.h"

namespace roomcast::python {
namespace {

namespace py = pybind11;
using namespace py::literals;
using alignment::AlignmentReport;
using alignment::PairReport;
using alignment::SensorReport;

constexpr const char* kAlignDoc =
    "Estimates the poses of a rig's sensors from what they see, as `roomcast align` does:\n"
    "without markers, and refusing sensors for which the evidence is not conclusive. Takes\n"
    "seconds to minutes; changes no file (`roomcast align --write` writes the poses into\n"
    "rig.json).\n\n"
    "Raises Error if the folder is no rig, or damaged.";

AlignmentReport align(const std::filesystem::path& path) {
  return value_of(interruptible([&](const std::stop_token& stop) {
    const auto unless_stopped = [&](const std::string&) {
      if (stop.stop_requested()) throw Stopped();
    };
    return recording::align_recording(path, "auto", {}, unless_stopped,
                                      alignment::DepthScaling::kEstimated);
  }));
}

void add_aligned_sensor(py::module_& module) {
  py::class_<SensorReport>(module, "AlignedSensor", "A sensor's pose, or why it has none.")
      .def_readonly("name", &SensorReport::id)
      .def_readonly("placed", &SensorReport::placed)
      .def_property_readonly(
          "room_from_sensor",
          [](const SensorReport& sensor) { return array_or_none(sensor.world_from_depth); },
          "4 x 4 float64, as Frame.room_from_sensor; None: not placed.")
      .def_readonly(
          "expected_error_mm", &SensorReport::expected_error_mm,
          "Standard deviation of surfaces 2.5 m ahead of it; 0 for the sensor at the origin.")
      .def_readonly("expected_error_deg", &SensorReport::expected_error_deg,
                    "Standard deviation of the direction.")
      .def_readonly("depth_scale", &SensorReport::depth_scale,
                    "Factor on its readings that its pose assumes; 1 where it is not determined.")
      .def_property_readonly(
          "depth_scale_standard_error",
          [](const SensorReport& sensor) -> py::object {
            if (sensor.depth_scale_standard_error == 0) return py::none();
            return py::float_(sensor.depth_scale_standard_error);
          },
          "Relative to the origin's; None: that of the origin, or a factor that is not determined.")
      .def_readonly("overlap", &SensorReport::overlap,
                    "Share of its surface that another one sees, 0 to 1.")
      .def_readonly("inliers", &SensorReport::inliers,
                    "Places in space where features agree with another sensor's.")
      .def_property_readonly(
          "residual_mm",
          [](const SensorReport& sensor) -> py::object {
            if (sensor.overlap > 0) return py::float_(sensor.residual_mm);
            return py::none();
          },
          "Distance between the surfaces that it and others see; None: nothing is shared.")
      .def_readonly("reason", &SensorReport::reason, "One sentence.")
      .def("__repr__", [](const SensorReport& sensor) {
        return "<roomcast.AlignedSensor " + sensor.id + (sensor.placed ? ", placed>" : ", apart>");
      });
}

void add_aligned_pair(py::module_& module) {
  py::class_<PairReport>(module, "AlignedPair", "Two sensors, as they were compared.")
      .def_readonly("a", &PairReport::a)
      .def_readonly("b", &PairReport::b)
      .def_readonly("accepted", &PairReport::accepted)
      .def_property_readonly(
          "b_from_a", [](const PairReport& pair) { return array_or_none(pair.b_from_a); },
          "4 x 4 float64: maps points of a to b, metres; None: no pose was found.")
      .def_readonly("overlap", &PairReport::overlap)
      .def_readonly("inliers", &PairReport::inliers)
      .def_readonly("residual_mm", &PairReport::residual_mm)
      .def_readonly("expected_error_mm", &PairReport::expected_error_mm)
      .def_readonly("reason", &PairReport::reason, "One sentence.");
}

}  // namespace

void add_alignment(py::module_& module) {
  add_aligned_sensor(module);
  add_aligned_pair(module);
  py::class_<AlignmentReport>(module, "Alignment", "The result of align().")
      .def_readonly("sensors", &AlignmentReport::sensors, "AlignedSensors, in the rig's order.")
      .def_readonly("pairs", &AlignmentReport::pairs, "AlignedPairs.")
      .def_readonly(
          "scale_error", &AlignmentReport::scale_error,
          "Standard deviation of all distances alike, as a share. Not part of the sensors' "
          "errors.")
      .def("__getitem__", [](const AlignmentReport& report, const std::string& name) {
        for (const SensorReport& sensor : report.sensors)
          if (sensor.id == name) return sensor;
        throw py::key_error(name);
      });
  module.def("align", &align, "path"_a, kAlignDoc);
}

}  // namespace roomcast::python
