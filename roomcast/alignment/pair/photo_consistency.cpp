// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/photo_consistency.h"

#include <algorithm>

#include "roomcast/alignment/pair/reprojected_views.h"

namespace roomcast::alignment {
namespace {

constexpr int kReach = 5;           // windows of 11 x 11 grid points
constexpr double kMinFilled = 0.5;  // of a window
constexpr double kMinContrast = 4;  // grey levels (standard deviation) in either view
constexpr double kFullContrast = 25;
constexpr std::size_t kMinPoints = 50;

struct Agreement {
  double weight = 0, correlation = 0;  // of one window; the correlation is multiplied by the weight
};

Agreement agreement(const ReprojectionSums& sums) {
  if (sums[0] < kMinFilled * (2 * kReach + 1) * (2 * kReach + 1)) return {};
  const WindowContrast contrast(sums);
  const double higher = std::max(contrast.mine, contrast.theirs);
  if (higher < kMinContrast) return {};
  const double weight = std::min(higher, kFullContrast) / kFullContrast;
  return {weight, weight * contrast.correlation()};
}

Agreement agreement_seen_from(const CorrectedView& from, const CorrectedView& other,
                              const RigidTransform& other_from_view) {
  const ReprojectedViews common = reprojected_views(from, other, other_from_view);
  if (common.count < kMinPoints) return {};
  const WindowSums sums(common);
  Agreement total;
  for (const TexturedPoint& point : from.view().texture.points) {
    if (!common.known[common.place(point.x, point.y)]) continue;
    const Agreement here = agreement(sums.around(point.x, point.y, kReach));
    total.weight += here.weight;
    total.correlation += here.correlation;
  }
  const auto points = static_cast<double>(from.view().texture.points.size());
  return {total.weight / points, total.correlation / points};
}

}  // namespace

PhotoConsistency check_photo_consistency(const SensorView& a, const SensorView& b,
                                         const PairState& state) {
  const CorrectedView seen_a(a, state.a), seen_b(b, state.b);
  const Agreement from_a = agreement_seen_from(seen_a, seen_b, state.a_from_b.inverse());
  const Agreement from_b = agreement_seen_from(seen_b, seen_a, state.a_from_b);
  const double weight = from_a.weight + from_b.weight;
  if (!(weight > 0)) return {};
  return {weight / 2, (from_a.correlation + from_b.correlation) / weight};
}

}  // namespace roomcast::alignment
