// SPDX-License-Identifier: Apache-2.0
// For tests: sensors that look straight at a printed wall, so that all that they see follows by
// hand. Metres; x and y on the wall are those of the frame in which the sensors stand side by side.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "roomcast/alignment/feature/room_fixture.h"
#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/alignment/view/flat_normals.h"

namespace roomcast::alignment {

/// Depth 200 x 160, colour twice as fine, at the same place and without distortion.
inline SensorCalibration wall_calibration() {
  SensorCalibration calibration;
  calibration.depth = {200, 160, 145, 145, 99.5, 79.5};
  calibration.color = {400, 320, 290, 290, 199.5, 159.5};
  return calibration;
}

inline DepthImage wall_depth(double z_m) {
  return {200, 160, static_cast<std::uint16_t>(std::lround(1000 * z_m))};
}

inline DepthSurface wall_surface(const DepthImage& depth_mm) {
  return depth_surface(depth_mm, wall_calibration().depth);
}

/// A wall `z_m` ahead.
struct PrintedWall {
  double z_m = 2;
  std::uint32_t looks = 1;  // seed of its print
  double period_m = 0;      // above 0: the print repeats along x
  double contrast = 1;      // of its print; below 0: the negative

  /// A middle grey and random greys in cells of 6 cm.
  [[nodiscard]] std::uint8_t grey_at(double x_m, double y_m) const {
    constexpr double kCell_m = 0.06;
    if (period_m > 0) x_m -= period_m * std::floor(x_m / period_m);
    const auto cell = [](double m) { return static_cast<int>(std::floor(m / kCell_m + 1e-4)); };
    const double random = pattern_noise(looks, cell(x_m), cell(y_m), 0) - 0.5;
    return static_cast<std::uint8_t>(std::lround(128 + 200 * contrast * random));
  }
};

/// The wall's colours, seen from `x_m`.
inline ColorImage wall_color(const PrintedWall& wall, double x_m) {
  const CameraIntrinsics camera = wall_calibration().color;
  ColorImage color(camera.width, camera.height);
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const std::uint8_t grey = wall.grey_at(x_m + (u - camera.cx) / camera.fx * wall.z_m,
                                             (v - camera.cy) / camera.fy * wall.z_m);
      color.at(u, v) = {grey, grey, grey};
    }
  }
  return color;
}

/// A view of these pictures without features.
inline SensorView featureless_view(const std::string& name, const DepthImage& depth_mm,
                                   const ColorImage& color) {
  DepthSurface surface = wall_surface(depth_mm);
  ColorPicture picture = color_picture(color, wall_calibration(), surface);
  Texture texture = make_texture(surface, picture);
  std::vector<Plane> planes = find_planes(surface.samples);
  flatten_normals(planes, surface);
  return {
      name, std::move(surface), std::move(picture), std::move(texture), std::move(planes), {}, {},
      {}};
}

inline SensorView wall_view(const PrintedWall& wall, double x_m, const std::string& name = "s") {
  return featureless_view(name, wall_depth(wall.z_m), wall_color(wall, x_m));
}

}  // namespace roomcast::alignment
