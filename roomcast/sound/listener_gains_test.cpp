// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sound/listener_gains.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::sound {
namespace {

double loudness(const Gains& gains) {
  return std::hypot(gains[0], gains[1]);
}

TEST(ListenerGains, who_stands_to_the_right_is_heard_on_the_right) {
  const Gains right = listener_gains({}, Eigen::Vector3d(1, 0, 0));
  EXPECT_NEAR(right[0], 0, 1e-6);
  EXPECT_NEAR(right[1], 1, 1e-6);
  const Gains ahead = listener_gains({}, Eigen::Vector3d(0, 0, -1));
  EXPECT_NEAR(ahead[0], ahead[1], 1e-6);
}

TEST(ListenerGains, follow_the_listener) {
  RigidTransform turned;  // looks along +x
  turned.rotation << 0, 0, -1, 0, 1, 0, 1, 0, 0;
  const Gains ahead = listener_gains(turned, Eigen::Vector3d(1, 0, 0));
  EXPECT_NEAR(ahead[0], ahead[1], 1e-6);
  EXPECT_GT(listener_gains(turned, Eigen::Vector3d(0, 0, 1))[1], 0.99F);
}

TEST(ListenerGains, who_is_far_is_quieter_and_within_a_metre_nobody_is_louder) {
  EXPECT_NEAR(loudness(listener_gains({}, Eigen::Vector3d(0, 0, -0.3))), 1, 1e-6);
  EXPECT_NEAR(loudness(listener_gains({}, Eigen::Vector3d(0, 0, -1))), 1, 1e-6);
  EXPECT_NEAR(loudness(listener_gains({}, Eigen::Vector3d(0, 0, -6))), 0.2, 1e-6);
}

TEST(ListenerGains, who_has_no_head_is_heard_in_the_middle) {
  const Gains gains = listener_gains({}, std::nullopt);
  EXPECT_EQ(gains[0], gains[1]);
  EXPECT_NEAR(loudness(gains), 1, 1e-6);
}

}  // namespace
}  // namespace roomcast::sound
