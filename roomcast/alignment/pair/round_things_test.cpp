// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/round_things.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

constexpr int kSide = 24;

/// The near half of a sphere on a grid of rays, or a flat disc where `flat`.
MovingSurface seen_ball(const Eigen::Vector3f& center_m, float radius_m, bool flat = false) {
  const SurfacePoint none{Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()};
  MovingSurface surface{1.5, Image<SurfacePoint>(kSide, kSide, none), {}};
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const float u = 2.2F * (float(x) + 0.5F) / kSide - 1.1F;
      const float v = 2.2F * (float(y) + 0.5F) / kSide - 1.1F;
      const float inside = 1 - u * u - v * v;
      if (inside < 0.1F) continue;  // the rim is smeared
      const Eigen::Vector3f outward =
          flat ? Eigen::Vector3f(0, 0, -1) : Eigen::Vector3f(u, v, -std::sqrt(inside));
      const Eigen::Vector3f place(u, v, flat ? -1 : outward.z());
      surface.at.at(x, y) = {center_m + radius_m * place, outward};
      surface.blocks.emplace_back(x, y);
    }
  }
  return surface;
}

TEST(RoundThings, a_ball_has_its_center_behind_what_is_seen) {
  const Eigen::Vector3f center(0.3F, -0.2F, 3);
  for (const float radius : {0.1F, 0.25F}) {
    const MovingSurface surfaces[] = {seen_ball(center, radius)};
    const auto found = round_things(surfaces);
    ASSERT_EQ(found.size(), 1u) << radius;
    EXPECT_EQ(found[0].time_s, 1.5);
    EXPECT_NEAR(found[0].radius_m, double(radius), 0.002);
    EXPECT_LT((found[0].center_m - center.cast<double>()).norm(), 0.003);
  }
}

TEST(RoundThings, flat_things_are_none) {
  const MovingSurface surfaces[] = {seen_ball({0, 0, 3}, 0.25F, true)};
  EXPECT_TRUE(round_things(surfaces).empty());
}

TEST(RoundThings, what_is_too_large_is_none) {
  const MovingSurface surfaces[] = {seen_ball({0, 0, 4}, 0.8F)};
  EXPECT_TRUE(round_things(surfaces).empty());
}

}  // namespace
}  // namespace roomcast::alignment
