// SPDX-License-Identifier: Apache-2.0
// The colour picture used for feature detection: grey, undistorted, at most 1000 pixels wide, with
// the depth seen in every pixel. Metres; pixel centres at integer coordinates. Thread-safe
// (immutable after being made).
#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "roomcast/alignment/view/depth_surface.h"
#include "roomcast/core/image.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::alignment {

struct Pinhole {
  float fx = 1, fy = 1, cx = 0, cy = 0;
};

inline constexpr float kNoTint = 128;  // tint of a grey pixel

struct ColorPictureOptions {
  int max_width_px = 1000;  // wider pictures are halved and so on; by hand, for the time of SIFT
  int max_splat_px = 6;     // reach of one depth reading; by hand

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("max_width_px", max_width_px, Range{16, 10000});
    visit("max_splat_px", max_splat_px, Range{1, 100});
  }
  [[nodiscard]] Status check() const { return check_fields("ColorPictureOptions", *this); }
};

struct ColorPicture {
  Pinhole camera;
  Image<std::uint8_t> grey;
  Image<std::uint8_t> tint;  // (red - green) / 2 + kNoTint: the hue that grey lacks
  Image<float> z_m;          // depth along the colour camera's axis; 0 = no depth reading
  Eigen::Matrix3f color_from_depth_rotation;
  Eigen::Vector3f color_from_depth_m;
  float nearest_m = kNearestSurface_m;  // along the axis; nearer points have no pixel

  [[nodiscard]] Eigen::Vector3f in_color_frame(const Eigen::Vector3f& point_m) const {
    return color_from_depth_rotation * point_m + color_from_depth_m;
  }
  /// Pixel of a point in the colour camera's frame; the point must be in front of the camera.
  [[nodiscard]] Eigen::Vector2f pixel_of(const Eigen::Vector3f& color_point_m) const {
    return {camera.fx * color_point_m.x() / color_point_m.z() + camera.cx,
            camera.fy * color_point_m.y() / color_point_m.z() + camera.cy};
  }
};

/// Requires a checked calibration and a `color` of the size of `calibration.color`.
[[nodiscard]] ColorPicture color_picture(ColorView color, const SensorCalibration& calibration,
                                         const DepthSurface& surface,
                                         const ColorPictureOptions& options = {});

}  // namespace roomcast::alignment
