// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/photo_consistency.h"

#include <gtest/gtest.h>

#include "roomcast/alignment/pair/wall_matches_fixture.h"

namespace roomcast::alignment {
namespace {

// The print's standard deviation is 200 / sqrt(12) = 58 greys, and no less than 30 where blurred.
// The noise in the denominator, 6, then costs less than one part in a hundred.
constexpr double kSamePrint = 0.95;
// Windows of 11 x 11 grid points, 30 cm wide, hold 25 cells of the print. So their correlations are
// 0.2 at random, and the mean over the view's sixty windows is 0.03.
constexpr double kByChance = 0.15;

PhotoConsistency consistency_of(const SensorView& a, const SensorView& b,
                                const RigidTransform& a_from_b) {
  return check_photo_consistency(a, b, {a_from_b, {}, {}});
}

TEST(PhotoConsistency, the_same_print_agrees) {
  const SensorView a = wall_view({}, 0), b = wall_view({}, 0.3);
  const PhotoConsistency right = consistency_of(a, b, wall_pose(0, 0.3));
  EXPECT_GT(right.correlation, kSamePrint);
  // At 2 m the views are 2.7 m wide, of which 2.4 m are common.
  EXPECT_NEAR(right.textured, 2.4 / 2.7, 0.05);
}

TEST(PhotoConsistency, a_pose_off_by_ten_centimetres_along_the_wall_does_not) {
  const SensorView a = wall_view({}, 0), b = wall_view({}, 0.3);
  const PhotoConsistency aside = consistency_of(a, b, wall_pose(0, 0.4));
  EXPECT_LT(aside.correlation, kByChance);
  EXPECT_GT(aside.textured, 0.7);
}

TEST(PhotoConsistency, another_print_does_not_agree) {
  const PhotoConsistency other =
      consistency_of(wall_view({.looks = 1}, 0), wall_view({.looks = 2}, 0), {});
  EXPECT_NEAR(other.correlation, 0, kByChance);
}

TEST(PhotoConsistency, the_negative_of_a_print_is_its_opposite) {
  const PhotoConsistency negative =
      consistency_of(wall_view({}, 0), wall_view({.contrast = -1}, 0), {});
  EXPECT_LT(negative.correlation, -kSamePrint);
}

TEST(PhotoConsistency, half_the_exposure_changes_nothing) {
  const PhotoConsistency dim =
      consistency_of(wall_view({}, 0), wall_view({.contrast = 0.5}, 0), {});
  EXPECT_GT(dim.correlation, kSamePrint);
}

TEST(PhotoConsistency, a_plain_wall_says_nothing) {
  const PhotoConsistency plain =
      consistency_of(wall_view({.contrast = 0}, 0), wall_view({.contrast = 0}, 0), {});
  EXPECT_EQ(plain.textured, 0);
  EXPECT_EQ(plain.correlation, 0);
}

TEST(PhotoConsistency, faint_prints_weigh_less) {
  // A twentieth of the contrast: at most 3 greys, below the least contrast that counts. A fifth: 12
  // of the 25 greys of full weight, less what blur takes.
  const auto textured = [](double contrast) {
    const SensorView view = wall_view({.contrast = contrast}, 0);
    return consistency_of(view, view, {}).textured;
  };
  EXPECT_EQ(textured(0.05), 0);
  EXPECT_GT(textured(0.2), 0.2);
  EXPECT_LT(textured(0.2), 12.0 / 25);
  EXPECT_GT(textured(1), 0.95);
}

TEST(PhotoConsistency, what_stands_in_front_of_a_print_is_not_compared_with_it) {
  const PhotoConsistency apart =
      consistency_of(wall_view({.z_m = 2}, 0), wall_view({.z_m = 1.5}, 0), {});
  EXPECT_EQ(apart.textured, 0);
}

TEST(PhotoConsistency, of_views_that_share_nothing_there_is_none) {
  const SensorView a = wall_view({}, 0), b = wall_view({}, 5);
  EXPECT_EQ(consistency_of(a, b, wall_pose(0, 5)).textured, 0);
  EXPECT_EQ(consistency_of(a, b, wall_pose(0, 5)).correlation, 0);
}

TEST(PhotoConsistency, a_colour_shift_that_is_corrected_costs_nothing) {
  // Ten pixels are 7 cm on the wall, more than a cell of the print.
  constexpr double kAside_px = 10;
  const SensorView a = wall_view({}, 0);
  const SensorView b = featureless_view("b", wall_depth(2), wall_color({}, -kAside_px * 2 / 290));
  PairState state;
  EXPECT_LT(check_photo_consistency(a, b, state).correlation, 0.5);
  state.b.color_shift_px.x() = -kAside_px;  // true place = seen place + shift
  EXPECT_GT(check_photo_consistency(a, b, state).correlation, kSamePrint);
}

}  // namespace
}  // namespace roomcast::alignment
