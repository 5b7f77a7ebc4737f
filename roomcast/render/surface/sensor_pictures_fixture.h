// SPDX-License-Identifier: Apache-2.0
// Fixtures for tests: small sensors and synthetic pictures.
#pragma once

#include <algorithm>
#include <cstdint>

#include "roomcast/core/image.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::render {

inline constexpr Rgb8 kRed = {220, 30, 40}, kGreen = {20, 200, 60}, kBlue = {30, 60, 210},
                      kYellow = {230, 210, 20};

struct SensorPictures {
  DepthImage depth_mm;
  ColorImage color;
  MaskImage seen;
};

/// An ideal pinhole with its principal point in the middle of the picture.
inline CameraIntrinsics pinhole(int width, int height, double focal_px) {
  CameraIntrinsics camera;
  camera.width = width;
  camera.height = height;
  camera.fx = camera.fy = focal_px;
  camera.cx = 0.5 * (width - 1);
  camera.cy = 0.5 * (height - 1);
  return camera;
}

/// A wall at right angles to the optical axis, seen completely by the colour camera.
inline SensorPictures wall(const CameraIntrinsics& camera, std::uint16_t depth_mm, Rgb8 color) {
  return {DepthImage(camera.width, camera.height, depth_mm),
          ColorImage(camera.width, camera.height, color),
          MaskImage(camera.width, camera.height, 255)};
}

/// Fills the pixels x0 <= x < x1, y0 <= y < y1.
template <class T>
void fill_box(Image<T>& image, int x0, int y0, int x1, int y1, T value) {
  for (int y = y0; y < y1; ++y) {
    std::fill(image.view().row(y) + x0, image.view().row(y) + x1, value);
  }
}

}  // namespace roomcast::render
