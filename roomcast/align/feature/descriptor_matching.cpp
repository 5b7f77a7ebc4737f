// SPDX-License-Identifier: Apache-2.0
#include "roomcast/align/feature/descriptor_matching.h"

#include <algorithm>
#include <array>
#include <limits>

#include "roomcast/align/feature/descriptor_products.h"

namespace roomcast::align {
namespace {

constexpr std::uint32_t kNobody = std::numeric_limits<std::uint32_t>::max();

/// The few best partners of one feature, best first.
struct Partners {
  std::array<std::int32_t, kPartners> dot;
  std::array<std::uint32_t, kPartners> index;

  Partners() {
    dot.fill(-1);
    index.fill(kNobody);
  }
  void offer(std::int32_t candidate_dot, std::uint32_t candidate) {
    if (candidate_dot <= dot.back()) return;
    std::size_t place = kPartners - 1;
    for (; place > 0 && candidate_dot > dot[place - 1]; --place) {
      dot[place] = dot[place - 1];
      index[place] = index[place - 1];
    }
    dot[place] = candidate_dot;
    index[place] = candidate;
  }
  [[nodiscard]] bool holds(std::uint32_t candidate) const {
    return std::find(index.begin(), index.end(), candidate) != index.end();
  }
};

}  // namespace

std::vector<DescriptorMatch> match_descriptors(std::span<const Descriptor> a,
                                               std::span<const Descriptor> b,
                                               float largest_distance) {
  std::vector<Partners> of_a(a.size()), of_b(b.size());
  std::vector<std::int32_t> products(b.size());
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    descriptor_products(a[i], b, products);
    for (std::uint32_t j = 0; j < b.size(); ++j) {
      of_a[i].offer(products[j], j);
      of_b[j].offer(products[j], i);
    }
  }
  std::vector<DescriptorMatch> matches;
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    std::array<std::uint32_t, kPartners> partners = of_a[i].index;
    std::sort(partners.begin(), partners.end());
    for (const std::uint32_t j : partners) {
      if (j == kNobody || !of_b[j].holds(i)) continue;
      const auto place = std::find(of_a[i].index.begin(), of_a[i].index.end(), j);
      const float distance =
          descriptor_distance(of_a[i].dot[static_cast<std::size_t>(place - of_a[i].index.begin())]);
      if (distance < largest_distance) matches.push_back({i, j, distance});
    }
  }
  return matches;
}

}  // namespace roomcast::align
