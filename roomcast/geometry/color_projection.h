// SPDX-License-Identifier: Apache-2.0
// Projects the surface point of each depth pixel into the colour picture (first half of the paper's
// Algorithm 1). color_from_depth * ray is precomputed per pixel; a frame then costs one
// multiply-add per coordinate, a division and the lens polynomial, in float, four or more pixels at
// a time. Units: depth in millimetres, z in metres, picture positions in pixels. Single-threaded.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/geometry/camera_model.h"

namespace roomcast {

/// One row of depth pixels projected into the colour camera.
struct ProjectedRow {
  float* u;  // position in the colour picture, pixels
  float* v;
  float* z_m;  // z in the colour camera's frame; 0 without depth or outside its picture (then u = v
               // = 0)
};

class ColorProjection {
 public:
  /// `calibration` must have passed its checks.
  explicit ColorProjection(const SensorCalibration& calibration);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

  /// Projects the depth pixels of row `y`; all rows have `width()` pixels.
  void project_row(const std::uint16_t* depth_mm, int y, const ProjectedRow& out) const;

  /// Distances in colour pixels between the projections of neighbouring depth pixels, at infinity.
  struct Spacing {
    float typical = 1;  // in the middle of the common field of view
    float largest = 1;  // anywhere in it
  };
  [[nodiscard]] Spacing spacing() const;

 private:
  /// The colour camera in single precision.
  struct Lens {
    float fx, fy, cx, cy, k1, k2, k3, p1, p2;
    float tx_m, ty_m, tz_m;  // of color_from_depth
    float largest_u, largest_v;
    float largest_r2;  // of any ray in the colour picture; the lens polynomial is invalid beyond it
  };
  static Lens lens_of(const SensorCalibration& calibration);
  static void project_pixels(const Lens& lens, int width, const std::uint16_t* __restrict depth_mm,
                             const float* __restrict ax, const float* __restrict ay,
                             const float* __restrict az, float* __restrict u_px,
                             float* __restrict v_px, float* __restrict z_m);

  int width_, height_;
  Lens lens_;
  std::vector<float> direction_x_, direction_y_,
      direction_z_;  // rotated rays, NaN where there is none
};

}  // namespace roomcast
