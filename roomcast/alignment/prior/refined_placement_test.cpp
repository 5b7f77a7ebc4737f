// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/prior/refined_placement.h"

#include <array>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/views_fixture.h"

namespace roomcast::alignment {
namespace {

constexpr double kOfWalk_mm = 30;

std::optional<EstimatedPlacement> settled(const RigidTransform& found, double expected_error_mm) {
  const std::array placed = {
      PlacedView{first_corner().view.get(), first_corner().world_from_depth}};
  return refined_placement(*second_corner().view, {found, expected_error_mm}, placed);
}

TEST(SettledPlace, what_a_walk_found_becomes_more_exact_by_what_both_see) {
  const RigidTransform truth = second_corner().world_from_depth;
  const auto place = settled(beside(truth, {0.03, 0, -0.02}, 0.008), kOfWalk_mm);
  ASSERT_TRUE(place);
  EXPECT_LT((place->world_from_depth.translation_m - truth.translation_m).norm(), 0.012);
  EXPECT_LT(place->expected_error_mm, kOfWalk_mm);
  EXPECT_GT(place->expected_error_mm, 0);
}

TEST(SettledPlace, the_more_exactly_a_place_was_found_the_less_it_moves) {
  const RigidTransform found = beside(second_corner().world_from_depth, {0.004, 0, -0.003}, 0);
  const auto loose = settled(found, 100), tight = settled(found, 3);
  ASSERT_TRUE(loose && tight);
  const auto moved = [&](const std::optional<EstimatedPlacement>& place) {
    return (place->world_from_depth.translation_m - found.translation_m).norm();
  };
  EXPECT_LT(moved(tight), moved(loose));
}

TEST(SettledPlace, surfaces_that_say_something_else_than_the_walk_are_not_followed) {
  const RigidTransform truth = second_corner().world_from_depth;
  EXPECT_FALSE(settled(beside(truth, {0.05, 0, -0.04}, 0), 10)) << "six sigmas";
}

TEST(SettledPlace, where_nothing_is_shared_it_stays_as_it_was_found) {
  EXPECT_FALSE(settled(beside(second_corner().world_from_depth, {40, 0, 0}, 0), kOfWalk_mm));
  EXPECT_FALSE(refined_placement(*first_corner().view, {{}, kOfWalk_mm}, {}));
}

/// A long grey corridor, lit from one side. Each sensor sees a different part of its walls.
ViewFixture facing_along_corridor(const std::string& name, double x_m, double towards_m) {
  RoomFixture corridor;
  corridor.walls = {Eigen::Vector3d(-30, 0, -1.2), Eigen::Vector3d(30, 2.6, 1.2)};
  corridor.boxes.clear();
  const RigidTransform pose =
      world_from_optical_looking_at({x_m, 1.6, 0.1 * x_m}, {towards_m, 0.6, 1.1});
  auto view = make_sensor_view(without_pattern(bundle_fixture(corridor, name, pose)));
  ROOMCAST_ASSERT(view.ok());
  return {pose, std::make_shared<const SensorView>(*std::move(view))};
}

TEST(SettledPlace, along_a_floor_that_is_all_they_share_it_stays_where_it_was_found) {
  const ViewFixture a = facing_along_corridor("a", -1.5, 0.3),
                    b = facing_along_corridor("b", 1.5, -0.3);
  const std::array placed = {PlacedView{a.view.get(), a.world_from_depth}};
  const EstimatedPlacement found{beside(b.world_from_depth, {0.03, 0.02, 0.03}, 0.005), kOfWalk_mm};
  const auto place = refined_placement(*b.view, found, placed);
  ASSERT_TRUE(place);
  const Eigen::Vector3d off =
      place->world_from_depth.translation_m - b.world_from_depth.translation_m;
  EXPECT_NEAR(off.y(), 0, 0.005) << "the floor tells";
  EXPECT_NEAR(off.x(), 0.03, 0.01);
  EXPECT_NEAR(off.z(), 0.03, 0.01);
  EXPECT_GT(place->expected_error_mm, kOfWalk_mm) << "and it is known no better";
}

}  // namespace
}  // namespace roomcast::alignment
