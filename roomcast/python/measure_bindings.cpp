// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <stop_token>
#include <string>
#include <tuple>
#include <variant>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "roomcast/python/bindings.h"
#include "roomcast/python/errors.h"
#include "roomcast/python/waiting.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"
#include "roomcast/recording/measure/distance.h"

namespace roomcast::python {
namespace {

namespace py = pybind11;
using namespace py::literals;
using recording::MeasuredDistance;
using recording::MeasuredPlace;
using recording::PickedPlace;

using Pixel = std::tuple<std::string, double, double>;
using Place = std::variant<std::string, Pixel, std::array<double, 3>>;

constexpr const char* kMeasureDoc =
    "The distance between two places in a recorded room, with its expected error, as\n"
    "`roomcast measure` does it: by the median of many frames, without people who walk\n"
    "through.\n\n"
    "a, b: ('s0', x, y), a depth pixel of a sensor; or (x, y, z), metres in the room; or\n"
    "the same as text, 's0:320,240' or '1.2,0.8,-0.4'. start_s: measures from this second\n"
    "on.\n"
    "Raises Error if there is no surface at a place, or if the recording cannot be read.";

PickedPlace picked(const Place& place) {
  if (const auto* text = std::get_if<std::string>(&place))
    return value_of(recording::parse_place(*text));
  PickedPlace out;
  if (const auto* pixel = std::get_if<Pixel>(&place)) {
    out.sensor = std::get<0>(*pixel);
    out.pixel = {std::get<1>(*pixel), std::get<2>(*pixel)};
    if (!out.pixel.allFinite()) throw Failure(invalid_argument("a pixel is not a finite number"));
    return out;
  }
  const auto& world_m = std::get<std::array<double, 3>>(place);
  out.world_m = Eigen::Vector3d(world_m[0], world_m[1], world_m[2]);
  if (!out.world_m->allFinite()) throw Failure(invalid_argument("a place is not finite numbers"));
  return out;
}

MeasuredDistance measure(const std::filesystem::path& path, const Place& a, const Place& b,
                         double start_s) {
  if (!(start_s >= 0 && start_s <= 1e9))
    throw Failure(invalid_argument("start_s must be 0 to 1e9 seconds"));
  const PickedPlace from = picked(a), to = picked(b);
  return value_of(interruptible([&](const std::stop_token& stop) -> Result<MeasuredDistance> {
    auto reader = recording::open_frame_sets(path, nanoseconds(std::llround(start_s * 1e9)));
    if (!reader) return reader.error();
    const auto room = recording::gather_static_room(**reader, [&](std::size_t) {
      if (stop.stop_requested()) throw Stopped();
    });
    if (!room) return room.error();
    return recording::measure_distance(*room, from, to);
  }));
}

}  // namespace

void add_measuring(py::module_& module) {
  py::class_<MeasuredPlace>(module, "Place", "A place that was measured.")
      .def_property_readonly(
          "xyz",
          [](const MeasuredPlace& place) {
            return std::make_tuple(place.world_m.x(), place.world_m.y(), place.world_m.z());
          },
          "(x, y, z), metres in the room.")
      .def_readonly("sensor", &MeasuredPlace::sensor, "Name of the sensor that sees it.")
      .def_readonly("expected_error_m", &MeasuredPlace::expected_error_m,
                    "Standard deviation, without the error of the sensor's pose.");
  py::class_<MeasuredDistance>(module, "Distance", "The result of measure().")
      .def_readonly("distance_m", &MeasuredDistance::distance_m)
      .def_readonly("expected_error_m", &MeasuredDistance::expected_error_m, "Standard deviation.")
      .def_readonly("by_scale_m", &MeasuredDistance::by_scale_m,
                    "The part of expected_error_m that the room's scale has; 0: it is not known.")
      .def_readonly("a", &MeasuredDistance::from)
      .def_readonly("b", &MeasuredDistance::to)
      .def("__repr__", [](const MeasuredDistance& distance) {
        return "<roomcast.Distance " + std::to_string(distance.distance_m) + " m>";
      });
  module.def("measure", &measure, "path"_a, "a"_a, "b"_a, py::kw_only(), "start_s"_a = 0.0,
             kMeasureDoc);
}

}  // namespace roomcast::python
