// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/visibility/view_visibility.h"

#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

constexpr float kRightAngle = std::numbers::pi_v<float> / 2;

/// A wall around the origin that faces +z, seen by a sensor there, 3 m away.
SeenSurface wall() {
  SeenSurface surface;
  for (int x = -2; x <= 2; ++x) {
    const Eigen::Vector3f at_m(0.2F * static_cast<float>(x), 1, 0);
    surface.points.push_back({at_m, (Eigen::Vector3f(0, 1, 3) - at_m).normalized()});
  }
  return surface;
}

/// At this place, looking at the middle of the wall after a turn about the vertical.
ViewCone viewer(const Eigen::Vector3f& eye_m, float turned_rad = 0) {
  const Eigen::Vector3f ahead = (Eigen::Vector3f(0, 1, 0) - eye_m).normalized();
  return {eye_m,
          Eigen::AngleAxisf(turned_rad, Eigen::Vector3f::UnitY()) * ahead,
          {.half_angle_rad = 0.7}};
}

Detail needed(const std::vector<ViewCone>& views) {
  return needed_detail(wall(), views, {});
}

TEST(ViewVisibility, what_is_in_view_is_needed) {
  EXPECT_EQ(needed({viewer({0, 1.6F, 2})}), Detail::kAll);
  EXPECT_EQ(needed({viewer({2, 1.6F, 0.5F})}), Detail::kAll) << "from the side";
}

TEST(ViewVisibility, what_is_beside_the_view_is_needed_less_the_farther_it_is) {
  EXPECT_EQ(needed({viewer({0, 1, 2}, 0.75F)}), Detail::kAll) << "just outside";
  EXPECT_EQ(needed({viewer({0, 1, 2}, 1.2F)}), Detail::kBaseOnly);
  EXPECT_EQ(needed({viewer({0, 1, 2}, 2 * kRightAngle)}), Detail::kPaused) << "behind him";
}

TEST(ViewVisibility, what_faces_the_other_way_is_not_needed) {
  EXPECT_EQ(needed({viewer({0, 1, -2})}), Detail::kPaused);
  EXPECT_EQ(needed({viewer({2, 1, -1.3F})}), Detail::kBaseOnly) << "nearly from the side";
}

TEST(ViewVisibility, what_another_sensor_shows_better_is_needed_in_its_base) {
  SeenSurface surface = wall();
  const ViewCone from_the_left = viewer({-2, 1, 1});
  for (SurfacePoint& point : surface.points) {
    const Eigen::Vector3f to_other = Eigen::Vector3f(-3, 0, 1).normalized();
    point.others.push_back({SensorId{5}, to_other});
  }
  EXPECT_EQ(needed_detail(surface, {from_the_left}, {}), Detail::kBaseOnly);
  EXPECT_EQ(needed_detail(surface, {viewer({0, 1, 2})}, {}), Detail::kAll) << "seen from this side";
  for (SurfacePoint& point : surface.points) point.moves = true;
  EXPECT_EQ(needed_detail(surface, {from_the_left}, {}), Detail::kAll) << "it moves";
}

TEST(ViewVisibility, a_person_in_few_cells_is_enough) {
  SeenSurface surface = wall();
  for (int i = 0; i < 100; ++i)  // behind the viewer
    surface.points.push_back({{0, 1, 9}, {0, 0, -1}});
  EXPECT_EQ(needed_detail(surface, {viewer({0, 1, 2})}, {}), Detail::kBaseOnly) << "one in twenty";
  for (std::size_t i = 0; i < 4; ++i) surface.points[i].moves = true;
  EXPECT_EQ(needed_detail(surface, {viewer({0, 1, 2})}, {}), Detail::kAll);
}

TEST(ViewVisibility, what_comes_into_view_is_needed) {
  EXPECT_EQ(needed({viewer({0, 1, 2}, 2 * kRightAngle), viewer({0, 1, 2})}), Detail::kAll);
}

TEST(ViewVisibility, a_viewer_who_sees_all_around_needs_what_faces_him) {
  ViewCone around = viewer({0, 1, 2}, 2 * kRightAngle);
  around.angles.half_angle_rad = std::numbers::pi;
  EXPECT_EQ(needed({around}), Detail::kAll);
}

TEST(ViewVisibility, what_is_above_a_wide_picture_is_needed_less) {
  ViewCone above = viewer({0, 1, 2});
  const Eigen::AngleAxisf raised(0.8F, Eigen::Vector3f::UnitX());
  above.forward = raised * above.forward;
  above.up = raised * Eigen::Vector3f::UnitY();
  above.angles = {.half_angle_rad = 0.9};
  EXPECT_EQ(needed({above}), Detail::kAll) << "as far as is known";
  above.angles = {.half_angle_rad = 0.9, .half_width_rad = 0.8, .half_height_rad = 0.5};
  EXPECT_EQ(needed({above}), Detail::kBaseOnly);
}

TEST(ViewVisibility, what_is_at_hand_is_needed) {
  EXPECT_EQ(needed({viewer({0, 1, -0.1F}, 2 * kRightAngle)}), Detail::kAll);
}

TEST(ViewVisibility, a_surface_without_points_is_not_needed) {
  EXPECT_EQ(needed_detail({}, {viewer({0, 1, 2})}, {}), Detail::kPaused);
}

}  // namespace
}  // namespace roomcast::hub
