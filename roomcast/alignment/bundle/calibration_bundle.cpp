// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/bundle/calibration_bundle.h"

#include <cmath>
#include <cstdint>
#include <utility>

namespace roomcast::alignment {
namespace {

Error invalid(const CalibrationBundle& bundle, const std::string& what) {
  return {ErrorCode::kInvalidArgument, "sensor " + bundle.name + " " + what};
}

std::string size_text(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

double share_with_depth(const DepthImage& depth_mm) {
  std::size_t readings = 0;
  const std::size_t count = depth_mm.view().pixel_count();
  for (std::size_t i = 0; i < count; ++i) readings += depth_mm.data()[i] != 0;
  return static_cast<double>(readings) / static_cast<double>(count);
}

double contrast(const ColorImage& color) {
  double sum = 0, sum_of_squares = 0;
  const std::size_t count = color.view().pixel_count();
  for (std::size_t i = 0; i < count; ++i) {
    const Rgb8 pixel = color.data()[i];
    const double grey = (pixel.r + 2.0 * pixel.g + pixel.b) / 4;
    sum += grey;
    sum_of_squares += grey * grey;
  }
  const double mean = sum / static_cast<double>(count);
  return std::sqrt(std::max(0.0, sum_of_squares / static_cast<double>(count) - mean * mean));
}

Status check_cameras(const CalibrationBundle& bundle) {
  const SensorCalibration& calibration = bundle.calibration;
  const std::pair<const char*, const CameraIntrinsics*> cameras[] = {
      {"depth", &calibration.depth}, {"colour", &calibration.color}};
  for (const auto& [name, camera] : cameras) {
    if (const Status status = camera->check(); !status) {
      return invalid(bundle, std::string("has a ") + name +
                                 " camera that is invalid: " + status.error().message);
    }
  }
  const RigidTransform& color_from_depth = calibration.color_from_depth;
  const auto again = transform_from_row_major(row_major_from_transform(color_from_depth));
  if (!again) return invalid(bundle, "has a color_from_depth that is no rigid transform");
  return {};
}

Status check_sizes(const CalibrationBundle& bundle) {
  const CameraIntrinsics& depth = bundle.calibration.depth;
  const CameraIntrinsics& color = bundle.calibration.color;
  if (bundle.depth_mm.width() != depth.width || bundle.depth_mm.height() != depth.height) {
    return invalid(bundle,
                   "gave depth of " + size_text(bundle.depth_mm.width(), bundle.depth_mm.height()) +
                       " pixels, but its camera has " + size_text(depth.width, depth.height));
  }
  if (bundle.color.empty()) return invalid(bundle, "gave no colour picture; alignment needs one");
  if (bundle.color.width() != color.width || bundle.color.height() != color.height) {
    return invalid(bundle,
                   "gave colour of " + size_text(bundle.color.width(), bundle.color.height()) +
                       " pixels, but its camera has " + size_text(color.width, color.height));
  }
  if (!bundle.moving.empty() &&
      (bundle.moving.width() != depth.width || bundle.moving.height() != depth.height)) {
    return invalid(bundle, "gave a mask of another size than its depth");
  }
  return {};
}

}  // namespace

Status check(const CalibrationBundle& bundle, const BundleCheckOptions& options) {
  if (const Status status = check_cameras(bundle); !status) return status;
  if (const Status status = check_sizes(bundle); !status) return status;
  if (bundle.up && !(std::abs(bundle.up->norm() - 1) < 1e-3)) {
    return invalid(bundle, "gave a direction of gravity that is no unit vector");
  }
  if (share_with_depth(bundle.depth_mm) < options.min_depth_share) {
    return invalid(bundle, "sees almost no depth; check that nothing covers it or is too close");
  }
  if (contrast(bundle.color) < options.min_contrast) {
    return invalid(bundle,
                   "gave a colour picture without contrast; uncover its lens or turn on the light");
  }
  return {};
}

}  // namespace roomcast::alignment
