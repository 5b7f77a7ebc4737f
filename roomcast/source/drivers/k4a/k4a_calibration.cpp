// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/drivers/k4a/k4a_calibration.h"

namespace roomcast::source {
namespace {

/// Approximates the rational lens model, which also has k4 to k6, by a polynomial. (1 + a) / (1 +
/// b) is 1 + (a - b) - b (a - b) + ...: over the narrow field of view the first three powers are
/// accurate to well below a pixel.
CameraIntrinsics camera_of(const k4a_calibration_camera_t& from) {
  const auto& p = from.intrinsics.parameters.param;
  const double k1 = double(p.k1) - double(p.k4), k2 = double(p.k2) - double(p.k5);
  const double k3 = double(p.k3) - double(p.k6), k4 = double(p.k4), k5 = double(p.k5);
  CameraIntrinsics camera{from.resolution_width, from.resolution_height, double(p.fx),
                          double(p.fy),          double(p.cx),           double(p.cy)};
  camera.k1 = k1;
  camera.k2 = k2 - k4 * k1;
  camera.k3 = k3 - k4 * k2 - (k5 - k4 * k4) * k1;
  camera.p1 = double(p.p1), camera.p2 = double(p.p2);
  return camera;
}

}  // namespace

SensorCalibration k4a_calibration(const k4a_calibration_t& from) {
  constexpr double kMetresPerMillimetre = 0.001;
  const auto& pose = from.extrinsics[K4A_CALIBRATION_TYPE_DEPTH][K4A_CALIBRATION_TYPE_COLOR];
  SensorCalibration cameras;
  cameras.depth = camera_of(from.depth_camera_calibration);
  cameras.color = camera_of(from.color_camera_calibration);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      cameras.color_from_depth.rotation(row, column) = double(pose.rotation[3 * row + column]);
    cameras.color_from_depth.translation_m[row] =
        kMetresPerMillimetre * double(pose.translation[row]);
  }
  return cameras;
}

}  // namespace roomcast::source
