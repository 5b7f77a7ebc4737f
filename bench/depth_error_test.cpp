// SPDX-License-Identifier: Apache-2.0
#include "bench/depth_error.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

DepthImage row_of(std::initializer_list<std::uint16_t> values) {
  DepthImage image(static_cast<int>(values.size()), 1);
  std::copy(values.begin(), values.end(), image.data());
  return image;
}

TEST(DepthError, equal_pictures_have_none) {
  DepthError error;
  error.add(row_of({1000, 0, 3000}), row_of({1000, 0, 3000}), {}, {});
  EXPECT_EQ(error.rms_input_mm(), 0);
  EXPECT_EQ(error.max_input_mm(), 0);
  EXPECT_EQ(error.outliers_per_frame(), 0);
  EXPECT_FALSE(error.rms_truth_mm().has_value());
}

TEST(DepthError, leaves_out_holes_and_counts_outliers_per_frame) {
  DepthError error;
  error.add(row_of({1003, 0, 3100, 5}), row_of({1000, 900, 3000, 0}), {}, {});
  error.add(row_of({1004}), row_of({1000}), {}, {});
  EXPECT_DOUBLE_EQ(error.rms_input_mm(), std::sqrt((9.0 + 10000 + 16) / 3));
  EXPECT_EQ(error.max_input_mm(), 100);
  EXPECT_DOUBLE_EQ(error.outliers_per_frame(), 0.5);
}

TEST(DepthError, tells_static_from_moving_by_the_truth) {
  DepthError error;
  const DepthImage decoded = row_of({1003, 2004, 3030});
  error.add(decoded, decoded, row_of({1000, 2000, 3000}), row_of({1004, 2500, 3000}));
  EXPECT_DOUBLE_EQ(error.rms_truth_static_mm().value(), 3);
  EXPECT_DOUBLE_EQ(error.rms_truth_moving_mm().value(), 4);
  EXPECT_DOUBLE_EQ(error.rms_truth_mm().value(), std::sqrt((9.0 + 16) / 2));
  EXPECT_DOUBLE_EQ(error.outliers_per_frame(), 1) << "against the truth, not the input";
}

}  // namespace
}  // namespace roomcast::bench
