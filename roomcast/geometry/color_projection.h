// SPDX-License-Identifier: Apache-2.0
// Where the surface point of each depth pixel lies in the colour picture (first half of the paper's
// Algorithm 1). Per pixel, color_from_depth * ray is worked out beforehand; a frame then costs one
// multiply-add per coordinate, a division and the lens polynomial, in float, four or more pixels at
// a time. Units: depth in millimetres, z in metres, picture positions in pixels. Single-threaded.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/geometry/camera_model.h"

namespace roomcast {

/// One row of depth pixels as the colour camera sees it.
struct ProjectedRow {
  float* u;  // position in the colour picture, pixels
  float* v;
  float* z_m;  // distance along the colour camera's axis; 0 without depth or outside its picture (u
               // = v = 0 then)
};

class ColorProjection {
 public:
  /// `calibration` must have been checked.
  explicit ColorProjection(const SensorCalibration& calibration);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

  /// Projects the depth pixels of row `y`; all rows hold `width()` pixels.
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
    float largest_r2;  // of any ray in the colour picture; beyond it the lens polynomial means
                       // nothing
  };
  static Lens lens_of(const SensorCalibration& calibration);

  int width_, height_;
  Lens lens_;
  std::vector<float> direction_x_, direction_y_,
      direction_z_;  // rotated rays, NaN where there is none
};

}  // namespace roomcast
