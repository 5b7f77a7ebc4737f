// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/measure/depth_error.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

DepthImage row_of(std::initializer_list<std::uint16_t> values) {
  DepthImage image(static_cast<int>(values.size()), 1);
  std::copy(values.begin(), values.end(), image.data());
  return image;
}

Image<Motion> motion_of(std::initializer_list<Motion> values) {
  Image<Motion> image(static_cast<int>(values.size()), 1);
  std::copy(values.begin(), values.end(), image.data());
  return image;
}

TEST(DepthError, equal_pictures_have_none) {
  DepthError error;
  error.add(row_of({1000, 0, 3000}), row_of({1000, 0, 3000}), {});
  EXPECT_EQ(error.rms_input_mm(), 0);
  EXPECT_EQ(error.max_input_mm(), 0);
  EXPECT_EQ(error.outliers(), 0);
  EXPECT_EQ(error.lost(), 0);
  EXPECT_EQ(error.extra(), 0);
  EXPECT_FALSE(error.has_truth());
}

TEST(DepthError, counts_outliers_and_leaves_them_out_of_the_mean) {
  DepthError error;
  error.add(row_of({1003, 3021, 3020}), row_of({1000, 3000, 3000}), {});
  EXPECT_DOUBLE_EQ(error.rms_input_mm(), std::sqrt((9.0 + 400) / 2));
  EXPECT_EQ(error.max_input_mm(), 21);
  EXPECT_EQ(error.outliers(), 1);
}

TEST(DepthError, on_still_surfaces_counts_each_error_for_at_most_a_twentieth_of_the_distance) {
  DepthError error;
  const DepthImage still = row_of({1000, 2000, 0, 4000, 4000});
  DepthTruth truth;
  truth.still_mm = still;
  error.add(row_of({1010, 2500, 7, 0, 4030}), row_of({1020, 2000, 9, 4000, 4040}), truth);
  EXPECT_TRUE(error.has_still());
  EXPECT_DOUBLE_EQ(error.rms_still_mm(), std::sqrt((100.0 + 10000 + 900) / 3));
  EXPECT_DOUBLE_EQ(error.rms_still_input_mm(), std::sqrt((400.0 + 0 + 1600) / 3));
}

TEST(DepthError, counts_readings_lost_and_invented) {
  DepthError error;
  error.add(row_of({0, 0, 5, 1000}), row_of({900, 800, 0, 1000}), {});
  EXPECT_EQ(error.lost(), 2);
  EXPECT_EQ(error.extra(), 1);
  EXPECT_EQ(error.rms_input_mm(), 0);
}

TEST(DepthError, separates_static_slow_and_moving_pixels) {
  DepthError error;
  const DepthImage decoded = row_of({1003, 2004, 3005, 4030, 0});
  const DepthImage truth = row_of({1000, 2000, 3000, 4000, 5000});
  const auto motion = motion_of(
      {Motion::kStatic, Motion::kSlow, Motion::kMoving, Motion::kMoving, Motion::kMoving});
  error.add(decoded, decoded, {truth, motion.view()});
  EXPECT_DOUBLE_EQ(error.rms_truth_mm(Motion::kStatic), 3);
  EXPECT_DOUBLE_EQ(error.rms_truth_mm(Motion::kSlow), 4);
  EXPECT_DOUBLE_EQ(error.rms_truth_mm(Motion::kMoving), 5);
  EXPECT_DOUBLE_EQ(error.rms_truth_mm(), std::sqrt((9.0 + 16 + 25) / 3));
  EXPECT_EQ(error.outliers(), 1) << "against the truth, not the input";
  EXPECT_EQ(error.outliers(Motion::kMoving), 1);
  EXPECT_EQ(error.true_pixels(Motion::kMoving), 3);
}

TEST(DepthError, a_pixel_without_truth_is_left_out) {
  DepthError error;
  const auto motion = motion_of({Motion::kStatic});
  error.add(row_of({1000}), row_of({1000}), {row_of({0}), motion.view()});
  EXPECT_TRUE(error.has_truth());
  EXPECT_EQ(error.true_pixels(Motion::kStatic), 0);
  EXPECT_EQ(error.rms_truth_mm(), 0);
}

TEST(DepthError, frames_add_up) {
  DepthError first, both;
  first.add(row_of({1003}), row_of({1000}), {});
  both.add(row_of({1004}), row_of({1000}), {});
  both.add(first);
  EXPECT_DOUBLE_EQ(both.rms_input_mm(), std::sqrt((9.0 + 16) / 2));
  EXPECT_EQ(both.max_input_mm(), 4);
}

TEST(DepthError, to_the_noise_free_reading_leaves_out_where_the_sensor_never_reads) {
  DepthError error;
  const DepthImage decoded = row_of({1007, 2005, 3000, 0}),
                   truth = row_of({1000, 2000, 3000, 4000});
  const DepthImage noise_free = row_of({1004, 2009, 0, 4000});
  const auto motion =
      motion_of({Motion::kStatic, Motion::kMoving, Motion::kStatic, Motion::kStatic});
  error.add(decoded, decoded, {truth, motion.view(), noise_free});
  EXPECT_TRUE(error.has_noise_free());
  EXPECT_DOUBLE_EQ(error.rms_noise_free_mm(Motion::kStatic), 3);
  EXPECT_DOUBLE_EQ(error.rms_noise_free_mm(Motion::kMoving), 4);
}

}  // namespace
}  // namespace roomcast::bench
