// SPDX-License-Identifier: Apache-2.0
// Round things that move (heads, balls, bags): spheres fitted to the surface of what moves, at
// single instants. Two sensors that look at a thing from opposite sides share none of its surface,
// but both know its centre. Metres, in the depth camera's frame. Thread-safe (no state).
#pragma once

#include <span>
#include <vector>

#include "roomcast/alignment/pair/moving_surface.h"

namespace roomcast::alignment {

/// By hand, from the sizes of heads and of what people carry; fits are by Gauss-Newton from points
/// and normals, as many rejected as not.
struct RoundThingOptions {
  float min_radius_m = 0.07F, max_radius_m = 0.4F;
  std::size_t starts = 150;  // points of an instant from which fits begin
  double reach_m = 0.04;     // from the sphere: points that take part
  double sigma_m = 0.012;    // of points, for their weights
  double max_rms_m = 0.012;  // of points that take part
  double min_cosine = 0.7;   // between a point's normal and the sphere's
  int min_points = 14;
  double min_share = 0.75;   // of all points within reach of the sphere's inside that fit it
  double min_cap_rad = 0.9;  // half the angle of the part that is seen: flat things are none

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("min_radius_m", min_radius_m, Range{0.01, 10});
    visit("max_radius_m", max_radius_m, Range{0.01, 10});
    visit("starts", starts, Range{1, 1e5});
    visit("reach_m", reach_m, Range{0.001, 1});
    visit("sigma_m", sigma_m, Range{1e-4, 1});
    visit("max_rms_m", max_rms_m, Range{1e-4, 1});
    visit("min_cosine", min_cosine, Range{-1, 1});
    visit("min_points", min_points, Range{4, 1e5});
    visit("min_share", min_share, Range{0, 1});
    visit("min_cap_rad", min_cap_rad, Range{0, 3.15});
  }
  [[nodiscard]] Status check() const { return check_fields("RoundThingOptions", *this); }
};

struct RoundThing {
  double time_s = 0;
  Eigen::Vector3d center_m;
  double radius_m = 0;
};

/// Of all instants, those with most surface first in each; none intersects another.
[[nodiscard]] std::vector<RoundThing> round_things(std::span<const MovingSurface> surfaces,
                                                   const RoundThingOptions& options = {});

}  // namespace roomcast::alignment
