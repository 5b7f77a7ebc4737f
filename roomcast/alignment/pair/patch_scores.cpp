// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/patch_scores.h"

#include <algorithm>
#include <cmath>

namespace roomcast::alignment {
namespace {

constexpr int kMaxAside = 8;  // patches on either side of the axis

int along(double tangent, const PatchOptions& options) {
  const double patch = std::floor(tangent / options.tangent);
  return static_cast<int>(std::clamp<double>(patch, -kMaxAside, kMaxAside - 1)) + kMaxAside;
}

}  // namespace

int patch_of(const Eigen::Vector3d& point_m, const PatchOptions& options) {
  return along(point_m.y() / point_m.z(), options) * 2 * kMaxAside +
         along(point_m.x() / point_m.z(), options);
}

void PairScores::add(const Eigen::Vector3d& a_m, const Eigen::Vector3d& b_m,
                     const PairVector& score) {
  of_a[patch_of(a_m, patches)].score += score;
  of_b[patch_of(b_m, patches)].score += score;
}

void PairScores::add_surface(const Eigen::Vector3d& a_m, const Eigen::Vector3d& b_m,
                             const PairVector& score, double residual_m, double weight) {
  for (PatchScore* patch : {&of_a[patch_of(a_m, patches)], &of_b[patch_of(b_m, patches)]}) {
    patch->score += score;
    patch->weight += weight;
    patch->residual += weight * residual_m;
  }
}

}  // namespace roomcast::alignment
