// SPDX-License-Identifier: Apache-2.0
// Camera models of a Kinect v1. The device gives, for each pixel, the position of its depth in the
// colour picture (a polynomial in its memory, which libfreenect expands to tables); the cameras are
// fitted to those tables. Pixels with centres at integers, metres. Thread-safe (no state).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/source/drivers/freenect/kinect_depth.h"

namespace roomcast::source {

/// The tables of libfreenect. A depth pixel is at x = (pixels[i][0] + shift_of_mm[depth]) / 256, y
/// = pixels[i][1] in the colour picture, counted from the corner.
struct KinectColorMap {
  std::span<const std::array<std::int32_t, 2>> pixels;  // 640 * 480, row by row
  std::span<const std::int32_t> shift_of_mm;            // for 0 to 9999 mm
};

/// Cameras of a typical Kinect, for one without calibration: the nominal lenses, and the colour
/// camera `color_from_ir_camera_mm` to the side.
[[nodiscard]] SensorCalibration typical_kinect(const KinectZeroPlane& plane);

/// Returns kMalformed if no cameras fit: the memory was not read properly.
[[nodiscard]] Result<SensorCalibration> kinect_calibration(const KinectZeroPlane& plane,
                                                           const KinectColorMap& map);

}  // namespace roomcast::source
