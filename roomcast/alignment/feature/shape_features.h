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

struct ShapeFeature {
  Eigen::Vector3f point_m;
  ShapeHistogram histogram;  // each third sums up to 1
};

/// The order depends on the samples only.
[[nodiscard]] std::vector<ShapeFeature> shape_features(std::span<const SurfacePoint> samples);

struct ShapeMatch {
  std::size_t a = 0, b = 0;
};

/// Mutual nearest neighbours, up to three per feature.
[[nodiscard]] std::vector<ShapeMatch> match_shapes(std::span<const ShapeFeature> a,
                                                   std::span<const ShapeFeature> b);

}  // namespace roomcast::alignment
