// SPDX-License-Identifier: Apache-2.0
// Residuals summed per patch of the picture. Depth errors are smooth over a picture (multipath,
// lens, the unit's own bias), so the residuals of a patch are correlated: ten thousand of them are
// a single observation. The distance of their sums from zero shows how far off a pose may be,
// without a model of the error (cluster-robust covariance: Liang & Zeger, Biometrika 1986). Metres,
// radians, pixels. Single-threaded.
#pragma once

#include <map>

#include <Eigen/Core>

#include "roomcast/alignment/pair/pair_equations.h"

namespace roomcast::alignment {

/// Sums over one patch of a sensor's picture.
struct PatchScore {
  PairVector score = PairVector::Zero();  // sum of w J^T r
  double weight = 0, residual = 0;        // of surface terms: sums of w and w r
};

/// By patch.
using PatchScores = std::map<int, PatchScore>;

struct PatchOptions {
  double tangent = 0.35;  // width and height of a patch: 20 degrees in the middle; by hand

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("tangent", tangent, Range{0.01, 10});
  }
  [[nodiscard]] Status check() const { return check_fields("PatchOptions", *this); }
};

[[nodiscard]] int patch_of(const Eigen::Vector3d& point_m, const PatchOptions& options = {});

/// Scores of a pair, by the patches of either sensor's picture.
struct PairScores {
  PatchScores of_a, of_b;
  PatchOptions patches = {};

  /// Adds a term of `PairEquations` about a point in both sensors' frames.
  void add(const Eigen::Vector3d& a_m, const Eigen::Vector3d& b_m, const PairVector& score);
  /// Adds a surface term, with its residual in metres and its weight.
  void add_surface(const Eigen::Vector3d& a_m, const Eigen::Vector3d& b_m, const PairVector& score,
                   double residual_m, double weight);
};

}  // namespace roomcast::alignment
