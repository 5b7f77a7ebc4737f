// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/table_merging.h"

#include <cmath>
#include <vector>

namespace roomcast::codec {
namespace {

// What sending a table takes, about.
constexpr double kBitsPerTable = 9, kBitsPerToken = 3.5;

struct Group {
  int first_context = 0;
  TokenCounts counts{};
  double bits = 0;  // to send its tokens and its table
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

void rate_joint(std::vector<Group>& groups, std::size_t i) {
  if (i + 1 >= groups.size()) {
    if (i < groups.size()) groups[i].gain_of_joining_next = -1;
    return;
  }
  Group& group = groups[i];
  group.gain_of_joining_next =
      group.bits + groups[i + 1].bits - bits_for(sum_of(group.counts, groups[i + 1].counts));
}

/// The joint that gains most; groups.size() if none does.
std::size_t best_joint(const std::vector<Group>& groups) {
  std::size_t best = groups.size();
  for (std::size_t i = 0; i + 1 < groups.size(); ++i) {
    const double gain = groups[i].gain_of_joining_next;
    if (gain >= 0 && (best == groups.size() || gain > groups[best].gain_of_joining_next)) best = i;
  }
  return best;
}

void join(std::vector<Group>& groups, std::size_t i) {
  groups[i].counts = sum_of(groups[i].counts, groups[i + 1].counts);
  groups[i].bits = bits_for(groups[i].counts);
  groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  rate_joint(groups, i);
  if (i > 0) rate_joint(groups, i - 1);
}

}  // namespace

void merge_tables(const std::array<TokenCounts, kContextCount>& counts, SideInformation& side) {
  std::vector<Group> groups;
  groups.reserve(kContextCount);
  for (int c = 0; c < kContextCount; ++c) groups.push_back({c, counts[c], bits_for(counts[c]), 0});
  for (std::size_t i = 0; i < groups.size(); ++i) rate_joint(groups, i);
  for (std::size_t i = best_joint(groups); i < groups.size(); i = best_joint(groups))
    join(groups, i);

  side.tables.clear();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    side.tables.push_back(sendable_weights(groups[g].counts));
    const int end = g + 1 < groups.size() ? groups[g + 1].first_context : kContextCount;
    for (int c = groups[g].first_context; c < end; ++c) {
      side.table_of_context[c] = static_cast<std::uint8_t>(g);
    }
  }
}

}  // namespace roomcast::codec
