// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/sensor_place.h"

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

namespace pb = wire::pb;

Matrix4 pose_at(double x) {
  return {1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
}

pb::SensorPlacement found_at(double x) {
  pb::SensorPlacement found;
  const Matrix4 pose = pose_at(x);
  found.mutable_world_from_depth()->Assign(pose.begin(), pose.end());
  found.set_expected_error_mm(4);
  return found;
}

pb::SensorRole role_at(double x) {
  pb::SensorRole role;
  const Matrix4 pose = pose_at(x);
  role.mutable_world_from_depth()->Assign(pose.begin(), pose.end());
  return role;
}

TEST(SensorPlace, a_guess_is_not_called_a_placement_and_differs_from_sensor_to_sensor) {
  const auto first = SensorPlace::guessed(SensorId{0}), second = SensorPlace::guessed(SensorId{1});
  EXPECT_EQ(first.placement, pb::PLACEMENT_UNPLACED);
  EXPECT_NE(first.world_from_depth, second.world_from_depth);
}

TEST(SensorPlace, what_is_found_holds_until_something_else_is) {
  auto place = SensorPlace::guessed(SensorId{0});
  EXPECT_TRUE(place.find(found_at(1)));
  EXPECT_TRUE(place.find(found_at(2)));
  EXPECT_EQ(place.world_from_depth, pose_at(2));
  EXPECT_EQ(place.expected_error_mm, 4);
  pb::SensorPlacement lost;
  lost.set_note("it shares nothing");
  EXPECT_FALSE(place.find(lost));
  EXPECT_EQ(place.world_from_depth, pose_at(2));
  EXPECT_EQ(place.note, "it shares nothing");
}

TEST(SensorPlace, what_was_found_can_be_withdrawn) {
  const auto guess = SensorPlace::guessed(SensorId{1});
  auto place = guess;
  EXPECT_TRUE(place.find(found_at(1)));
  pb::SensorPlacement withdrawn;
  withdrawn.set_sensor_id(1);
  withdrawn.set_withdrawn(true);
  withdrawn.set_note("nothing connects it with the others");
  EXPECT_TRUE(place.find(withdrawn));
  EXPECT_EQ(place.placement, pb::PLACEMENT_UNPLACED);
  EXPECT_EQ(place.world_from_depth, guess.world_from_depth);
  EXPECT_FALSE(place.found()) << "nor is it remembered";
  EXPECT_EQ(place.note, "nothing connects it with the others");
  EXPECT_FALSE(place.find(withdrawn)) << "nothing new";
}

TEST(SensorPlace, what_is_given_goes_before_what_is_found) {
  auto place = SensorPlace::guessed(SensorId{0});
  place.recall({pose_at(1), 4});
  EXPECT_EQ(place.placement, pb::PLACEMENT_ALIGNED);
  place.give({});
  EXPECT_EQ(place.world_from_depth, pose_at(1)) << "it says nothing";
  place.give(role_at(5));
  EXPECT_FALSE(place.find(found_at(2)));
  pb::SensorEntry entry;
  place.write_to(entry);
  EXPECT_EQ(entry.placement(), pb::PLACEMENT_GIVEN);
  EXPECT_EQ(entry.world_from_depth(3), 5);
  EXPECT_EQ(entry.expected_error_mm(), 0);
}

}  // namespace
}  // namespace roomcast::hub
