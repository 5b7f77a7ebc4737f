// SPDX-License-Identifier: Apache-2.0
// Converts the raw 11-bit values of a Kinect v1 to depth. The values are not depths but shifts of
// the projected pattern, in quarters of a pixel, relative to the pattern recorded on a plane at a
// known distance. So 1 / depth is linear in them, and a step of one grows with the square of the
// distance (Khoshelham & Elberink 2012). Each camera stores its own plane. Thread-safe (no state).
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/core/image.h"

namespace roomcast::source {

inline constexpr int kKinectWidth = 640, kKinectHeight = 480;
inline constexpr std::size_t kKinectRawValues = 2048;
inline constexpr std::uint16_t kKinectNoReading = 2047;
/// Beyond this distance one step of the raw value is more than 20 cm.
inline constexpr double kFarthestKinect_mm = 10'000;

/// Calibration in the camera's memory. The picture behind the depth is 1280 pixels wide. The
/// defaults are those of a typical Kinect; single devices differ by some per cent.
struct KinectZeroPlane {
  double emitter_from_ir_camera_mm = 75;
  double color_from_ir_camera_mm = 25;
  double distance_mm = 1200;
  double pixel_on_plane_mm = 1.042;  // size of a pixel on the plane
  double shift_px = 200;             // origin of the scale of the raw values
};

/// Focal length of the depth picture of 640 x 480 pixels.
[[nodiscard]] double depth_focal_length_px(const KinectZeroPlane& plane);

/// Millimetres for each raw value; 0 for no reading and beyond kFarthestKinect_mm.
[[nodiscard]] std::vector<std::uint16_t> kinect_mm_from_raw(const KinectZeroPlane& plane);

/// `raw`: kKinectWidth * kKinectHeight values; values out of range become 0. `mm_from_raw`: the
/// table above.
void kinect_depth_from_raw(const std::uint16_t* raw, const std::vector<std::uint16_t>& mm_from_raw,
                           DepthImage& depth_mm);

}  // namespace roomcast::source
