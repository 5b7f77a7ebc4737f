// SPDX-License-Identifier: Apache-2.0
// The large planes of a view (RANSAC, Fischler & Bolles 1981, with hypotheses from single points
// with normals, drawn in a fixed order). Metres in the depth camera's frame. Thread-safe (no
// state).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "roomcast/alignment/view/depth_surface.h"

namespace roomcast::alignment {

struct Plane {
  Eigen::Vector3f normal;                 // unit, towards the camera
  float offset_m = 0;                     // normal . point + offset == 0
  std::vector<Eigen::Vector3f> points_m;  // samples on the plane

  [[nodiscard]] float height_m(const Eigen::Vector3f& point_m) const {
    return normal.dot(point_m) + offset_m;
  }
};

/// Chosen on the development rooms (alignment_options.h), unless noted.
struct PlaneOptions {
  std::size_t max_planes = 8;         // a view's walls, floor, table tops, doors
  float min_share = 0.03F;            // of the samples; smaller planes are dropped
  std::size_t min_points = 50;        // samples on a plane; by hand
  float thickness_m = 0.025F;         // largest distance of a sample from its plane
  float min_cosine = 0.85F;           // between a sample's normal and its plane's
  int trials = 60;                    // planes through single samples
  std::size_t tested_samples = 2000;  // about so many score a trial
  int refinements = 3;                // least-squares fits of the best trial

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("max_planes", max_planes, Range{1, 1000});
    visit("min_share", min_share, Range{0, 1});
    visit("min_points", min_points, Range{3, 1e6});
    visit("thickness_m", thickness_m, Range{1e-4, 1});
    visit("min_cosine", min_cosine, Range{-1, 1});
    visit("trials", trials, Range{1, 1e5});
    visit("tested_samples", tested_samples, Range{1, 1e6});
    visit("refinements", refinements, Range{0, 100});
  }
  [[nodiscard]] Status check() const { return check_fields("PlaneOptions", *this); }
};

/// In the order found, each the largest found among the remaining samples. Order and planes depend
/// on the samples only.
[[nodiscard]] std::vector<Plane> find_planes(std::span<const SurfacePoint> samples,
                                             const PlaneOptions& options = {});

}  // namespace roomcast::alignment
