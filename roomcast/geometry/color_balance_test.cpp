// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/color_balance.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace roomcast {
namespace {

TEST(ColorBalance, makes_all_cameras_alike_also_over_a_third) {
  const std::array<ColorRatio, 2> ratios = {
      {{0, 1, 1'000, {0.2, 0, -0.1}}, {1, 2, 500, {0.1, 0.3, 0}}}};
  const Eigen::MatrixXd logs = log_gains(ratios, 3, 0.01);
  for (const ColorRatio& ratio : ratios) {
    const auto a = static_cast<Eigen::Index>(ratio.a), b = static_cast<Eigen::Index>(ratio.b);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(logs(a, c) - logs(b, c), ratio.log_b_over_a[c], 1e-4);
  }
  EXPECT_NEAR(logs.col(0).sum(), 0, 1e-6) << "the mean stays as it is";
}

TEST(ColorBalance, what_two_cameras_share_is_their_median) {
  ChannelLogs logs = {{{0.2, 0.1, 5}, {0, 0, -3}, {-0.1, -0.1, 0.4}}};
  const ColorRatio ratio = median_ratio(3, 7, logs);
  EXPECT_EQ(ratio.a, 3u);
  EXPECT_EQ(ratio.b, 7u);
  EXPECT_EQ(ratio.places, 3);
  EXPECT_EQ(ratio.log_b_over_a, Eigen::Vector3d(0.2, 0, -0.1));
}

TEST(ColorBalance, the_prior_holds_back_what_few_places_say) {
  const std::array<ColorRatio, 1> ratios = {{{0, 1, 10, {0.4, 0, 0}}}};
  const Eigen::MatrixXd logs = log_gains(ratios, 2, 10);
  EXPECT_GT(logs(0, 0), 0.05);
  EXPECT_LT(logs(0, 0) - logs(1, 0), 0.3);
}

TEST(ColorBalance, cameras_that_share_nothing_stay_as_they_are) {
  EXPECT_TRUE(log_gains({}, 2, 1).isZero());
  EXPECT_EQ(log_gains({}, 0, 1).rows(), 0);
}

}  // namespace
}  // namespace roomcast
