// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/reprojected_views.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "roomcast/alignment/pair/wall_matches_fixture.h"

namespace roomcast::alignment {
namespace {

ReprojectedViews reprojected(const SensorView& from, const SensorView& other,
                             const RigidTransform& other_from_view) {
  return reprojected_views(CorrectedView(from, {}), CorrectedView(other, {}), other_from_view);
}

TEST(ReprojectedViews, show_the_same_greys_of_the_same_wall) {
  const SensorView a = wall_view({}, 0);
  const ReprojectedViews common = reprojected(a, a, {});
  EXPECT_EQ(common.width, 100);
  EXPECT_EQ(common.height, 80);
  EXPECT_EQ(common.count, a.texture.points.size());
  EXPECT_EQ(common.count, static_cast<std::size_t>(std::ranges::count(common.known, 1)));
  EXPECT_EQ(common.mine, common.theirs);
}

TEST(ReprojectedViews, know_only_what_the_other_view_shows) {
  // b stands 0.5 m to the right. At 2 m the left edge of its picture is at
  // 0.5 - 2 * 99.5 / 145 = -0.872 m, which is pixel 36.25 of a's depth.
  const ReprojectedViews common =
      reprojected(wall_view({}, 0), wall_view({}, 0.5), wall_pose(0.5, 0));
  constexpr int kMiddleRow = 40;
  EXPECT_FALSE(common.known[common.place(18, kMiddleRow)]);
  EXPECT_TRUE(common.known[common.place(22, kMiddleRow)]);  // the colour's rim is four pixels wide
}

TEST(ReprojectedViews, leave_out_what_is_hidden_or_not_there) {
  const SensorView at_2_m = wall_view({.z_m = 2}, 0);
  EXPECT_EQ(reprojected(at_2_m, wall_view({.z_m = 1.5}, 0), {}).count, 0u);
  EXPECT_EQ(reprojected(at_2_m, wall_view({.z_m = 2.5}, 0), {}).count, 0u);
  // Ten sigmas of the depth noise at 2 m are 10 cm.
  EXPECT_GT(reprojected(at_2_m, wall_view({.z_m = 2.05}, 0), {}).count, 0u);
  const SensorView dark = featureless_view("dark", DepthImage(200, 160), wall_color({}, 0));
  EXPECT_EQ(reprojected(at_2_m, dark, {}).count, 0u);
  EXPECT_EQ(reprojected(dark, at_2_m, {}).count, 0u);
}

TEST(CorrectedView, looks_the_colour_up_where_the_shift_says) {
  const SensorView view = wall_view({}, 0);
  SensorCorrection correction;
  correction.color_shift_px = {5, -3};
  const CorrectedView corrected(view, correction);
  const Eigen::Vector3f point_m(0.2F, 0.1F, 2);
  const Eigen::Vector2f pixel = view.picture.pixel_of(point_m) - Eigen::Vector2f(5, -3);
  EXPECT_EQ(corrected.grey_of(point_m), texture_grey(view.texture, pixel));
  EXPECT_EQ(corrected.tint_of(point_m), texture_tint(view.texture, pixel));
  EXPECT_NE(corrected.grey_of(point_m), CorrectedView(view, {}).grey_of(point_m));
}

TEST(CorrectedView, knows_no_grey_behind_the_camera_or_outside_its_picture) {
  const SensorView view = wall_view({}, 0);
  const CorrectedView corrected(view, {});
  EXPECT_FALSE(corrected.grey_of(Eigen::Vector3f(0, 0, -2)).has_value());
  EXPECT_FALSE(corrected.grey_of(Eigen::Vector3f(3, 0, 2)).has_value());
  EXPECT_TRUE(corrected.grey_of(Eigen::Vector3f(0, 0, 2)).has_value());
}

/// A 7 x 5 grid whose greys are all different and of which every fourth place is unknown.
ReprojectedViews small_grid() {
  ReprojectedViews grid(7, 5);
  for (std::size_t i = 0; i < grid.mine.size(); ++i) {
    grid.mine[i] = static_cast<float>(i);
    grid.theirs[i] = static_cast<float>(i * i % 17);
    grid.known[i] = i % 4 != 3;
  }
  return grid;
}

TEST(WindowSums, are_those_of_the_known_places_in_the_window) {
  const ReprojectedViews grid = small_grid();
  const WindowSums windows(grid);
  for (const auto& [x, y] : {std::pair(3, 2), std::pair(0, 0), std::pair(6, 4)}) {
    ReprojectionSums expected{};
    for (int v = std::max(0, y - 1); v <= std::min(4, y + 1); ++v) {
      for (int u = std::max(0, x - 1); u <= std::min(6, x + 1); ++u) {
        const std::size_t i = grid.place(u, v);
        if (grid.known[i]) add_place(grid.mine[i], grid.theirs[i], expected);
      }
    }
    EXPECT_EQ(windows.around(x, y, 1), expected) << x << ", " << y;  // exact: small integers
  }
}

TEST(WindowContrast, is_the_deviation_of_either_picture_and_their_covariance) {
  ReprojectionSums sums{};
  add_place(1, 2, sums);
  add_place(3, 6, sums);
  const WindowContrast contrast(sums);
  EXPECT_DOUBLE_EQ(contrast.mine, 1);
  EXPECT_DOUBLE_EQ(contrast.theirs, 2);
  EXPECT_DOUBLE_EQ(contrast.together, 2);
  EXPECT_DOUBLE_EQ(contrast.correlation(), 2.0 / (1 * 2 + 6));  // lowered by the noise
}

}  // namespace
}  // namespace roomcast::alignment
