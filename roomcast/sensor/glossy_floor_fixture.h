// SPDX-License-Identifier: Apache-2.0
// Test fixture: a level sensor 1.2 m above a brown floor, a white wall 4 m ahead, and a black box
// on the floor. The floor returns light only up to 2 m; the colour camera is the depth camera.
#pragma once

#include <algorithm>
#include <cmath>

#include "roomcast/core/image.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::sensor {

struct GlossyFloor {
  static constexpr int kWidth = 320, kHeight = 240;
  static constexpr float kAbove_m = 1.2F, kWall_m = 4, kGloss_m = 2, kBox_m = 2.6F;
  static constexpr Rgb8 kFloor{120, 80, 40}, kWall{230, 230, 225}, kBox{10, 10, 12},
      kSky{60, 120, 220};
  bool has_box = false;
  bool box_returns_light = false;
  bool has_window = false;  // in the wall, blue, without readings

  [[nodiscard]] CameraIntrinsics lens() const {
    CameraIntrinsics lens;
    lens.width = kWidth;
    lens.height = kHeight;
    lens.fx = lens.fy = 160;
    lens.cx = 159.5;
    lens.cy = 119.5;
    return lens;
  }
  [[nodiscard]] SensorCalibration calibration() const {
    SensorCalibration calibration;
    calibration.depth = calibration.color = lens();
    return calibration;
  }

  [[nodiscard]] bool on_box(int x, int y) const {
    return has_box && x >= 180 && x < 250 && y >= 140 && y < 194;
  }
  [[nodiscard]] bool in_window(int x, int y) const {
    return has_window && x >= 60 && x < 120 && y >= 30 && y < 60;
  }
  /// The floor's depth at a row; 0 above the horizon or behind the wall.
  [[nodiscard]] float floor_m(int y) const {
    const float down = (static_cast<float>(y) - 119.5F) / 160;
    return down * kWall_m > kAbove_m ? kAbove_m / down : 0.0F;
  }
  [[nodiscard]] float true_m(int x, int y) const {
    if (on_box(x, y)) return kBox_m;
    return floor_m(y) > 0.0F ? floor_m(y) : kWall_m;
  }

  [[nodiscard]] DepthImage whole_depth_mm() const {
    DepthImage depth_mm(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x)
        depth_mm.at(x, y) = static_cast<std::uint16_t>(std::lround(1000 * true_m(x, y)));
    }
    return depth_mm;
  }
  /// As the sensor reads it.
  [[nodiscard]] DepthImage depth_mm() const {
    DepthImage depth_mm = whole_depth_mm();
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const bool is_lost = on_box(x, y) ? !box_returns_light : floor_m(y) > kGloss_m;
        if (is_lost || in_window(x, y)) depth_mm.at(x, y) = 0;
      }
    }
    return depth_mm;
  }
  [[nodiscard]] ColorImage color() const {
    ColorImage color(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x)
        color.at(x, y) = on_box(x, y)        ? kBox
                         : in_window(x, y)   ? kSky
                         : floor_m(y) > 0.0F ? kFloor
                                             : kWall;
    }
    return color;
  }
};

}  // namespace roomcast::sensor
