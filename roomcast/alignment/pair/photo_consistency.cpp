// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/photo_consistency.h"

#include <algorithm>

namespace roomcast::alignment {
namespace {

struct Agreement {
  double weight = 0, correlation = 0;  // of one window; the correlation is multiplied by the weight
};

Agreement agreement(const ReprojectionSums& sums, const PhotoConsistencyOptions& options,
                    const ReprojectionOptions& reprojection) {
  const int side = 2 * options.reach + 1;
  if (sums[0] < options.min_filled * side * side) return {};
  const WindowContrast contrast(sums);
  const double higher = std::max(contrast.mine, contrast.theirs);
  if (higher < options.min_contrast) return {};
  const double weight = std::min(higher, options.full_contrast) / options.full_contrast;
  return {weight, weight * contrast.correlation(reprojection)};
}

Agreement agreement_seen_from(const CorrectedView& from, const CorrectedView& other,
                              const RigidTransform& other_from_view,
                              const PhotoConsistencyOptions& options,
                              const ReprojectionOptions& reprojection) {
  const ReprojectedViews common = reprojected_views(from, other, other_from_view, reprojection);
  if (common.count < options.min_points) return {};
  const WindowSums sums(common);
  Agreement total;
  for (const TexturedPoint& point : from.view().texture.points) {
    if (!common.known[common.place(point.x, point.y)]) continue;
    const Agreement here =
        agreement(sums.around(point.x, point.y, options.reach), options, reprojection);
    total.weight += here.weight;
    total.correlation += here.correlation;
  }
  const auto points = static_cast<double>(from.view().texture.points.size());
  return {total.weight / points, total.correlation / points};
}

}  // namespace

PhotoConsistency check_photo_consistency(const SensorView& a, const SensorView& b,
                                         const PairState& state,
                                         const PhotoConsistencyOptions& options,
                                         const ReprojectionOptions& reprojection) {
  const CorrectedView seen_a(a, state.a), seen_b(b, state.b);
  const Agreement from_a =
      agreement_seen_from(seen_a, seen_b, state.a_from_b.inverse(), options, reprojection);
  const Agreement from_b =
      agreement_seen_from(seen_b, seen_a, state.a_from_b, options, reprojection);
  const double weight = from_a.weight + from_b.weight;
  if (!(weight > 0)) return {};
  return {weight / 2, (from_a.correlation + from_b.correlation) / weight};
}

}  // namespace roomcast::alignment
