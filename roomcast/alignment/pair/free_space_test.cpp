// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/free_space.h"

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/wall_fixture.h"

namespace roomcast::alignment {
namespace {

constexpr double kWallAhead_m = 2;
constexpr std::size_t kEveryPoint = 100'000;
// Points within four pixels of the border of the other picture are not judged. Of a sensor that
// stands at the same place, that is one of 65 columns and two of 52 rows of samples: 5.3 %.
constexpr double kAllButTheBorder = 0.94;

DepthSurface wall_ahead() {
  return wall_surface(wall_depth(kWallAhead_m));
}

FreeSpaceCheck check_walls(const RigidTransform& a_from_b) {
  return check_free_space(wall_ahead(), wall_ahead(), a_from_b, kEveryPoint);
}

RigidTransform moved_ahead(double z_m) {
  RigidTransform a_from_b;
  a_from_b.translation_m.z() = z_m;
  return a_from_b;
}

/// b looks at the same wall from the other side, `apart_m` from the side that a sees.
RigidTransform behind_the_wall(double apart_m) {
  RigidTransform a_from_b;
  a_from_b.rotation = Eigen::Vector3d(-1, 1, -1).asDiagonal();
  a_from_b.translation_m.z() = 2 * kWallAhead_m + apart_m;
  return a_from_b;
}

TEST(FreeSpace, a_wall_where_both_see_it_fits) {
  const FreeSpaceCheck check = check_walls({});
  EXPECT_GT(check.consistent, kAllButTheBorder);
  EXPECT_EQ(check.min_consistent, check.consistent);
  EXPECT_EQ(check.violating, 0);
  EXPECT_EQ(check.occluded, 0);
  EXPECT_EQ(check.conflict(), 0);
}

TEST(FreeSpace, refuses_a_pose_that_puts_a_surface_in_front_of_another) {
  const FreeSpaceCheck check = check_walls(moved_ahead(-0.5));
  EXPECT_EQ(check.consistent, 0);
  // All that a sees is hidden from b by its own wall. Half of the points are a's.
  EXPECT_DOUBLE_EQ(check.occluded, 0.5);
  // b's wall is 1.5 m from a, which sees the middle 3/4 x 3/4 of it.
  EXPECT_NEAR(check.violating, 0.5 * 0.75 * 0.75, 0.02);
  EXPECT_GT(check.conflict(), 0.99);
}

TEST(FreeSpace, a_pose_off_by_ten_centimetres_violates_and_one_off_by_five_does_not) {
  // Eight sigmas of the depth noise are 7.6 cm there: 8 * (4 mm + 1.5 mm * 1.93^2).
  EXPECT_EQ(check_walls(moved_ahead(-0.05)).violating, 0);
  EXPECT_GT(check_walls(moved_ahead(-0.05)).consistent, 0.9);
  EXPECT_GT(check_walls(moved_ahead(-0.1)).conflict(), 0.99);
}

TEST(FreeSpace, a_surface_seen_from_behind_violates) {
  const FreeSpaceCheck check = check_walls(behind_the_wall(0));
  EXPECT_GT(check.violating, kAllButTheBorder);
  EXPECT_EQ(check.consistent, 0);
}

TEST(FreeSpace, the_other_side_of_a_thick_wall_is_hidden) {
  // Hidden beyond five sigmas, 5.3 cm.
  const FreeSpaceCheck check = check_walls(behind_the_wall(0.1));
  EXPECT_GT(check.occluded, kAllButTheBorder);
  EXPECT_EQ(check.violating, 0);
}

TEST(FreeSpace, a_surface_between_both_sides_of_an_edge_is_consistent_with_neither) {
  DepthImage step = wall_depth(kWallAhead_m);
  for (int y = 0; y < step.height(); ++y) {
    for (int x = step.width() / 2; x < step.width(); ++x) step.at(x, y) = 3000;
  }
  const FreeSpaceCheck check =
      check_free_space(wall_surface(step), wall_surface(wall_depth(2.5)), {}, kEveryPoint);
  EXPECT_EQ(check.consistent, 0);
  EXPECT_GT(check.violating, 0.4);  // in front of the right side; the left side in front of it
  EXPECT_GT(check.occluded, 0.4);
}

TEST(FreeSpace, overlap_is_the_smaller_of_both_directions) {
  DepthImage left_half = wall_depth(kWallAhead_m);
  for (int y = 0; y < left_half.height(); ++y) {
    for (int x = left_half.width() / 2; x < left_half.width(); ++x) left_half.at(x, y) = 0;
  }
  const DepthSurface b = wall_surface(left_half);
  const FreeSpaceCheck check = check_free_space(wall_ahead(), b, {}, kEveryPoint);
  EXPECT_NEAR(check.min_consistent, 0.5, 1 - kAllButTheBorder);
  EXPECT_NEAR(check.consistent, 2.0 / 3, 1 - kAllButTheBorder);  // of a's and half as many of b's
  EXPECT_EQ(check_free_space(b, wall_ahead(), {}, kEveryPoint).min_consistent,
            check.min_consistent);
}

TEST(FreeSpace, of_a_view_without_readings_says_nothing) {
  const DepthSurface empty = wall_surface(DepthImage(200, 160));
  const FreeSpaceCheck check = check_free_space(wall_ahead(), empty, {}, kEveryPoint);
  EXPECT_EQ(check.consistent, 0);
  EXPECT_EQ(check.violating, 0);
  EXPECT_EQ(check.occluded, 0);
  EXPECT_EQ(check.conflict(), 0);
}

/// A wall with a square of `side_px` in front of it, in the middle of the picture.
DepthSurface wall_behind_a_square(int side_px) {
  DepthImage depth_mm = wall_depth(kWallAhead_m);
  for (int y = 80 - side_px / 2; y < 80 + side_px / 2; ++y) {
    for (int x = 100 - side_px / 2; x < 100 + side_px / 2; ++x) depth_mm.at(x, y) = 1200;
  }
  return wall_surface(depth_mm);
}

TEST(SolidConflict, counts_the_blocks_of_what_the_other_sensor_looks_through) {
  // Points within three pixels of the edge have no normal: 34 x 34 pixels are left, which fill
  // 8 x 8 blocks of 4 x 4.
  const SolidConflict conflict = check_solid_conflict(wall_behind_a_square(40), wall_ahead(), {});
  EXPECT_EQ(conflict.violating, 64u);
  EXPECT_GT(conflict.consistent, 3000u);  // of 40 x 50 blocks of each picture
  EXPECT_EQ(check_solid_conflict(wall_ahead(), wall_behind_a_square(40), {}).violating, 64u);
}

TEST(SolidConflict, a_thing_of_a_few_pixels_does_not_count) {
  EXPECT_EQ(check_solid_conflict(wall_behind_a_square(8), wall_ahead(), {}).violating, 0u);
}

}  // namespace
}  // namespace roomcast::alignment
