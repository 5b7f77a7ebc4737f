// SPDX-License-Identifier: Apache-2.0
// Side information and the frequency tables in it.
#include "roomcast/codec/lossless/side_information.h"

#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "roomcast/codec/lossless/table_merging.h"

namespace roomcast::codec {
namespace {

TokenCounts counts_around(std::uint32_t centre, std::uint32_t scale) {
  TokenCounts counts{};
  for (std::uint32_t t = 0; t < kTokenCount; ++t) {
    const std::uint32_t away = t > centre ? t - centre : centre - t;
    counts[t] = away < 12 ? scale >> away : 0;
  }
  return counts;
}

int sum_of(const FrequencyTable& table) {
  return std::accumulate(table.frequency.begin(), table.frequency.end(), 0);
}

TEST(FrequencyTable, sums_to_4096_and_gives_every_token_a_share) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 300; ++trial) {
    TokenCounts counts{};
    for (auto& count : counts) count = random() % 3 ? 0 : random() >> random() % 32;
    counts[random() % kTokenCount] = 1;
    const FrequencyTable table = normalised(sendable_weights(counts));
    EXPECT_EQ(sum_of(table), 4096);
    for (int t = 0; t < kTokenCount; ++t) EXPECT_EQ(table.frequency[t] > 0, counts[t] > 0);
  }
}

TEST(FrequencyTable, many_rare_tokens_do_not_starve_the_common_one) {
  Weights weights;
  weights.fill(1);
  for (const std::uint32_t common : {0x7000u, 0x3000u, 1u}) {
    weights[40] = common;
    const FrequencyTable table = normalised(weights);
    EXPECT_EQ(sum_of(table), 4096);
    EXPECT_GE(table.frequency[40], 4096 / kTokenCount);
  }
}

SideInformation example() {
  SideInformation side;
  side.mapped = true;
  side.values = {0, 1, 2, 400, 401, 65535};
  side.predictors[0] = {true, {-128, 127, 0, 1, -1, 64}};
  side.predictors[11] = {true, {1, 2, 3, 4, 5, 6}};
  std::array<TokenCounts, kContextCount> counts{};
  for (int c = 0; c < kContextCount; ++c) counts[c] = counts_around(c < 20 ? 3 : 60, 100000);
  merge_tables(counts, side);
  return side;
}

TEST(SideInformation, comes_back) {
  const SideInformation side = example();
  std::vector<std::uint8_t> bytes;
  put_side_information(side, bytes);
  SideInformation out;
  ASSERT_TRUE(get_side_information(bytes, out).ok());
  EXPECT_EQ(out.mapped, side.mapped);
  EXPECT_EQ(out.values, side.values);
  EXPECT_EQ(out.predictors, side.predictors);
  EXPECT_EQ(out.tables, side.tables);
  EXPECT_EQ(out.table_of_context, side.table_of_context);
}

TEST(SideInformation, contexts_that_are_alike_share_a_table_and_others_do_not) {
  const SideInformation side = example();
  EXPECT_EQ(side.tables.size(), 2u);
  EXPECT_EQ(side.table_of_context[19], 0);
  EXPECT_EQ(side.table_of_context[20], 1);
}

TEST(SideInformation, refuses_a_value_table_beyond_65535) {
  SideInformation side = example();
  std::vector<std::uint8_t> bytes;
  side.values = {0, 60000, 60001, 60002};
  put_side_information(side, bytes);
  ASSERT_TRUE(get_side_information(bytes, side).ok());
  // The same gaps, one of them twice as long: 60000 and 60000 more.
  bytes.clear();
  ArithmeticEncoder encoder(bytes);
  encoder.put_raw(1, 1);
  encoder.put_raw(2, 16);
  std::array<BitTree<5>, 8> trees;
  for (const std::size_t previous_length : {0u, 7u}) {
    encoder.put(trees[previous_length], 16);
    encoder.put_raw(60000 & 0x7FFF, 15);
  }
  encoder.finish();
  EXPECT_FALSE(get_side_information(bytes, side).ok());
}

TEST(SideInformation, survives_garbage_with_bounded_memory) {
  std::mt19937 random(2);
  SideInformation side;
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<std::uint8_t> bytes(random() % 400);
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
    (void)get_side_information(bytes, side);
    EXPECT_LE(side.tables.size(), static_cast<std::size_t>(kContextCount));
    EXPECT_LE(side.values.size(), kDepthValueCount);
  }
}

}  // namespace
}  // namespace roomcast::codec
