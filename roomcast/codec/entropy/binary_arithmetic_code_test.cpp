// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/entropy/binary_arithmetic_code.h"

#include <random>

#include <gtest/gtest.h>

namespace roomcast::codec {
namespace {

TEST(BinaryArithmeticCode, gives_back_bits_of_any_probability) {
  for (const std::uint32_t zeros_in_thousand : {0u, 1u, 300u, 500u, 999u, 1000u}) {
    std::mt19937 random(zeros_in_thousand);
    std::vector<bool> bits(5000);
    for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = random() % 1000 >= zeros_in_thousand;
    std::vector<std::uint8_t> bytes;
    ArithmeticEncoder encoder(bytes);
    AdaptiveBit model;
    for (const bool bit : bits) encoder.put(model, bit);
    encoder.finish();
    ArithmeticDecoder decoder(bytes);
    AdaptiveBit same_model;
    for (std::size_t i = 0; i < bits.size(); ++i) ASSERT_EQ(decoder.get(same_model), bits[i]) << i;
  }
}

// Improbable ones raise the low end of the range, so that carries propagate through bytes of 0xFF.
TEST(BinaryArithmeticCode, carries_through_any_number_of_bytes) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    std::vector<std::uint32_t> values(60);
    for (auto& value : values) value = random() % 4 ? 0xFFFF : random() & 0xFFFF;
    std::vector<std::uint8_t> bytes;
    ArithmeticEncoder encoder(bytes);
    for (const std::uint32_t value : values) encoder.put_raw(value, 16);
    encoder.finish();
    ArithmeticDecoder decoder(bytes);
    for (const std::uint32_t value : values) ASSERT_EQ(decoder.get_raw(16), value);
  }
}

TEST(BinaryArithmeticCode, trees_give_back_numbers_and_learn_them) {
  std::vector<std::uint8_t> bytes;
  ArithmeticEncoder encoder(bytes);
  BitTree<5> tree;
  for (int i = 0; i < 1000; ++i) encoder.put(tree, i % 10 ? 7u : 31u);
  encoder.finish();
  EXPECT_LT(bytes.size(), 1000u * 5 / 8 / 4);
  ArithmeticDecoder decoder(bytes);
  BitTree<5> same_tree;
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(decoder.get(same_tree), i % 10 ? 7u : 31u);
}

TEST(BinaryArithmeticCode, appends_and_leaves_zeros_at_the_end_out) {
  std::vector<std::uint8_t> bytes{0, 0};
  ArithmeticEncoder encoder(bytes);
  encoder.put_raw(0, 16);
  encoder.finish();
  EXPECT_EQ(bytes.size(), 2u) << "nothing but zeros: nothing is written, what was there stays";
  EXPECT_EQ(ArithmeticDecoder({}).get_raw(16), 0u);
}

}  // namespace
}  // namespace roomcast::codec
