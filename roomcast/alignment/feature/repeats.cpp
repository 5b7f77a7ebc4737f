// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/feature/repeats.h"

#include <algorithm>

#include "roomcast/alignment/feature/descriptor_products.h"

namespace roomcast::alignment {
namespace {

bool lie_apart(const Feature& one, const Feature& other, float apart_m) {
  return (one.point_m - other.point_m).squaredNorm() > apart_m * apart_m;
}

}  // namespace

void compute_ambiguity(FeatureSet& set, const RepeatOptions& options) {
  const float apart_m = options.apart_m;
  const std::span<const Descriptor> all = set.descriptors;
  std::vector<std::int32_t> best(set.size()), products(kDescriptorTile);
  for (std::size_t first = 0; first < set.size(); first += kDescriptorTile) {
    const auto tile = all.subspan(first, std::min(kDescriptorTile, set.size() - first));
    for (std::size_t i = 0; i < set.size(); ++i) {
      descriptor_products(all[i], tile, products);
      for (std::size_t k = 0; k < tile.size(); ++k) {
        if (products[k] > best[i] && lie_apart(set.features[i], set.features[first + k], apart_m))
          best[i] = products[k];
      }
    }
  }
  for (std::size_t i = 0; i < set.size(); ++i) {
    set.features[i].nearest_similar_distance = descriptor_distance(best[i]);
  }
}

bool repeats(const Feature& feature, const RepeatOptions& options) {
  return feature.nearest_similar_distance < options.repeat_distance;
}

float uniqueness(float distance, float look_alike_a, float look_alike_b,
                 const RepeatOptions& options) {
  const float nearest_similar_distance = std::max(std::min(look_alike_a, look_alike_b), 1e-3F);
  const float by_ratio =
      (options.worthless_ratio - distance / nearest_similar_distance) / options.ratio_range;
  const float by_itself =
      (nearest_similar_distance - options.surely_repeats) / options.repeat_range;
  return std::clamp(std::min(by_ratio, by_itself), options.min_weight, 1.F);
}

}  // namespace roomcast::alignment
