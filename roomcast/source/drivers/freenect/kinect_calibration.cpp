// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/drivers/freenect/kinect_calibration.h"

#include <array>
#include <vector>

#include "roomcast/source/camera/color_camera_fit.h"

namespace roomcast::source {
namespace {

constexpr double kNominalColorFocal_px = 525;
constexpr double kFixedPoint = 256;
constexpr int kGridStep = 16;
constexpr std::array<std::uint16_t, 5> kDepths_mm = {600, 1000, 2000, 4000, 8000};

std::vector<MappedPoint> points_of(const CameraIntrinsics& depth, const KinectColorMap& map) {
  std::vector<MappedPoint> points;
  for (int y = kGridStep / 2; y < kKinectHeight; y += kGridStep) {
    for (int x = kGridStep / 2; x < kKinectWidth; x += kGridStep) {
      const auto& pixel = map.pixels[static_cast<std::size_t>(y * kKinectWidth + x)];
      for (const std::uint16_t mm : kDepths_mm) {
        const double from_corner = (pixel[0] + map.shift_of_mm[mm]) / kFixedPoint;
        if (from_corner < 0 || from_corner >= kKinectWidth) continue;
        if (pixel[1] < 0 || pixel[1] >= kKinectHeight) continue;
        const auto point = unproject(depth, Eigen::Vector2d(x, y), 0.001 * mm);
        // y was truncated to whole pixels: by half a pixel on average, which is also the distance
        // from corner to centre.
        if (point) points.push_back({*point, {from_corner - 0.5, static_cast<double>(pixel[1])}});
      }
    }
  }
  return points;
}

}  // namespace

SensorCalibration typical_kinect(const KinectZeroPlane& plane) {
  constexpr double kCx = 0.5 * (kKinectWidth - 1), kCy = 0.5 * (kKinectHeight - 1);
  const double depth_focal_px = depth_focal_length_px(plane);
  SensorCalibration typical;
  typical.depth = {kKinectWidth, kKinectHeight, depth_focal_px, depth_focal_px, kCx, kCy};
  typical.color = {kKinectWidth,          kKinectHeight, kNominalColorFocal_px,
                   kNominalColorFocal_px, kCx,           kCy};
  typical.color_from_depth.translation_m = {-0.001 * plane.color_from_ir_camera_mm, 0, 0};
  return typical;
}

Result<SensorCalibration> kinect_calibration(const KinectZeroPlane& plane,
                                             const KinectColorMap& map) {
  const Error unreadable{ErrorCode::kMalformed,
                         "the Kinect's memory does not hold a usable calibration"};
  const SensorCalibration start = typical_kinect(plane);
  if (!start.depth.check() || map.pixels.size() != kKinectWidth * kKinectHeight ||
      map.shift_of_mm.size() <= std::size_t{kDepths_mm.back()}) {
    return unreadable;
  }
  auto found = fit_color_camera(start, points_of(start.depth, map));
  if (!found) return unreadable;
  return found;
}

}  // namespace roomcast::source
