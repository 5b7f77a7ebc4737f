// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/feature/feature_set.h"

#include <algorithm>
#include <cmath>

namespace roomcast::alignment {

Descriptor root_descriptor(std::span<const float, kDescriptorSize> histogram) {
  float sum = 0;
  for (const float bin : histogram) sum += std::max(bin, 0.F);
  const float scale = sum > 0 ? 1 / sum : 0;
  Descriptor descriptor{};
  for (std::size_t i = 0; i < kDescriptorSize; ++i) {
    const float root = std::sqrt(scale * std::max(histogram[i], 0.F));
    descriptor[i] = static_cast<std::int16_t>(std::lround(kDescriptorLength * root));
  }
  return descriptor;
}

float descriptor_distance(std::int32_t dot) {
  constexpr float kLargest = static_cast<float>(kDescriptorLength * kDescriptorLength);
  return std::sqrt(std::max(0.F, 2 - 2 * static_cast<float>(dot) / kLargest));
}

}  // namespace roomcast::alignment
