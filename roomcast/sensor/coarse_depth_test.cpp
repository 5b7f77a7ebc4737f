// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/coarse_depth.h"

#include <gtest/gtest.h>

#include "roomcast/wire/control_check.h"

namespace roomcast::sensor {
namespace {

using namespace std::chrono_literals;

DepthImage wall(std::uint16_t depth_mm) {
  return {120, 90, depth_mm};
}

void paint(DepthImage& image, int left, int right, std::uint16_t depth_mm) {
  for (int y = 0; y < image.height(); ++y) {
    for (int x = left; x < right; ++x) image.at(x, y) = depth_mm;
  }
}

TEST(CoarseDepth, has_the_nearest_and_farthest_surface_of_each_cell) {
  DepthImage image = wall(4000);
  paint(image, 0, 4, 1500);  // covers 4 of 10 columns of the first cell
  paint(image, 10, 20, 0);   // the second cell shows nothing
  const auto coarse = coarse_depth(image);
  ASSERT_EQ(coarse.near_cm_size(), 12 * 9);
  EXPECT_EQ(coarse.near_cm(0), 150U);
  EXPECT_EQ(coarse.far_cm(0), 400U);
  EXPECT_EQ(coarse.near_cm(1), 0U);
  EXPECT_EQ(coarse.far_cm(1), 0U);
  EXPECT_EQ(coarse.near_cm(2), 400U);
  EXPECT_EQ(coarse.far_cm(2), 400U);
  wire::pb::Control message;
  *message.mutable_coarse_depth() = coarse;
  EXPECT_TRUE(wire::check_control(message));
}

TEST(CoarseDepth, stray_readings_do_not_count) {
  DepthImage image = wall(4000);
  image.at(3, 3) = 300;
  paint(image, 10, 20, 0);
  image.at(12, 3) = 700;  // alone in its cell
  const auto coarse = coarse_depth(image);
  EXPECT_EQ(coarse.near_cm(0), 400U);
  EXPECT_EQ(coarse.near_cm(1), 0U);
}

TEST(CoarseDepth, small_pictures_have_cells_too) {
  const auto coarse = coarse_depth(DepthImage(16, 16));
  EXPECT_EQ(coarse.near_cm_size(), 12 * 9);
}

TEST(CoarseDepthReporter, reports_changes_at_once_a_second_and_repeats_what_stays) {
  CoarseDepthReporter reporter;
  const HostTime begin{10s};
  const DepthImage still = wall(3000), nearer = wall(2500);
  EXPECT_TRUE(reporter.add(still, begin));
  EXPECT_FALSE(reporter.add(nearer, begin + 500ms)) << "a second has not passed";
  EXPECT_TRUE(reporter.add(nearer, begin + 1s));
  for (int second = 2; second < 6; ++second)
    EXPECT_FALSE(reporter.add(nearer, begin + second * 1s)) << second;
  EXPECT_TRUE(reporter.add(nearer, begin + 6s));
  const DepthImage noisy = wall(2550);
  EXPECT_FALSE(reporter.add(noisy, begin + 7s));
}

}  // namespace
}  // namespace roomcast::sensor
