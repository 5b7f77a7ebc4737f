// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/drivers/k4a/k4a_calibration.h"

#include "roomcast/geometry/rational_lens.h"

namespace roomcast::source {
namespace {

/// Rays with readings in the depth mode that the driver uses (75 x 65 degrees), and what colour
/// shows of them.
constexpr double kDepthRadius = 1.05, kColorRadius = 1.1;

/// Without distortion if the lens is none, which a maker's calibration is not.
CameraIntrinsics camera_of(const k4a_calibration_camera_t& from, double largest_radius) {
  const auto& p = from.intrinsics.parameters.param;
  CameraIntrinsics camera{from.resolution_width, from.resolution_height, double(p.fx),
                          double(p.fy),          double(p.cx),           double(p.cy)};
  RationalLens lens{camera, double(p.k4), double(p.k5), double(p.k6)};
  lens.camera.k1 = double(p.k1), lens.camera.k2 = double(p.k2), lens.camera.k3 = double(p.k3);
  lens.camera.p1 = double(p.p1), lens.camera.p2 = double(p.p2);
  const auto converted = polynomial_lens(lens, largest_radius);
  return converted ? converted->camera : camera;
}

}  // namespace

SensorCalibration k4a_calibration(const k4a_calibration_t& from) {
  constexpr double kMetresPerMillimetre = 0.001;
  const auto& pose = from.extrinsics[K4A_CALIBRATION_TYPE_DEPTH][K4A_CALIBRATION_TYPE_COLOR];
  SensorCalibration cameras;
  cameras.depth = camera_of(from.depth_camera_calibration, kDepthRadius);
  cameras.color = camera_of(from.color_camera_calibration, kColorRadius);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      cameras.color_from_depth.rotation(row, column) = double(pose.rotation[3 * row + column]);
    cameras.color_from_depth.translation_m[row] =
        kMetresPerMillimetre * double(pose.translation[row]);
  }
  return cameras;
}

}  // namespace roomcast::source
