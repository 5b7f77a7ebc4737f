// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/mirror/presence_relay.h"

#include <string>

#include <gtest/gtest.h>

#include "roomcast/wire/limits.h"

namespace roomcast::hub::federation {
namespace {

namespace wpb = wire::pb;

wpb::ViewerEntry& add(wpb::Roster& roster, std::uint32_t id, const std::string& name = "Ada") {
  wpb::ViewerEntry& entry = *roster.add_viewers();
  entry.set_id(id);
  entry.set_name(name);
  return entry;
}

wpb::ViewerPoses poses_of(std::initializer_list<std::uint32_t> ids) {
  wpb::ViewerPoses poses;
  for (const auto id : ids) poses.add_poses()->set_viewer_id(id);
  return poses;
}

TEST(PresenceRelay, reports_people_here_and_behind_relays_here_only) {
  wpb::Roster roster;
  add(roster, 1);
  add(roster, 2, "hub").set_relays(true);
  auto& behind = add(roster, 3, "behind it");
  behind.set_hubs_away(1);
  behind.set_through(2);
  add(roster, 4, "from there").set_hubs_away(1);
  PresenceRelay people;
  EXPECT_TRUE(people.take(roster));
  ASSERT_EQ(people.people().people_size(), 2);
  EXPECT_EQ(people.people().people(0).id(), 1u);
  EXPECT_EQ(people.people().people(1).name(), "behind it");
  EXPECT_EQ(people.people().people(1).through(), 0u) << "it means nothing there";
}

TEST(PresenceRelay, another_order_is_no_change) {
  wpb::Roster one, other;
  add(one, 1), add(one, 2);
  add(other, 2), add(other, 1);
  PresenceRelay people;
  EXPECT_TRUE(people.take(one));
  EXPECT_FALSE(people.take(other));
}

TEST(PresenceRelay, keeps_the_newest_pose_of_each_person) {
  wpb::Roster roster;
  add(roster, 1), add(roster, 2);
  PresenceRelay people;
  people.take(roster);
  EXPECT_EQ(people.take(poses_of({1, 2, 3})).poses_size(), 2);
  EXPECT_EQ(people.take(poses_of({1})).poses_size(), 1);
  EXPECT_EQ(people.newest_poses().poses_size(), 2);
  people.take(wpb::Roster());
  EXPECT_EQ(people.newest_poses().poses_size(), 0);
}

TEST(PresenceRelay, limits_the_number_of_people) {
  wpb::Roster roster;
  for (int i = 0; i <= wire::kMaxPeopleHere; ++i) add(roster, static_cast<unsigned>(i + 1));
  PresenceRelay people;
  people.take(roster);
  EXPECT_EQ(people.people().people_size(), wire::kMaxPeopleHere);
}

TEST(PeopleThere, exclude_us_people_behind_us_and_hubs) {
  wpb::Roster roster;
  add(roster, 1);
  add(roster, 2, "us");
  add(roster, 3, "behind us").set_through(2);
  add(roster, 4, "another hub").set_relays(true);
  add(roster, 5, "behind it").set_through(4);
  const auto there = people_there(roster, 2);
  ASSERT_EQ(there.people_size(), 2);
  EXPECT_EQ(there.people(0).id(), 1u);
  EXPECT_EQ(there.people(1).name(), "behind it");
}

}  // namespace
}  // namespace roomcast::hub::federation
