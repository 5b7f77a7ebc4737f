// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/measure/still_surfaces.h"

#include <vector>

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

/// The median of one pixel with these readings.
int still_median_of(const std::vector<std::uint16_t>& readings) {
  std::vector<DepthImage> images;
  for (const std::uint16_t z : readings) images.emplace_back(1, 1, z);
  const std::vector<DepthView> frames(images.begin(), images.end());
  return median_of_still(frames).at(0, 0);
}

TEST(StillSurfaces, have_the_median_of_their_readings) {
  EXPECT_EQ(still_median_of({2000, 2010, 1995, 2005, 2003}), 2003);
}

TEST(StillSurfaces, may_have_one_outlier_in_ten_readings) {
  std::vector<std::uint16_t> readings(20, 2000);
  readings[3] = 3000;
  EXPECT_EQ(still_median_of(readings), 2000);
  for (int i = 0; i < 4; ++i) readings[static_cast<std::size_t>(i)] = 3000;
  EXPECT_EQ(still_median_of(readings), 0);
}

TEST(StillSurfaces, have_readings_in_nearly_all_frames) {
  EXPECT_EQ(still_median_of({2000, 0, 2000, 0, 2000}), 0);
  EXPECT_EQ(still_median_of({0, 0, 0}), 0);
}

TEST(StillSurfaces, without_frames_there_are_none) {
  EXPECT_TRUE(median_of_still({}).empty());
}

}  // namespace
}  // namespace roomcast::bench
