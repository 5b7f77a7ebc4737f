// SPDX-License-Identifier: Apache-2.0
// Two hubs with a sensor each: one estimates the poses, and both show them.
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/hub/federation/cluster/shared_room.h"
#include "roomcast/hub/federation/mirror/room_here_fixture.h"

namespace roomcast::hub::federation {
namespace {

namespace wpb = wire::pb;
using hub::federation::RoomHere;
using hub::federation::sensor_there;
using namespace std::chrono_literals;

constexpr HubId kOwner{3}, kOther{8};

wpb::SensorEntry aligned(std::uint32_t id, const std::string& name, double x_m) {
  auto entry = sensor_there(id, name, wpb::PLACEMENT_ALIGNED);
  entry.set_world_from_depth(3, x_m);
  entry.set_expected_error_mm(4);
  return entry;
}

/// A hub that passes its messages to the other one immediately.
class Hub final : public SharedRoomOut {
 public:
  explicit Hub(HubId id) : id_(id) {
    room.ensure_joined();
    welcome(0, 0);
  }
  void broadcast_news(const pb::RoomNews& news) override {
    if (other != nullptr) other->room.on_news(news);
  }
  void send_to(HubId, const pb::ToHub& message) override {
    sent_to_other.push_back(message);
    if (other != nullptr) other->room.on_message(message);
  }
  void broadcast_poses(const std::string&, const pb::PeopleMoved&) override {}
  void welcome(std::size_t n, std::uint32_t id) {
    wpb::Control control;
    control.mutable_welcome()->set_sensor_id(id);
    room.on_room_message(here.joins.at(n).first, control);
  }
  void hear(const wpb::Control& control) { room.on_room_message(aligner(), control); }
  void roster(std::initializer_list<wpb::SensorEntry> sensors) {
    wpb::Control control;
    for (const auto& sensor : sensors) *control.mutable_roster()->add_sensors() = sensor;
    hear(control);
  }
  ConnectionId aligner() const {
    ConnectionId newest;
    for (const auto& [connection, join] : here.joins) {
      if (join.has_aligner()) newest = connection;
    }
    return newest;
  }

  RoomHere here;
  Hub* other = nullptr;
  std::vector<pb::ToHub> sent_to_other;

 private:
  const HubId id_;

 public:
  SharedRoom room{{.own = id_,
                   .room = "lab",
                   .token = "own",
                   .rooms = here,
                   .new_connection = unread_connections(),
                   .out = *this}};
};

class SharedRoomPlacing : public testing::Test {
 protected:
  SharedRoomPlacing() {
    owner.other = &other;
    other.other = &owner;
    for (Hub* hub : {&owner, &other}) hub->room.set_owner(kOwner);
    owner.room.sensor_joins("a", "");
    other.room.sensor_joins("b", "");
    owner.roster({sensor_there(0, "a", wpb::PLACEMENT_UNPLACED)});
    other.roster({sensor_there(0, "b", wpb::PLACEMENT_UNPLACED)});
    owner.welcome(1, 1);  // "b" is number 1 there
    other.welcome(1, 1);  // and "a" here
    owner.roster({sensor_there(0, "a", wpb::PLACEMENT_UNPLACED),
                  sensor_there(1, "b", wpb::PLACEMENT_UNPLACED)});
    other.roster({sensor_there(0, "b", wpb::PLACEMENT_UNPLACED),
                  sensor_there(1, "a", wpb::PLACEMENT_UNPLACED)});
    for (Hub* hub : {&owner, &other}) hub->here.controls.clear();
  }
  Hub owner{kOwner}, other{kOther};
};

TEST_F(SharedRoomPlacing, bundles_are_forwarded_to_the_owner) {
  wpb::Control bundle;
  bundle.mutable_calibration_bundle()->set_sensor_id(0);
  bundle.mutable_calibration_bundle()->set_depth("d");
  bundle.mutable_calibration_bundle()->set_color_jpeg("c");
  other.hear(bundle);
  ASSERT_EQ(owner.here.controls.size(), 1u);
  EXPECT_EQ(owner.here.controls[0].first, owner.here.joins[1].first);
  EXPECT_TRUE(owner.here.controls[0].second.has_calibration_bundle());
  owner.hear(bundle);
  EXPECT_EQ(owner.sent_to_other.back().what_case(), pb::ToHub::kBundlesPlease) << "none goes back";
}

TEST_F(SharedRoomPlacing,
       the_owner_asks_for_bundles_when_a_sensor_comes_and_when_it_becomes_owner) {
  ASSERT_EQ(owner.sent_to_other.size(), 1u);
  EXPECT_TRUE(owner.sent_to_other[0].has_bundles_please());
  EXPECT_EQ(other.here.left.size(), 1u) << "it joins again: the room sends it all bundles";
  other.welcome(2, 0);
  other.sent_to_other.clear();
  other.room.set_owner(kOther);
  ASSERT_EQ(other.sent_to_other.size(), 1u);
  EXPECT_TRUE(other.sent_to_other[0].has_bundles_please());
}

TEST_F(SharedRoomPlacing, the_owners_poses_are_applied_everywhere) {
  other.welcome(2, 0);
  owner.roster({aligned(0, "a", 1), aligned(1, "b", 2)});
  ASSERT_EQ(other.here.controls.size(), 1u);
  EXPECT_EQ(other.here.controls[0].first, other.aligner());
  const auto& placements = other.here.controls[0].second.placements();
  ASSERT_EQ(placements.sensors_size(), 2);
  EXPECT_EQ(placements.sensors(0).sensor_id(), 1u) << "\"a\" has another number here";
  EXPECT_EQ(placements.sensors(0).world_from_depth(3), 1);
  EXPECT_EQ(placements.sensors(1).world_from_depth(3), 2);
}

TEST_F(SharedRoomPlacing, known_poses_are_not_sent_again) {
  other.welcome(2, 0);
  owner.roster({aligned(0, "a", 1), aligned(1, "b", 2)});
  other.here.controls.clear();
  other.roster({aligned(0, "b", 2), aligned(1, "a", 1)});
  EXPECT_TRUE(other.here.controls.empty());
}

TEST_F(SharedRoomPlacing, the_old_pose_of_a_moved_sensor_is_ignored) {
  other.welcome(2, 0);
  owner.roster({aligned(0, "a", 1), aligned(1, "b", 2)});
  other.here.controls.clear();
  auto moved = aligned(0, "b", 2);
  moved.set_moved(true);
  other.roster({moved, aligned(1, "a", 1)});
  EXPECT_TRUE(other.here.controls.empty());
  EXPECT_TRUE(owner.here.controls.back().second.has_sensor_moved()) << "the owner is notified";
}

TEST_F(SharedRoomPlacing, only_the_owner_publishes_poses) {
  other.welcome(2, 0);
  other.roster({aligned(0, "b", 5), aligned(1, "a", 6)});
  EXPECT_TRUE(owner.here.controls.empty());
}

TEST_F(SharedRoomPlacing, without_an_owner_the_sensors_own_hub_decides) {
  for (Hub* hub : {&owner, &other}) hub->room.set_owner(std::nullopt);
  owner.roster({sensor_there(0, "a", wpb::PLACEMENT_UNPLACED),
                sensor_there(1, "b", wpb::PLACEMENT_UNPLACED)});
  other.roster({aligned(0, "b", 5)});
  ASSERT_FALSE(owner.here.controls.empty());
  EXPECT_EQ(owner.here.controls.back().second.placements().sensors(0).sensor_id(), 1u);
}

TEST_F(SharedRoomPlacing, sightings_reach_the_owner_in_its_time) {
  other.welcome(2, 0);
  wpb::Control request;
  request.mutable_sighting_request()->set_heads(true);
  owner.room.on_room_message(owner.here.joins[1].first, request);
  ASSERT_FALSE(other.here.controls.empty());
  EXPECT_TRUE(other.here.controls.back().second.sighting_request().heads());
  owner.room.set_clock(kOther, {.at = HostTime(14s), .room_minus_host = -4s, .drift = 0});
  wpb::Control sightings;
  sightings.mutable_sightings()->set_sensor_id(0);
  sightings.mutable_sightings()->add_heads()->set_room_ns(10'000'000'000);
  other.hear(sightings);
  ASSERT_FALSE(owner.here.controls.empty());
  EXPECT_EQ(owner.here.controls.back().second.sightings().heads(0).room_ns(), 14'000'000'000u);
}

TEST_F(SharedRoomPlacing, an_instant_reaches_the_owner_in_its_time) {
  other.welcome(2, 0);
  owner.room.set_clock(kOther, {.at = HostTime(14s), .room_minus_host = -4s, .drift = 0});
  wpb::Control instant;
  instant.mutable_depth_instant()->set_sensor_id(0);
  instant.mutable_depth_instant()->set_depth("depth");
  instant.mutable_depth_instant()->set_room_ns(10'000'000'000);
  other.hear(instant);
  ASSERT_FALSE(owner.here.controls.empty());
  const auto& told = owner.here.controls.back().second.depth_instant();
  EXPECT_EQ(told.room_ns(), 14'000'000'000u);
  EXPECT_EQ(told.depth(), "depth");
}

TEST_F(SharedRoomPlacing, a_pose_takes_its_factor_along) {
  other.welcome(2, 0);
  wpb::SensorEntry scaled = aligned(0, "b", 5);
  scaled.set_depth_scale(1.04);
  owner.roster({scaled, sensor_there(1, "a", wpb::PLACEMENT_UNPLACED)});
  other.roster({sensor_there(0, "b", wpb::PLACEMENT_UNPLACED)});
  ASSERT_FALSE(other.here.controls.empty());
  EXPECT_EQ(other.here.controls.back().second.placements().sensors(0).depth_scale(), 1.04);
}

TEST_F(SharedRoomPlacing, a_nudge_is_sent_to_the_owner_by_sensor_name) {
  other.welcome(2, 0);
  owner.roster({sensor_there(0, "a", wpb::PLACEMENT_UNPLACED),
                sensor_there(1, "b", wpb::PLACEMENT_UNPLACED)});
  wpb::Control nudge;
  nudge.mutable_nudge()->set_sensor_id(0);
  for (int i = 0; i < 16; ++i) nudge.mutable_nudge()->add_world_from_depth(i % 5 == 0 ? 1 : 0);
  other.hear(nudge);
  ASSERT_FALSE(owner.here.controls.empty());
  EXPECT_EQ(owner.here.controls.back().second.nudge().sensor_id(), 1u);
}

}  // namespace
}  // namespace roomcast::hub::federation
