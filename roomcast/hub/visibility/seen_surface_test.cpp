// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/visibility/seen_surface.h"

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

wire::pb::Intrinsics lens() {
  wire::pb::Intrinsics lens;
  lens.set_width(200);
  lens.set_height(100);
  lens.set_fx(100);
  lens.set_fy(100);
  lens.set_cx(99.5);
  lens.set_cy(49.5);
  return lens;
}

wire::pb::CoarseDepth two_cells(std::uint32_t near_cm, std::uint32_t far_cm) {
  wire::pb::CoarseDepth depth;
  depth.set_columns(2);
  depth.set_rows(1);
  depth.add_near_cm(near_cm);
  depth.add_far_cm(far_cm);
  depth.add_near_cm(0);
  depth.add_far_cm(0);
  return depth;
}

TEST(SeenSurface, is_where_the_cells_centres_are) {
  const RigidTransform world_from_depth{Eigen::Matrix3d::Identity(), {10, 0, 0}};
  const SeenSurface surface = seen_surface(two_cells(200, 400), lens(), world_from_depth);
  ASSERT_EQ(surface.points.size(), 2U) << "the second cell shows nothing";
  EXPECT_LT((surface.points[0].at_m - Eigen::Vector3f(9, 0, 2)).norm(), 1e-4F);
  EXPECT_LT((surface.points[1].at_m - Eigen::Vector3f(8, 0, 4)).norm(), 1e-4F);
  EXPECT_LT((surface.points[0].to_sensor - Eigen::Vector3f(1, 0, -2).normalized()).norm(), 1e-4F);
}

TEST(SeenSurface, a_cell_with_one_surface_has_one_point) {
  EXPECT_EQ(seen_surface(two_cells(200, 205), lens(), {}).points.size(), 1U);
}

TEST(SeenSurface, nonsense_stays_finite) {
  for (const auto& [near_cm, far_cm] : {std::pair(300U, 100U), {1U, 4'294'967'295U}}) {
    for (const SurfacePoint& point : seen_surface(two_cells(near_cm, far_cm), lens(), {}).points) {
      EXPECT_TRUE(point.at_m.allFinite());
      EXPECT_TRUE(point.to_sensor.allFinite());
    }
  }
}

TEST(SeenSurface, a_sensor_sees_points_about_where_its_surfaces_are) {
  const SensorSight sight{two_cells(200, 300), lens(), {}};
  EXPECT_TRUE(sight.sees({-1, 0, 2}));
  EXPECT_TRUE(sight.sees({-1, 0, 3.2F}));
  EXPECT_FALSE(sight.sees({-1, 0, 1.5F})) << "before its surface: empty space";
  EXPECT_FALSE(sight.sees({-1, 0, 4})) << "behind it";
  EXPECT_FALSE(sight.sees({1, 0, 2})) << "where it sees nothing";
  EXPECT_FALSE(sight.sees({-9, 0, 2})) << "beside its picture";
  EXPECT_FALSE(sight.sees({-1, 0, -2}));
  EXPECT_FALSE(SensorSight().sees({0, 0, 2}));
}

TEST(SeenSurface, points_know_who_else_sees_them) {
  SeenSurface surface = seen_surface(two_cells(200, 400), lens(), {});
  const RigidTransform beside{Eigen::Matrix3d::Identity(), {0.2, 0, 0}};
  const SensorSight other{two_cells(200, 200), lens(), beside};
  link_other(SensorId{4}, &other, surface);
  link_other(SensorId{4}, &other, surface);
  ASSERT_EQ(surface.points[0].others.size(), 1U) << "once";
  EXPECT_EQ(surface.points[0].others[0].sensor, SensorId{4});
  EXPECT_TRUE(surface.points[1].others.empty());
  link_other(SensorId{4}, nullptr, surface);
  EXPECT_TRUE(surface.points[0].others.empty());
}

/// Whether the two points of a cell move, after messages with these distances.
std::vector<bool> moves_after(
    const std::vector<std::pair<std::uint32_t, std::uint32_t>>& near_and_far_cm) {
  SeenSurface surface;
  for (const auto& [near_cm, far_cm] : near_and_far_cm)
    surface = seen_surface(two_cells(near_cm, far_cm), lens(), {}, &surface);
  std::vector<bool> moves;
  for (const SurfacePoint& point : surface.points) moves.push_back(point.moves);
  return moves;
}

TEST(SeenSurface, what_changes_its_distance_moves_for_a_while) {
  using Moves = std::vector<bool>;
  EXPECT_EQ(moves_after({{200, 400}}), Moves({false, false})) << "nothing to compare with";
  EXPECT_EQ(moves_after({{200, 400}, {210, 405}}), Moves({false, false})) << "noise";
  EXPECT_EQ(moves_after({{200, 400}, {250, 400}}), Moves({true, false}));
  EXPECT_EQ(moves_after({{200, 400}, {250, 400}, {250, 400}, {250, 400}}), Moves({true, false}));
  EXPECT_EQ(moves_after({{200, 400}, {250, 400}, {250, 400}, {250, 400}, {250, 400}}),
            Moves({false, false}))
      << "it has come to rest";
  EXPECT_EQ(moves_after({{0, 0}, {200, 400}}), Moves({true, true})) << "it has come into view";
}

TEST(SeenSurface, nothing_moves_where_the_cells_are_others) {
  wire::pb::CoarseDepth upright = two_cells(250, 400);
  upright.set_columns(1);
  upright.set_rows(2);
  const SeenSurface before = seen_surface(two_cells(200, 400), lens(), {});
  for (const SurfacePoint& point : seen_surface(upright, lens(), {}, &before).points)
    EXPECT_FALSE(point.moves);
}

}  // namespace
}  // namespace roomcast::hub
