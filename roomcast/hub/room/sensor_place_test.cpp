// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/sensor_place.h"

#include <gtest/gtest.h>

#include "roomcast/wire/pose_message.h"

namespace roomcast::hub {
namespace {

namespace pb = wire::pb;

RigidTransform place_at(double x) {
  return {Eigen::Matrix3d::Identity(), {x, 0, 0}};
}

pb::SensorPlacement found_at(double x) {
  pb::SensorPlacement found;
  wire::write_transform(place_at(x), *found.mutable_world_from_depth());
  found.set_expected_error_mm(4);
  return found;
}

pb::SensorRole role_at(double x) {
  pb::SensorRole role;
  wire::write_transform(place_at(x), *role.mutable_world_from_depth());
  return role;
}

TEST(SensorPlace, a_guess_is_not_called_a_placement_and_differs_from_sensor_to_sensor) {
  const auto first = SensorPlace::guessed(0), second = SensorPlace::guessed(1);
  EXPECT_EQ(first.placement, pb::PLACEMENT_UNPLACED);
  EXPECT_NE(first.world_from_depth.translation_m, second.world_from_depth.translation_m);
}

TEST(SensorPlace, a_guess_lies_well_outside_of_where_the_placed_ones_stand) {
  const RigidTransform placed[] = {place_at(-7), place_at(4), place_at(1)};
  EXPECT_GE(SensorPlace::guessed(0, placed).world_from_depth.translation_m.x(), 9);
  EXPECT_GE(SensorPlace::guessed(1, placed).world_from_depth.translation_m.x(), 12);
}

TEST(SensorPlace, what_is_found_holds_until_something_else_is) {
  auto place = SensorPlace::guessed(0);
  EXPECT_TRUE(place.find(found_at(1)));
  EXPECT_TRUE(place.find(found_at(2)));
  EXPECT_EQ(place.world_from_depth.translation_m.x(), 2);
  EXPECT_EQ(place.expected_error_mm, 4);
  pb::SensorPlacement lost;
  lost.set_note("it shares nothing");
  EXPECT_FALSE(place.find(lost));
  EXPECT_EQ(place.world_from_depth.translation_m.x(), 2);
  EXPECT_EQ(place.note, "it shares nothing");
}

TEST(SensorPlace, what_was_found_can_be_withdrawn) {
  auto place = SensorPlace::guessed(1);
  EXPECT_TRUE(place.find(found_at(1)));
  pb::SensorPlacement withdrawn;
  withdrawn.set_sensor_id(1);
  withdrawn.set_withdrawn(true);
  withdrawn.set_note("nothing connects it with the others");
  EXPECT_TRUE(place.find(withdrawn));
  EXPECT_EQ(place.placement, pb::PLACEMENT_UNPLACED);
  EXPECT_FALSE(place.found()) << "nor is it remembered";
  EXPECT_EQ(place.note, "nothing connects it with the others");
  EXPECT_FALSE(place.find(withdrawn)) << "nothing new";
}

TEST(SensorPlace, what_was_found_before_a_restart_is_unverified_until_it_is_found_again) {
  auto place = SensorPlace::guessed(0);
  place.recall({place_at(1), 4});
  EXPECT_TRUE(place.unverified);
  pb::SensorPlacement unknown;
  unknown.set_note("nothing to compare it with");
  EXPECT_FALSE(place.find(unknown));
  EXPECT_TRUE(place.unverified);
  EXPECT_TRUE(place.find(found_at(1)));
  EXPECT_FALSE(place.unverified);
}

TEST(SensorPlace, who_was_away_may_have_been_moved_and_what_it_saw_before_does_not_tell) {
  auto place = SensorPlace::guessed(0);
  EXPECT_TRUE(place.find(found_at(1)));
  place.doubt(2);
  EXPECT_TRUE(place.unverified);
  auto found = found_at(1);
  found.set_bundle_number(1);
  EXPECT_FALSE(place.find(found));
  EXPECT_TRUE(place.unverified);
  found.set_bundle_number(2);
  EXPECT_TRUE(place.find(found));
  EXPECT_FALSE(place.unverified);
}

TEST(SensorPlace, what_one_hub_has_not_verified_the_other_has_not_either) {
  auto place = SensorPlace::guessed(0);
  auto found = found_at(1);
  found.set_unverified(true);
  EXPECT_TRUE(place.find(found));
  pb::SensorEntry entry;
  place.write_to(entry);
  EXPECT_TRUE(entry.unverified());
}

TEST(SensorPlace, a_pose_that_was_given_needs_nobody_who_verifies_it) {
  auto place = SensorPlace::guessed(0);
  place.recall({place_at(1), 4});
  place.give(role_at(5));
  EXPECT_FALSE(place.unverified);
  place.doubt(1);
  EXPECT_FALSE(place.unverified);
}

TEST(SensorPlace, a_pose_that_is_found_again_keeps_its_very_numbers) {
  auto place = SensorPlace::guessed(0);
  EXPECT_TRUE(place.find(found_at(1)));
  EXPECT_TRUE(place.find(found_at(1 + 1e-13)));
  EXPECT_EQ(place.world_from_depth.translation_m.x(), 1);
  EXPECT_TRUE(place.find(found_at(1.001)));
  EXPECT_EQ(place.world_from_depth.translation_m.x(), 1.001);
}

TEST(SensorPlace, what_is_given_goes_before_what_is_found) {
  auto place = SensorPlace::guessed(0);
  place.recall({place_at(1), 4});
  EXPECT_EQ(place.placement, pb::PLACEMENT_ALIGNED);
  place.give({});
  EXPECT_EQ(place.world_from_depth.translation_m.x(), 1) << "it says nothing";
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
