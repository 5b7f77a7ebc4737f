// SPDX-License-Identifier: Apache-2.0
// Features of shape alone, for views whose pictures have too little in common: fast point feature
// histograms (FPFH: Rusu, Blodow & Beetz, ICRA 2009) of thinned surface points. Points in the
// middle of a plane all look alike, so only points with varying normals around them are kept.
// Metres in the depth camera's frame. Thread-safe (no state).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "roomcast/alignment/view/depth_surface.h"

namespace roomcast::alignment {

inline constexpr std::size_t kShapeBins = 11;  // bins for each of three angles
using ShapeHistogram = std::array<float, 3 * kShapeBins>;

/// Chosen on the development rooms (alignment_options.h).
struct ShapeFeatureOptions {
  float thinning_m = 0.06F;  // one point for each cell of this size
  float radius_m = 0.25F;    // of a point's neighbourhood
  float min_bend = 0.15F;    // 1 - length of the mean normal around a point; less is flat
  std::size_t min_neighbours = 8;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("thinning_m", thinning_m, Range{0.005, 10});
    visit("radius_m", radius_m, Range{0.01, 10});
    visit("min_bend", min_bend, Range{0, 1});
    visit("min_neighbours", min_neighbours, Range{1, 1e6});
  }
  [[nodiscard]] Status check() const { return check_fields("ShapeFeatureOptions", *this); }
};

struct ShapeFeature {
  Eigen::Vector3f point_m;
  ShapeHistogram histogram;  // each third sums up to 1
};

/// The order depends on the samples only.
[[nodiscard]] std::vector<ShapeFeature> shape_features(std::span<const SurfacePoint> samples,
                                                       const ShapeFeatureOptions& options = {});

struct ShapeMatch {
  std::size_t a = 0, b = 0;
};

/// Mutual nearest neighbours, up to three per feature.
[[nodiscard]] std::vector<ShapeMatch> match_shapes(std::span<const ShapeFeature> a,
                                                   std::span<const ShapeFeature> b);

}  // namespace roomcast::alignment
