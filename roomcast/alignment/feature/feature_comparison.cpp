// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/feature/feature_comparison.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <tuple>

#include "roomcast/alignment/feature/descriptor_products.h"
#include "roomcast/core/vector_loop.h"

namespace roomcast::alignment {
namespace {

constexpr std::uint32_t kNoPartner = std::numeric_limits<std::uint32_t>::max();

/// The kPartners best partners of one feature, best first.
struct Partners {
  std::array<std::int32_t, kPartners> dot;
  std::array<std::uint32_t, kPartners> index;

  /// A feature whose product is `too_small_dot` or less is no partner.
  explicit Partners(std::int32_t too_small_dot) {
    dot.fill(too_small_dot);
    index.fill(kNoPartner);
  }
  /// Inserts a candidate; its product must exceed the last partner's.
  void take(std::int32_t candidate_dot, std::uint32_t candidate) {
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

/// Mask for dot products: all ones for a feature that repeats, else 0.
std::vector<std::int32_t> repeat_mask(const FeatureSet& set, const RepeatOptions& options) {
  std::vector<std::int32_t> mask;
  for (const Feature& feature : set.features) mask.push_back(repeats(feature, options) ? -1 : 0);
  return mask;
}

/// Summary of one row of products.
struct Row {
  std::int32_t has_partners = 0, nearest_repeat = 0;
};

/// Summarises a row. `last_a`, `last_b`: the product of the last partner of the row's feature and
/// of each feature of the tile.
ROOMCAST_VECTOR_CLONES Row summarise_row(std::span<const std::int32_t> products,
                                         std::int32_t last_a, const std::int32_t* last_b,
                                         const std::int32_t* repeats_b, std::int32_t repeats_a,
                                         std::int32_t* repeat_of_b) {
  Row row;
  for (std::size_t k = 0; k < products.size(); ++k) {
    row.has_partners |= products[k] > std::min(last_a, last_b[k]) ? 1 : 0;
    row.nearest_repeat = std::max(row.nearest_repeat, products[k] & repeats_b[k]);
    repeat_of_b[k] = std::max(repeat_of_b[k], products[k] & repeats_a);
  }
  return row;
}

/// Compares two sets row by row: one feature of a with a tile of b's features.
class Comparison {
 public:
  Comparison(const FeatureSet& a, const FeatureSet& b, float largest_distance,
             const RepeatOptions& repeating)
      : a_(a),
        b_(b),
        repeats_a_(repeat_mask(a, repeating)),
        repeats_b_(repeat_mask(b, repeating)),
        of_a_(a.size(), Partners(too_small_dot(largest_distance))),
        of_b_(b.size(), Partners(too_small_dot(largest_distance))),
        last_b_(b.size(), too_small_dot(largest_distance)),
        repeat_of_a_(a.size()),
        repeat_of_b_(b.size()),
        products_(kDescriptorTile) {
    for (std::size_t first = 0; first < b.size(); first += kDescriptorTile) {
      const std::size_t count = std::min(kDescriptorTile, b.size() - first);
      for (std::size_t i = 0; i < a.size(); ++i) compare_row(i, first, count);
    }
  }

  [[nodiscard]] FeatureComparison result(float largest_distance) const {
    return {matches(largest_distance), distances(repeat_of_a_), distances(repeat_of_b_)};
  }

 private:
  void compare_row(std::size_t i, std::size_t first, std::size_t count) {
    const std::span<std::int32_t> products(products_.data(), count);
    descriptor_products(a_.descriptors[i], std::span(b_.descriptors).subspan(first, count),
                        products);
    const Row row =
        summarise_row(products, of_a_[i].dot.back(), last_b_.data() + first,
                      repeats_b_.data() + first, repeats_a_[i], repeat_of_b_.data() + first);
    repeat_of_a_[i] = std::max(repeat_of_a_[i], row.nearest_repeat);
    if (row.has_partners != 0) take_partners(i, first, products);
  }

  void take_partners(std::size_t i, std::size_t first, std::span<const std::int32_t> products) {
    for (std::size_t k = 0; k < products.size(); ++k) {
      const std::size_t j = first + k;
      if (products[k] > of_a_[i].dot.back())
        of_a_[i].take(products[k], static_cast<std::uint32_t>(j));
      if (products[k] > last_b_[j]) {
        of_b_[j].take(products[k], static_cast<std::uint32_t>(i));
        last_b_[j] = of_b_[j].dot.back();
      }
    }
  }

  [[nodiscard]] std::vector<DescriptorMatch> matches(float largest_distance) const {
    std::vector<DescriptorMatch> matches;
    for (std::uint32_t i = 0; i < of_a_.size(); ++i) {
      const Partners& mine = of_a_[i];
      for (std::size_t p = 0; p < kPartners && mine.index[p] != kNoPartner; ++p) {
        const float distance = descriptor_distance(mine.dot[p]);
        if (distance < largest_distance && of_b_[mine.index[p]].holds(i))
          matches.push_back({i, mine.index[p], distance});
      }
    }
    std::sort(matches.begin(), matches.end(),
              [](const auto& x, const auto& y) { return std::tie(x.a, x.b) < std::tie(y.a, y.b); });
    return matches;
  }

  static std::int32_t too_small_dot(float distance) {
    constexpr double kLargest = double(kDescriptorLength) * kDescriptorLength;
    return static_cast<std::int32_t>(kLargest * (1 - 0.5 * double(distance) * double(distance))) -
           2;
  }

  static std::vector<float> distances(const std::vector<std::int32_t>& dots) {
    std::vector<float> distances;
    for (const std::int32_t dot : dots)
      distances.push_back(dot > 0 ? descriptor_distance(dot) : kNoSimilarFeature);
    return distances;
  }

  const FeatureSet& a_;
  const FeatureSet& b_;
  std::vector<std::int32_t> repeats_a_, repeats_b_;
  std::vector<Partners> of_a_, of_b_;
  std::vector<std::int32_t> last_b_;                     // product of each feature's last partner
  std::vector<std::int32_t> repeat_of_a_, repeat_of_b_;  // largest product with a repeating feature
  std::vector<std::int32_t> products_;
};

}  // namespace

FeatureComparison compare_features(const FeatureSet& a, const FeatureSet& b, float largest_distance,
                                   const RepeatOptions& repeating) {
  return Comparison(a, b, largest_distance, repeating).result(largest_distance);
}

}  // namespace roomcast::alignment
