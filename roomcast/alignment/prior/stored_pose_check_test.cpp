// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/prior/stored_pose_check.h"

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/views_fixture.h"

namespace roomcast::alignment {
namespace {

/// The check of both sensors if this is the stored pose of the second.
StoredPoseCheck recalled(const ViewFixture& a, const ViewFixture& b,
                         const RigidTransform& world_from_b) {
  return stored_pose_check(candidates_of(*a.view, *b.view), a.world_from_depth, world_from_b);
}

TEST(StoredPoseCheck, who_stands_where_it_did_is_confirmed) {
  const auto told = recalled(first_corner(), second_corner(), second_corner().world_from_depth);
  EXPECT_EQ(told.verdict, StoredPoseVerdict::kConfirmed);
  EXPECT_GT(told.expected_error_mm, 0);
  EXPECT_LT(told.expected_error_mm, 20);
}

TEST(StoredPoseCheck, who_was_moved_across_the_room_is_contradicted) {
  const auto told = recalled(first_corner(), second_corner(), third_corner().world_from_depth);
  EXPECT_EQ(told.verdict, StoredPoseVerdict::kContradicted);
  EXPECT_NE(told.contradiction, Contradiction::kNone);
}

TEST(StoredPoseCheck, who_was_turned_is_contradicted) {
  const auto turned = beside(second_corner().world_from_depth, {0, 0, 0}, 0.3);
  EXPECT_EQ(recalled(first_corner(), second_corner(), turned).verdict,
            StoredPoseVerdict::kContradicted);
}

TEST(StoredPoseCheck, a_few_centimetres_are_no_confirmation) {
  const auto pushed = beside(second_corner().world_from_depth, {0.05, 0, -0.04}, 0);
  EXPECT_NE(recalled(first_corner(), second_corner(), pushed).verdict,
            StoredPoseVerdict::kConfirmed);
}

TEST(StoredPoseCheck, where_nothing_is_shared_nothing_is_told) {
  const auto far = beside(second_corner().world_from_depth, {40, 0, 0}, 0);
  EXPECT_EQ(recalled(first_corner(), second_corner(), far).verdict,
            StoredPoseVerdict::kInconclusive);
}

/// A long grey corridor, lit from one side.
ViewFixture in_corridor(const std::string& name, double x_m) {
  RoomFixture corridor;
  corridor.walls = {Eigen::Vector3d(-30, 0, -2), Eigen::Vector3d(30, 2.6, 1.8)};
  corridor.boxes.clear();
  const auto pose = world_from_optical_looking_at({x_m, 1.7, -1.6}, {0.3 * x_m, 0.6, 1});
  auto view = make_sensor_view(without_pattern(bundle_fixture(corridor, name, pose)));
  ROOMCAST_ASSERT(view.ok());
  return {pose, std::make_shared<const SensorView>(*std::move(view))};
}

TEST(StoredPoseCheck, along_a_bare_wall_nothing_tells_whether_it_was_moved) {
  const ViewFixture a = in_corridor("a", -1), b = in_corridor("b", 1);
  EXPECT_EQ(recalled(a, b, b.world_from_depth).verdict, StoredPoseVerdict::kInconclusive);
  EXPECT_EQ(recalled(a, b, beside(b.world_from_depth, {0.5, 0, 0}, 0)).verdict,
            StoredPoseVerdict::kInconclusive);
}

}  // namespace
}  // namespace roomcast::alignment
