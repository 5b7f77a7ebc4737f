// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/remote_presence.h"

#include <string>

#include <gtest/gtest.h>

#include "roomcast/wire/limits.h"

namespace roomcast::hub {
namespace {

namespace pb = wire::pb;

constexpr RemotePresence::Reporter kHub{ConnectionId{1}, ViewerId{7}}, kOther{ConnectionId{2}};

pb::PeopleHere people_here(std::initializer_list<std::uint32_t> ids) {
  pb::PeopleHere message;
  for (const auto id : ids) {
    message.add_people()->set_id(id);
    message.mutable_people()->rbegin()->set_name("person " + std::to_string(id));
  }
  return message;
}

class RemotePresenceTest : public testing::Test {
 protected:
  RemotePresence::Change report(const RemotePresence::Reporter& reporter,
                                const pb::PeopleHere& reported) {
    return elsewhere.report(reporter, reported, [this] { return ViewerId{++newest}; });
  }
  [[nodiscard]] pb::Roster roster() const {
    pb::Roster roster;
    elsewhere.write_to(roster);
    return roster;
  }

  RemotePresence elsewhere;
  std::uint32_t newest = 100;
};

TEST_F(RemotePresenceTest, each_has_an_id_of_this_room_that_stays) {
  EXPECT_TRUE(report(kHub, people_here({1, 2})).has_changed);
  EXPECT_TRUE(report(kOther, people_here({1})).has_changed);
  EXPECT_EQ(elsewhere.find(ConnectionId{1}, 1), ViewerId{101});
  EXPECT_EQ(elsewhere.find(ConnectionId{2}, 1), ViewerId{103});
  EXPECT_FALSE(report(kHub, people_here({2, 1})).has_changed);
  const auto change = report(kHub, people_here({2}));
  EXPECT_EQ(change.gone, std::vector{ViewerId{101}});
  EXPECT_EQ(elsewhere.find(ConnectionId{1}, 1), std::nullopt);
  EXPECT_EQ(elsewhere.find(ConnectionId{1}, 2), ViewerId{102});
}

TEST_F(RemotePresenceTest, the_roster_says_behind_whom_they_are_and_how_far) {
  auto message = people_here({1});
  message.mutable_people(0)->set_color_rgb(0xFF00FF00);
  message.mutable_people(0)->set_hubs_away(1);
  message.mutable_people(0)->set_through(55);
  report(kHub, message);
  ASSERT_EQ(roster().viewers_size(), 1);
  EXPECT_EQ(roster().viewers(0).name(), "person 1");
  EXPECT_EQ(roster().viewers(0).color_rgb(), 0x00FF00u);
  EXPECT_EQ(roster().viewers(0).hubs_away(), 2u);
  EXPECT_EQ(roster().viewers(0).through(), 7u);
}

TEST_F(RemotePresenceTest, are_removed_with_their_hub) {
  report(kHub, people_here({1, 2}));
  report(kOther, people_here({1}));
  EXPECT_EQ(elsewhere.forget(ConnectionId{1}).gone.size(), 2u);
  EXPECT_FALSE(elsewhere.forget(ConnectionId{1}).has_changed);
  EXPECT_EQ(roster().viewers_size(), 1);
}

TEST_F(RemotePresenceTest, are_so_many_and_no_more_and_from_so_far_away_and_no_farther) {
  pb::PeopleHere many;
  for (std::uint32_t i = 0; i <= wire::kMaxPeopleElsewhere; ++i) many.add_people()->set_id(i);
  report(kHub, many);
  EXPECT_EQ(roster().viewers_size(), int{wire::kMaxPeopleElsewhere});
  EXPECT_FALSE(report(kOther, people_here({1})).has_changed);
  elsewhere.forget(ConnectionId{1});
  EXPECT_TRUE(report(kOther, people_here({1})).has_changed) << "there is room again";
  auto far = people_here({5});
  far.mutable_people(0)->set_hubs_away(wire::kMaxHubsAway);
  EXPECT_FALSE(report(kHub, far).has_changed);
}

TEST_F(RemotePresenceTest, a_full_roster_has_no_place_for_them) {
  report(kHub, people_here({1, 2}));
  pb::Roster full;
  for (std::size_t i = 1; i < wire::kMaxViewers; ++i) full.add_viewers();
  elsewhere.write_to(full);
  EXPECT_EQ(full.viewers_size(), int{wire::kMaxViewers});
}

}  // namespace
}  // namespace roomcast::hub
