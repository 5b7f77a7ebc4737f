// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/feature/repeats.h"

#include <algorithm>

#include "roomcast/alignment/feature/descriptor_products.h"

namespace roomcast::alignment {
namespace {

constexpr float kElsewhere_m = 0.12F;
constexpr float kRepeats = 0.62F;  // descriptors nearer than this to a look-alike are repeats
constexpr float kMinWeight = 0.05F;
constexpr float kWorthless = 1.15F, kWorthRange = 0.4F;  // of match distance / look-alike distance
// A good match between two repeats does not show which of the repeats it is.
constexpr float kSurelyRepeats = 0.3F, kRepeatRange = 0.25F;  // of the look-alike distance

bool lie_apart(const Feature& one, const Feature& other) {
  return (one.point_m - other.point_m).squaredNorm() > kElsewhere_m * kElsewhere_m;
}

}  // namespace

void compute_ambiguity(FeatureSet& set) {
  const std::span<const Descriptor> all = set.descriptors;
  std::vector<std::int32_t> best(set.size()), products(kDescriptorTile);
  for (std::size_t first = 0; first < set.size(); first += kDescriptorTile) {
    const auto tile = all.subspan(first, std::min(kDescriptorTile, set.size() - first));
    for (std::size_t i = 0; i < set.size(); ++i) {
      descriptor_products(all[i], tile, products);
      for (std::size_t k = 0; k < tile.size(); ++k) {
        if (products[k] > best[i] && lie_apart(set.features[i], set.features[first + k]))
          best[i] = products[k];
      }
    }
  }
  for (std::size_t i = 0; i < set.size(); ++i) {
    set.features[i].nearest_similar_distance = descriptor_distance(best[i]);
  }
}

bool repeats(const Feature& feature) {
  return feature.nearest_similar_distance < kRepeats;
}

float uniqueness(float distance, float look_alike_a, float look_alike_b) {
  const float nearest_similar_distance = std::max(std::min(look_alike_a, look_alike_b), 1e-3F);
  const float by_ratio = (kWorthless - distance / nearest_similar_distance) / kWorthRange;
  const float by_itself = (nearest_similar_distance - kSurelyRepeats) / kRepeatRange;
  return std::clamp(std::min(by_ratio, by_itself), kMinWeight, 1.F);
}

}  // namespace roomcast::alignment
