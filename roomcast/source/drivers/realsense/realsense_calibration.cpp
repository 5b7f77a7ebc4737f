// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/drivers/realsense/realsense_calibration.h"

namespace roomcast::source {
namespace {

/// D400 cameras have next to no distortion in depth; their colour calibration is given as the
/// undistortion ("inverse"), whose terms are zero there.
CameraIntrinsics camera_of(const rs2_intrinsics& from) {
  CameraIntrinsics camera{from.width,      from.height,      double(from.fx),
                          double(from.fy), double(from.ppx), double(from.ppy)};
  if (from.model == RS2_DISTORTION_BROWN_CONRADY ||
      from.model == RS2_DISTORTION_MODIFIED_BROWN_CONRADY) {
    camera.k1 = double(from.coeffs[0]), camera.k2 = double(from.coeffs[1]);
    camera.p1 = double(from.coeffs[2]), camera.p2 = double(from.coeffs[3]);
    camera.k3 = double(from.coeffs[4]);
  }
  return camera;
}

RigidTransform transform_of(const rs2_extrinsics& from) {
  RigidTransform transform;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)  // column-major
      transform.rotation(row, column) = double(from.rotation[3 * column + row]);
    transform.translation_m[row] = double(from.translation[row]);
  }
  return transform;
}

}  // namespace

SensorCalibration realsense_calibration(const rs2_intrinsics& depth, const rs2_intrinsics& color,
                                        const rs2_extrinsics& color_from_depth) {
  return {camera_of(depth), camera_of(color), transform_of(color_from_depth), false};
}

}  // namespace roomcast::source
