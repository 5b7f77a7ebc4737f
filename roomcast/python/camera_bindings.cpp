// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <pybind11/numpy.h>

#include "roomcast/geometry/camera_model.h"
#include "roomcast/python/bindings.h"
#include "roomcast/python/errors.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"

namespace roomcast::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

constexpr const char* kIntrinsicsDoc =
    "A pinhole camera with Brown-Conrady distortion, as in OpenCV.\n\n"
    "Pixel centres are at whole numbers. fx, fy, cx, cy: pixels. Camera frame: x right, y\n"
    "down, z forward.";

CameraIntrinsics make_intrinsics(int width, int height, double fx, double fy, double cx, double cy,
                                 double k1, double k2, double p1, double p2, double k3) {
  const CameraIntrinsics camera{.width = width,
                                .height = height,
                                .fx = fx,
                                .fy = fy,
                                .cx = cx,
                                .cy = cy,
                                .k1 = k1,
                                .k2 = k2,
                                .k3 = k3,
                                .p1 = p1,
                                .p2 = p2};
  check(camera.check());
  return camera;
}

py::array_t<double> matrix_of(const CameraIntrinsics& camera) {
  py::array_t<double> matrix({3, 3});
  const double rows[9] = {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1};
  std::copy(rows, rows + 9, matrix.mutable_data());
  return matrix;
}

py::array_t<double> distortion_of(const CameraIntrinsics& camera) {
  py::array_t<double> numbers(5);
  const double in_order[5] = {camera.k1, camera.k2, camera.p1, camera.p2, camera.k3};
  std::copy(in_order, in_order + 5, numbers.mutable_data());
  return numbers;
}

std::string text_of(const CameraIntrinsics& camera) {
  return "<roomcast.Intrinsics " + std::to_string(camera.width) + " x " +
         std::to_string(camera.height) + ">";
}

}  // namespace

void add_cameras(py::module_& module) {
  py::class_<CameraIntrinsics>(module, "Intrinsics", kIntrinsicsDoc)
      .def(py::init(&make_intrinsics), py::kw_only(), "width"_a, "height"_a, "fx"_a, "fy"_a, "cx"_a,
           "cy"_a, "k1"_a = 0.0, "k2"_a = 0.0, "p1"_a = 0.0, "p2"_a = 0.0, "k3"_a = 0.0)
      .def_readonly("width", &CameraIntrinsics::width, "Pixels.")
      .def_readonly("height", &CameraIntrinsics::height, "Pixels.")
      .def_readonly("fx", &CameraIntrinsics::fx, "Focal length, pixels.")
      .def_readonly("fy", &CameraIntrinsics::fy, "Focal length, pixels.")
      .def_readonly("cx", &CameraIntrinsics::cx, "Principal point, pixels.")
      .def_readonly("cy", &CameraIntrinsics::cy, "Principal point, pixels.")
      .def_property_readonly("matrix", &matrix_of, "3 x 3 float64, OpenCV's camera matrix.")
      .def_property_readonly("distortion", &distortion_of,
                             "float64, in OpenCV's order: k1, k2, p1, p2, k3.")
      .def("__eq__", [](const CameraIntrinsics& a, const CameraIntrinsics& b) { return a == b; })
      .def("__repr__", &text_of);
  py::class_<recording::SetSensor>(module, "SensorInfo", "A sensor of a recording or of a room.")
      .def_readonly("name", &recording::SetSensor::name)
      .def_readonly("intrinsics", &recording::SetSensor::depth,
                    "Of its depth, and of its colour, which is in the depth grid.")
      .def_readonly("fps", &recording::SetSensor::fps, "Frames a second, nominally.")
      .def_property_readonly(
          "expected_error_m",
          [](const recording::SetSensor& sensor) -> py::object {
            if (sensor.expected_error_m == 0) return py::none();
            return py::float_(sensor.expected_error_m);
          },
          "Standard deviation of an estimated pose, 2.5 m in front of the sensor; None: unknown.")
      .def_property_readonly(
          "scale_error",
          [](const recording::SetSensor& sensor) -> py::object {
            if (sensor.scale_error == 0) return py::none();
            return py::float_(sensor.scale_error);
          },
          "Standard deviation of all of the room's distances alike, as a share; not part of\n"
          "expected_error_m; None: unknown.")
      .def("__repr__", [](const recording::SetSensor& sensor) {
        return "<roomcast.SensorInfo " + sensor.name + ">";
      });
}

}  // namespace roomcast::python
