// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/drivers/freenect/kinect_depth.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::source {
namespace {

TEST(KinectDepth, the_recorded_plane_is_where_it_says) {
  // No shift against the recorded pattern: (200 + 0.375) * 4 = 801.5.
  const auto mm = kinect_mm_from_raw({});
  EXPECT_NEAR(0.5 * (mm[801] + mm[802]), 1200, 2);
}

// Magnenat's fit to a real Kinect, widely used: 1 / z = -0.0030711016 raw + 3.3309495161 (z in m).
TEST(KinectDepth, agrees_with_a_published_fit_within_the_difference_between_cameras) {
  const auto mm = kinect_mm_from_raw({});
  for (const int raw : {450, 600, 750, 900, 1000}) {
    const double fitted_mm = 1000 / (-0.0030711016 * raw + 3.3309495161);
    EXPECT_NEAR(mm[static_cast<std::size_t>(raw)] / fitted_mm, 1, 0.06) << raw;
  }
}

TEST(KinectDepth, a_step_grows_with_the_square_of_the_distance) {
  const auto mm = kinect_mm_from_raw({});
  const auto step_at = [&](std::size_t raw) { return 0.1 * (mm[raw + 5] - mm[raw - 5]); };
  const double ratio = double(mm[1000]) / mm[700];
  EXPECT_NEAR(step_at(1000) / step_at(700), ratio * ratio, 0.1 * ratio * ratio);
}

TEST(KinectDepth, values_without_meaning_give_no_reading) {
  const auto mm = kinect_mm_from_raw({});
  EXPECT_EQ(mm[kKinectNoReading], 0);
  EXPECT_EQ(mm[1200], 0);  // behind infinity
  std::vector<std::uint16_t> raw(kKinectWidth * kKinectHeight, 700);
  raw[0] = 2047, raw[1] = 2048, raw[2] = 65535;
  DepthImage depth;
  kinect_depth_from_raw(raw.data(), mm, depth);
  EXPECT_EQ(depth.at(0, 0), 0);
  EXPECT_EQ(depth.at(1, 0), 0);
  EXPECT_EQ(depth.at(2, 0), 0);
  EXPECT_EQ(depth.at(3, 0), mm[700]);
  EXPECT_EQ(depth.at(kKinectWidth - 1, kKinectHeight - 1), mm[700]);
}

TEST(KinectDepth, the_focal_length_follows_from_the_plane) {
  EXPECT_NEAR(depth_focal_length_px({}), 575.8, 0.1);
}

}  // namespace
}  // namespace roomcast::source
