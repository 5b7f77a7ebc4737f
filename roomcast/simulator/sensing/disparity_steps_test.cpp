// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/disparity_steps.h"

#include <cmath>
#include <cstdlib>
#include <set>

#include <gtest/gtest.h>

namespace roomcast::simulator {
namespace {

constexpr DisparitySteps kKinect{585.0F, 75.0F, 0.125F};

/// The distinct depths that are reported between two ranges.
std::set<int> reported_between(int near_mm, int far_mm) {
  std::set<int> depths;
  for (int z = near_mm; z <= far_mm; ++z)
    depths.insert(kKinect.rounded_mm(static_cast<std::uint16_t>(z)));
  return depths;
}

/// Mean distance of the depths around a range.
double step_at(int z_mm) {
  const auto depths = reported_between(z_mm - 400, z_mm + 400);
  return static_cast<double>(*depths.rbegin() - *depths.begin()) /
         static_cast<double>(depths.size() - 1);
}

TEST(DisparitySteps, grow_with_the_square_of_the_range_as_published) {
  EXPECT_NEAR(step_at(5000), 70, 5);  // Khoshelham and Oude Elberink 2012
  EXPECT_NEAR(step_at(5000) / step_at(2500), 4, 0.3);
}

TEST(DisparitySteps, report_the_nearest_depth_and_keep_holes) {
  EXPECT_EQ(kKinect.rounded_mm(0), 0);
  for (int z = 500; z < 6000; z += 7) {
    const int reported = kKinect.rounded_mm(static_cast<std::uint16_t>(z));
    EXPECT_LE(std::abs(reported - z), 0.52 * 2.85e-6 * z * z + 1) << z;
    EXPECT_EQ(kKinect.rounded_mm(static_cast<std::uint16_t>(reported)), reported);
  }
}

TEST(DisparitySteps, apply_to_every_pixel) {
  DepthImage depth_mm(2, 2);
  for (int i = 0; i < 4; ++i) depth_mm.data()[i] = static_cast<std::uint16_t>(3000 + i);
  round_to_disparity_steps(kKinect, depth_mm.view());
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(depth_mm.data()[i], kKinect.rounded_mm(static_cast<std::uint16_t>(3000 + i)));
}

}  // namespace
}  // namespace roomcast::simulator
