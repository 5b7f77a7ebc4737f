// SPDX-License-Identifier: Apache-2.0
// Lifts a pixel of the colour picture into space: to the point where the pixel's ray meets the
// surface seen by the depth camera. On surfaces seen at a grazing angle neighbouring readings
// differ by several millimetres of depth. The nearest reading, let alone the nearest of a few,
// would therefore put every feature of a floor too near. Metres; thread-safe (no state).
#pragma once

#include <optional>

#include <Eigen/Core>

#include "roomcast/alignment/view/color_picture.h"
#include "roomcast/alignment/view/depth_surface.h"

namespace roomcast::alignment {

/// Chosen on the development rooms (alignment_options.h).
struct LiftOptions {
  /// A larger difference of depth within 3 x 3 pixels is an edge: a constant, and a share of depth.
  float edge_step_m = 0.01F, edge_step_per_depth = 0.04F;
  int steps = 3;  // intersections of the ray with a tangent plane, one after another

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("edge_step_m", edge_step_m, Range{0, 1});
    visit("edge_step_per_depth", edge_step_per_depth, Range{0, 1});
    visit("steps", steps, Range{0, 100});
  }
  [[nodiscard]] Status check() const { return check_fields("LiftOptions", *this); }
};

/// The surface point seen at `pixel`, in the depth camera's frame; nothing without depth or at an
/// edge. `picture` must have been made with `surface`.
[[nodiscard]] std::optional<Eigen::Vector3f> lift(const ColorPicture& picture,
                                                  const DepthSurface& surface,
                                                  const Eigen::Vector2f& pixel,
                                                  const LiftOptions& options = {});

}  // namespace roomcast::alignment
