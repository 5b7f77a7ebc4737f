// SPDX-License-Identifier: Apache-2.0
#include "bench/render/view_score.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

constexpr int kSide = 32;

/// A striped picture of a surface at 2 m; a sensor sees the left half.
struct Scene {
  TruthView truth{ColorImage(kSide, kSide), DepthImage(kSide, kSide, 2000),
                  MaskImage(kSide, kSide)};
  ViewClasses classes{MaskImage(kSide, kSide), MaskImage(kSide, kSide)};
  DrawnView drawn{ColorImage(kSide, kSide), Image<float>(kSide, kSide, 2.0F)};

  Scene() {
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const auto level = static_cast<std::uint8_t>(60 + 40 * (y / 4 % 3));
        truth.color.at(x, y) = drawn.color.at(x, y) = {level, level, level};
        truth.seen.at(x, y) = x < kSide / 2 ? 1 : 0;
      }
    }
    classes.colored = truth.seen;
  }
};

TEST(ViewScore, of_the_truth_itself_is_perfect) {
  const Scene scene;
  const ViewScore s = score(scene.drawn, scene.truth, scene.classes);
  EXPECT_GT(s.psnr_visible, 100);
  EXPECT_NEAR(s.ssim_visible, 1, 1e-4);
  EXPECT_EQ(s.holes, 0);
  EXPECT_EQ(s.covered, 1);
}

TEST(ViewScore, an_error_of_ten_levels_is_28_decibels) {
  Scene scene;
  for (int i = 0; i < kSide * kSide; ++i) scene.drawn.color.data()[i].g += 10;
  const double expected = 10 * std::log10(255.0 * 255.0 / (100.0 / 3));
  EXPECT_NEAR(score(scene.drawn, scene.truth, scene.classes).psnr_visible, expected, 1e-6);
}

TEST(ViewScore, unseen_surfaces_count_among_the_covered_only) {
  Scene scene;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 3 * kSide / 4; x < kSide; ++x) scene.drawn.color.at(x, y) = {255, 0, 0};
  }
  const ViewScore s = score(scene.drawn, scene.truth, scene.classes);
  EXPECT_GT(s.psnr_visible, 100);
  EXPECT_LT(s.psnr_covered, 20);
}

TEST(ViewScore, holes_floaters_and_wrong_depth_are_shares_of_the_visible) {
  Scene scene;
  for (int y = 0; y < kSide; ++y) {
    scene.drawn.depth_m.at(0, y) = 0;      // a hole
    scene.drawn.depth_m.at(1, y) = 1.9F;   // a floater
    scene.drawn.depth_m.at(2, y) = 2.1F;   // too far
    scene.drawn.depth_m.at(3, y) = 2.05F;  // within 6 cm
    scene.drawn.depth_m.at(kSide - 1, y) = 0;
  }
  const ViewScore s = score(scene.drawn, scene.truth, scene.classes);
  EXPECT_DOUBLE_EQ(s.holes, 1.0 / 16);
  EXPECT_DOUBLE_EQ(s.floaters, 1.0 / 15);
  EXPECT_DOUBLE_EQ(s.wrong_depth, 2.0 / 15);
}

TEST(ViewScore, flicker_is_of_still_surfaces_that_both_pictures_show) {
  Scene scene;
  DrawnView next = scene.drawn;
  for (int y = 0; y < kSide; ++y) {
    next.color.at(0, y).r += 32;
    next.color.at(1, y).r += 100;
    scene.classes.moving.at(1, y) = 255;
    next.depth_m.at(2, y) = 0;
    next.color.at(kSide - 1, y).r += 100;
  }
  const double expected = 32.0 / 3 / 14;  // of 16 columns one moves and one is a hole
  EXPECT_NEAR(flicker(scene.drawn, next, scene.truth, scene.classes), expected, 1e-9);
}

TEST(ViewScore, the_moving_part_is_not_judged_where_nothing_moves) {
  Scene scene;
  EXPECT_TRUE(std::isnan(score(scene.drawn, scene.truth, scene.classes).psnr_moving));
  ViewScore still, moving{.psnr_moving = 20};
  still.psnr_moving = std::nan("");
  EXPECT_DOUBLE_EQ(mean({still, moving}).psnr_moving, 20);
}

TEST(ViewScore, the_mean_is_field_by_field) {
  const ViewScore both = mean(
      {ViewScore{.psnr_visible = 20, .holes = 0.1}, ViewScore{.psnr_visible = 30, .holes = 0.3}});
  EXPECT_DOUBLE_EQ(both.psnr_visible, 25);
  EXPECT_DOUBLE_EQ(both.holes, 0.2);
}

TEST(ViewScore, a_silhouette_is_judged_in_the_views_that_have_one) {
  Scene scene;
  const ViewScore without = score(scene.drawn, scene.truth, scene.classes);
  EXPECT_TRUE(std::isnan(without.silhouette_missing));
  EXPECT_TRUE(std::isnan(mean({without}).silhouette_doubled));
  scene.classes.silhouette.mask = MaskImage(kSide, kSide, 255);
  scene.classes.silhouette.reach_m = Image<float>(kSide, kSide, 2.3F);
  for (int y = 0; y < kSide; ++y) {
    scene.drawn.depth_m.at(0, y) = 0;
    scene.drawn.depth_m.at(1, y) = scene.drawn.depth_m.at(2, y) = 1.8F;
  }
  const ViewScore with = score(scene.drawn, scene.truth, scene.classes);
  EXPECT_DOUBLE_EQ(with.silhouette_missing, 1.0 / kSide);
  EXPECT_DOUBLE_EQ(with.silhouette_doubled, 2.0 / kSide);
  EXPECT_DOUBLE_EQ(mean({without, with}).silhouette_missing, 1.0 / kSide);
}

}  // namespace
}  // namespace roomcast::bench
