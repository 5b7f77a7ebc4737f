// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/corrected_matches.h"

#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

ColorPicture gray_picture() {
  ColorPicture gray_picture;
  gray_picture.camera = {500, 400, 320, 240};
  // The colour camera is rotated by 90 degrees and 5 cm away from the depth camera.
  gray_picture.color_from_depth_rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  gray_picture.color_from_depth_m = {0.05F, 0, 0};
  return gray_picture;
}

const std::vector<PointMatch> kOne = {{{0.2F, 0.1F, 2}, {-0.3F, 0.4F, 4}, {10, 20}, {30, 40}, 0.5}};

TEST(CorrectedMatches, a_corrected_point_is_seen_where_the_shift_says) {
  const ColorPicture of_a = gray_picture(), of_b = gray_picture();
  PairState state;
  state.a.color_shift_px = {8, -3};
  state.b.color_shift_px = {0, 5};
  const auto moved = corrected_matches(kOne, of_a, of_b, state);
  const auto seen = [](const ColorPicture& gray_picture, const Eigen::Vector3f& point_m) {
    return gray_picture.pixel_of(gray_picture.in_color_frame(point_m));
  };
  const Eigen::Vector2f a = seen(of_a, moved[0].a_m) - seen(of_a, kOne[0].a_m);
  const Eigen::Vector2f b = seen(of_b, moved[0].b_m) - seen(of_b, kOne[0].b_m);
  EXPECT_LT((a - Eigen::Vector2f(8, -3)).norm(), 1e-3F);
  EXPECT_LT((b - Eigen::Vector2f(0, 5)).norm(), 1e-3F);
  EXPECT_NEAR(moved[0].a_m.z(), 2, 1e-6F);
}

TEST(CorrectedMatches, without_a_shift_all_stays_as_it_is) {
  const auto moved = corrected_matches(kOne, gray_picture(), gray_picture(), {});
  EXPECT_EQ(moved[0].a_m, kOne[0].a_m);
  EXPECT_EQ(moved[0].b_m, kOne[0].b_m);
  EXPECT_EQ(moved[0].a_pixel, kOne[0].a_pixel);
  EXPECT_EQ(moved[0].weight, kOne[0].weight);
}

}  // namespace
}  // namespace roomcast::alignment
