// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/lossless/table_merging.h"

#include <algorithm>
#include <cmath>

namespace roomcast::codec {
namespace {

// Approximate cost of sending a table.
constexpr double kBitsPerTable = 9, kBitsPerToken = 3.5;

struct Group {
  int first_context = 0;
  TokenCounts counts{};
  double bits = 0;  // cost of its tokens and its table
  double gain_of_joining_next = 0;
};

double bits_for(const TokenCounts& counts) {
  double total = 0, weighted = 0;
  int last = -1;
  for (int t = 0; t < kTokenCount; ++t) {
    if (counts[t] == 0) continue;
    const double n = counts[t];
    total += n;
    weighted += n * std::log2(n);
    last = t;
  }
  return last < 0
             ? 0
             : total * std::log2(total) - weighted + kBitsPerTable + kBitsPerToken * (last + 1);
}

TokenCounts sum_of(const TokenCounts& a, const TokenCounts& b) {
  TokenCounts sum;
  for (int t = 0; t < kTokenCount; ++t) sum[t] = a[t] + b[t];
  return sum;
}

/// Groups of adjacent contexts, in order. At most one per context, so nothing is allocated.
class Groups {
 public:
  explicit Groups(const std::array<TokenCounts, kContextCount>& counts) {
    for (int c = 0; c < kContextCount; ++c) groups_[c] = {c, counts[c], bits_for(counts[c]), 0};
    for (int i = 0; i < count_; ++i) rate_joint(i);
  }
  void join_while_it_gains() {
    for (int i = best_joint(); i >= 0; i = best_joint()) join(i);
  }
  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] const TokenCounts& counts(int i) const { return groups_[i].counts; }
  [[nodiscard]] int first_context(int i) const {
    return i < count_ ? groups_[i].first_context : kContextCount;
  }

 private:
  void rate_joint(int i) {
    if (i < 0 || i + 1 >= count_) return;
    const Group& next = groups_[i + 1];
    groups_[i].gain_of_joining_next =
        groups_[i].bits + next.bits - bits_for(sum_of(groups_[i].counts, next.counts));
  }

  /// The joint with the largest gain; -1 if none gains.
  [[nodiscard]] int best_joint() const {
    int best = -1;
    for (int i = 0; i + 1 < count_; ++i) {
      const double gain = groups_[i].gain_of_joining_next;
      if (gain >= 0 && (best < 0 || gain > groups_[best].gain_of_joining_next)) best = i;
    }
    return best;
  }

  void join(int i) {
    groups_[i].counts = sum_of(groups_[i].counts, groups_[i + 1].counts);
    groups_[i].bits = bits_for(groups_[i].counts);
    std::move(groups_.begin() + i + 2, groups_.begin() + count_, groups_.begin() + i + 1);
    --count_;
    rate_joint(i);
    rate_joint(i - 1);
  }

  std::array<Group, kContextCount> groups_;
  int count_ = kContextCount;
};

}  // namespace

void merge_tables(const std::array<TokenCounts, kContextCount>& counts, SideInformation& side) {
  Groups groups(counts);
  groups.join_while_it_gains();
  side.tables.clear();
  for (int g = 0; g < groups.count(); ++g) {
    side.tables.push_back(sendable_weights(groups.counts(g)));
    for (int c = groups.first_context(g); c < groups.first_context(g + 1); ++c) {
      side.table_of_context[c] = static_cast<std::uint8_t>(g);
    }
  }
}

}  // namespace roomcast::codec
