// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/live/block_transform.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace roomcast::codec {
namespace {

TEST(BlockTransform, vector_code_and_plain_code_give_the_same_numbers) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 2000; ++trial) {
    BlockCoefficients coefficients{};
    const int rows = 1 + static_cast<int>(random() % 8);
    for (int k = 0; k < rows * kBlockSide; ++k) {
      const auto any = static_cast<std::int32_t>(random());
      coefficients[static_cast<std::size_t>(k)] = trial % 2 ? any : any % 2000;
    }
    BlockValues fast, plain;
    inverse_transform(coefficients, rows, fast);
    inverse_transform_reference(coefficients, plain);
    ASSERT_EQ(fast, plain) << trial;
  }
}

TEST(BlockTransform, a_flat_block_is_eight_times_its_value) {
  BlockCoefficients coefficients{};
  coefficients[0] = 8 * 1234;
  BlockValues values;
  inverse_transform(coefficients, 1, values);
  for (const std::int32_t value : values) EXPECT_EQ(value, 1234);
}

TEST(BlockTransform, there_and_back_is_exact_to_one) {
  std::mt19937 random(2);
  std::array<float, kBlockPixels> values, coefficients;
  for (float& value : values) value = static_cast<float>(random() % 20000);
  forward_transform(values, coefficients);
  BlockCoefficients rounded;
  for (std::size_t k = 0; k < kBlockPixels; ++k) {
    rounded[k] = static_cast<std::int32_t>(std::lround(coefficients[k]));
  }
  BlockValues back;
  inverse_transform(rounded, kBlockSide, back);
  // The matrix is orthogonal only to one part in a few hundred.
  constexpr float kMatrixError = 20000 / 200.0f;
  for (std::size_t k = 0; k < kBlockPixels; ++k) {
    EXPECT_NEAR(static_cast<float>(back[k]), values[k], kMatrixError);
  }
}

TEST(BlockTransform, zigzag_visits_every_position_once) {
  std::array<int, kBlockPixels> visits{};
  for (const std::uint8_t position : kZigzag) ++visits.at(position);
  for (const int count : visits) EXPECT_EQ(count, 1);
}

}  // namespace
}  // namespace roomcast::codec
