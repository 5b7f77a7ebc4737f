// SPDX-License-Identifier: Apache-2.0
#include "roomcast/study/counterbalance.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

namespace roomcast::study {
namespace {

/// 0, 1, n-1, 2, n-2, ...
std::vector<std::size_t> first_row(std::size_t n) {
  std::vector<std::size_t> row(n);
  for (std::size_t i = 1; i < n; ++i) row[i] = i % 2 == 1 ? (i + 1) / 2 : n - i / 2;
  return row;
}

/// SplitMix64 (Steele, Lea, Flood 2014).
std::uint64_t next_random(std::uint64_t& state) {
  std::uint64_t z = state += 0x9E3779B97F4A7C15;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EB;
  return z ^ (z >> 31U);
}

std::vector<std::size_t> shuffled(std::vector<std::size_t> row, std::size_t participant,
                                  std::string_view study) {
  std::uint64_t state = 0xCBF29CE484222325;  // FNV-1a of the name
  for (const char c : study) state = (state ^ static_cast<unsigned char>(c)) * 0x100000001B3;
  state += participant;
  (void)next_random(state);
  for (std::size_t i = row.size(); i > 1; --i) std::swap(row[i - 1], row[next_random(state) % i]);
  return row;
}

}  // namespace

std::size_t participants_per_square(std::size_t conditions, ConditionOrder order) {
  if (order != ConditionOrder::kBalanced || conditions < 2) return 1;
  return conditions % 2 == 0 ? conditions : 2 * conditions;
}

std::vector<std::size_t> order_for(std::size_t participant, std::size_t conditions,
                                   ConditionOrder order, std::string_view study) {
  std::vector<std::size_t> row(conditions);
  std::iota(row.begin(), row.end(), std::size_t{0});
  if (conditions < 2 || order == ConditionOrder::kFixed) return row;
  if (order == ConditionOrder::kRandom) return shuffled(std::move(row), participant, study);
  row = first_row(conditions);
  for (std::size_t& condition : row) condition = (condition + participant) % conditions;
  const bool is_mirrored = participant % participants_per_square(conditions, order) >= conditions;
  if (is_mirrored) std::ranges::reverse(row);
  return row;
}

}  // namespace roomcast::study
