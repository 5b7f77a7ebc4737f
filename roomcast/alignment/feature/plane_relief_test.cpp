// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/feature/plane_relief.h"

#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

const Plane kReliefWall{{0, 0, -1}, 3, {}};  // z = 3, seen from the origin

/// A wall with a picture on it, 2 cm in front of the wall where x > 0.
std::vector<SurfacePoint> wall_with_picture() {
  std::vector<SurfacePoint> samples;
  for (float y = -0.5F; y < 0.5F; y += 0.02F) {
    for (float x = -0.5F; x < 0.5F; x += 0.02F)
      samples.push_back({{x, y, x > 0 ? 2.98F : 3.F}, kReliefWall.normal});
  }
  return samples;
}

TEST(PlaneRelief, knows_what_lies_on_the_plane) {
  const auto samples = wall_with_picture();
  const PlaneRelief relief(kReliefWall, samples);
  ASSERT_TRUE(relief.height_m({0.3F, 0.1F, 3}).has_value());
  EXPECT_NEAR(*relief.height_m({0.3F, 0.1F, 3}), 0.02F, 1e-4F);
  EXPECT_NEAR(*relief.height_m({-0.3F, 0.1F, 3}), 0, 1e-4F);
}

TEST(PlaneRelief, knows_nothing_where_nothing_is_near_the_plane) {
  std::vector<SurfacePoint> samples = wall_with_picture();
  EXPECT_FALSE(PlaneRelief(kReliefWall, samples).height_m({2, 2, 3}).has_value());
  for (SurfacePoint& sample : samples) sample.point_m.z() = 2.5F;
  EXPECT_FALSE(PlaneRelief(kReliefWall, samples).height_m({0.3F, 0.1F, 3}).has_value());
  EXPECT_FALSE(PlaneRelief(kReliefWall, {}).height_m({0.3F, 0.1F, 3}).has_value());
}

}  // namespace
}  // namespace roomcast::alignment
