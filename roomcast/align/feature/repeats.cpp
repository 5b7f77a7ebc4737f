// SPDX-License-Identifier: Apache-2.0
#include "roomcast/align/feature/repeats.h"

#include <algorithm>

#include "roomcast/align/feature/descriptor_products.h"

namespace roomcast::align {
namespace {

constexpr float kElsewhere_m = 0.12F;
constexpr float kRepeats = 0.62F;  // descriptors nearer than this to a look-alike are repeats
constexpr float kLeastWeight = 0.05F;
constexpr float kWorthless = 1.15F, kWorthRange = 0.4F;  // of the ratio to the nearest look-alike
// However well two repeats match each other, they do not say which of the repeats is meant.
constexpr float kSurelyRepeats = 0.3F, kRepeatRange = 0.25F;  // of the look-alike's distance

}  // namespace

void find_look_alikes(FeatureSet& set) {
  std::vector<std::int32_t> products(set.size());
  for (std::size_t i = 0; i < set.size(); ++i) {
    descriptor_products(set.descriptors[i], set.descriptors, products);
    std::int32_t best = 0;
    for (std::size_t j = 0; j < set.size(); ++j) {
      if (products[j] <= best) continue;
      const float apart = (set.features[i].point_m - set.features[j].point_m).squaredNorm();
      if (apart > kElsewhere_m * kElsewhere_m) best = products[j];
    }
    set.features[i].look_alike = descriptor_distance(best);
  }
}

std::vector<Descriptor> repeating_descriptors(const FeatureSet& set) {
  std::vector<Descriptor> repeating;
  for (std::size_t i = 0; i < set.size(); ++i) {
    if (set.features[i].look_alike < kRepeats) repeating.push_back(set.descriptors[i]);
  }
  return repeating;
}

std::vector<float> look_alikes_in_rig(
    const FeatureSet& set, std::span<const std::vector<Descriptor>* const> repeating_elsewhere) {
  std::vector<float> look_alikes;
  std::vector<std::int32_t> products;
  for (std::size_t i = 0; i < set.size(); ++i) {
    float nearest = set.features[i].look_alike;
    for (const std::vector<Descriptor>* repeating : repeating_elsewhere) {
      if (repeating->empty()) continue;
      products.resize(repeating->size());
      descriptor_products(set.descriptors[i], *repeating, products);
      nearest = std::min(nearest,
                         descriptor_distance(*std::max_element(products.begin(), products.end())));
    }
    look_alikes.push_back(nearest);
  }
  return look_alikes;
}

float uniqueness(float distance, float look_alike_a, float look_alike_b) {
  const float look_alike = std::max(std::min(look_alike_a, look_alike_b), 1e-3F);
  const float by_ratio = (kWorthless - distance / look_alike) / kWorthRange;
  const float by_itself = (look_alike - kSurelyRepeats) / kRepeatRange;
  return std::clamp(std::min(by_ratio, by_itself), kLeastWeight, 1.F);
}

}  // namespace roomcast::align
