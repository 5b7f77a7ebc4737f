// SPDX-License-Identifier: Apache-2.0
#include "roomcast/upstream/mirrored_room.h"

#include <vector>

#include <gtest/gtest.h>

#include "roomcast/wire/frame_header.h"

namespace roomcast::upstream {
namespace {

namespace pb = wire::pb;
using namespace std::chrono_literals;

/// A room here that remembers what it was told.
struct RoomHere final : hub::SessionEvents {
  void on_join(const hub::Arrival& arrival, const pb::Join& join) override {
    joins.emplace_back(arrival.from, join);
  }
  void on_control(ConnectionId from, const pb::Control& message) override {
    said.emplace_back(from, message);
  }
  void on_frame(ConnectionId from, const wire::FrameHeader& header,
                net::MessageBuffer message) override {
    EXPECT_EQ(*wire::parse_frame(message.payload()), header) << "the bytes say the same";
    frames.emplace_back(from, header);
  }
  void on_key_needs(ConnectionId, const std::vector<SensorId>&) override { FAIL(); }
  void on_left(ConnectionId from, const net::CloseReason&) override { left.push_back(from); }

  std::vector<std::pair<ConnectionId, pb::Join>> joins;
  std::vector<std::pair<ConnectionId, pb::Control>> said;
  std::vector<std::pair<ConnectionId, wire::FrameHeader>> frames;
  std::vector<ConnectionId> left;
};

pb::SensorEntry sensor_there(std::uint32_t id, const std::string& name,
                             pb::Placement placement = pb::PLACEMENT_GIVEN) {
  pb::SensorEntry entry;
  entry.set_id(id);
  entry.set_name(name);
  entry.set_online(true);
  entry.set_fps(30);
  entry.set_placement(placement);
  for (int i = 0; i < 16; ++i) entry.add_world_from_depth(i % 5 == 0 ? 1 : 0);
  return entry;
}

pb::Roster roster_of(std::initializer_list<pb::SensorEntry> sensors) {
  pb::Roster roster;
  for (const auto& sensor : sensors) *roster.add_sensors() = sensor;
  return roster;
}

class MirroredRoomTest : public testing::Test {
 protected:
  /// The room here welcomes the `n`th who joined as sensor `id`.
  void welcome(std::size_t n, std::uint32_t id = 0) {
    pb::Control control;
    control.mutable_welcome()->set_sensor_id(id);
    EXPECT_FALSE(mirror.said(here.joins.at(n).first, control).has_value());
  }
  /// Of sensor 7 there, captured at 10 s of that hub's clock.
  net::MessageBuffer frame_there() {
    const wire::FrameHeader header{
        .key = true, .sensor = SensorId{7}, .capture_time = RoomTime(10s), .clock_error_us = 100};
    std::vector<std::uint8_t> bytes(wire::kFrameHeaderBytes);
    wire::write_frame_header(header, std::span(bytes).first<wire::kFrameHeaderBytes>());
    return net::MessageBuffer(bytes);
  }

  RoomHere here;
  std::uint64_t connections = 0;
  MirroredRoom mirror{"lab", "own", here, [this] { return ConnectionId{++connections}; }};
};

TEST_F(MirroredRoomTest, sensors_there_join_here_as_themselves) {
  mirror.roster(roster_of({sensor_there(7, "left")}));
  ASSERT_EQ(here.joins.size(), 2u);
  EXPECT_TRUE(here.joins[0].second.has_aligner());
  const pb::Join& join = here.joins[1].second;
  EXPECT_EQ(join.room(), "lab");
  EXPECT_EQ(join.token(), "own");
  EXPECT_EQ(join.name(), "left");
  EXPECT_EQ(join.sensor().fps(), 30);
  EXPECT_EQ(join.sensor().world_from_depth_size(), 16) << "somebody gave its pose";
}

TEST_F(MirroredRoomTest, frames_have_this_hubs_id_and_time) {
  mirror.roster(roster_of({sensor_there(7, "left")}));
  welcome(1, 3);
  mirror.clock_is({.at = HostTime(14s), .room_minus_host = -4s, .drift = 0, .error = 50us});
  mirror.frame(frame_there());
  ASSERT_EQ(here.frames.size(), 1u);
  EXPECT_EQ(here.frames[0].first, here.joins[1].first);
  EXPECT_EQ(here.frames[0].second.sensor, SensorId{3});
  EXPECT_EQ(here.frames[0].second.capture_time, RoomTime(14s));
  EXPECT_EQ(here.frames[0].second.clock_error_us, 150u);
}

TEST_F(MirroredRoomTest, frames_wait_for_nothing_and_are_dropped_before_clock_and_id_are_known) {
  mirror.frame(frame_there());
  mirror.roster(roster_of({sensor_there(7, "left")}));
  mirror.clock_is({});
  mirror.frame(frame_there());
  welcome(1, 3);
  mirror.other_hub_is_gone();
  mirror.frame(frame_there());
  EXPECT_TRUE(here.frames.empty());
}

TEST_F(MirroredRoomTest, a_key_request_is_handed_on_with_the_id_there) {
  mirror.roster(roster_of({sensor_there(7, "left")}));
  welcome(1, 3);
  pb::Control control;
  control.mutable_key_request()->set_sensor_id(3);
  const auto request = mirror.said(here.joins[1].first, control);
  ASSERT_TRUE(request);
  EXPECT_EQ(request->key_request().sensor_id(), 7u);
}

TEST_F(MirroredRoomTest, what_alignment_found_comes_as_an_aligners_word) {
  mirror.roster(roster_of({sensor_there(7, "left", pb::PLACEMENT_ALIGNED)}));
  EXPECT_EQ(here.joins.at(1).second.sensor().world_from_depth_size(), 0);
  welcome(0);
  EXPECT_TRUE(here.said.empty()) << "its id here is not known yet";
  welcome(1, 3);
  ASSERT_EQ(here.said.size(), 1u);
  EXPECT_EQ(here.said[0].first, here.joins[0].first);
  const auto& placement = here.said[0].second.placements().sensors(0);
  EXPECT_EQ(placement.sensor_id(), 3u);
  EXPECT_EQ(placement.world_from_depth_size(), 16);
}

TEST_F(MirroredRoomTest, a_sensor_that_was_moved_says_so_once) {
  auto entry = sensor_there(7, "left", pb::PLACEMENT_ALIGNED);
  mirror.roster(roster_of({entry}));
  welcome(1, 3);
  entry.set_moved(true);
  mirror.roster(roster_of({entry}));
  mirror.roster(roster_of({entry}));
  ASSERT_EQ(here.said.size(), 1u);
  EXPECT_TRUE(here.said[0].second.has_sensor_moved());
  EXPECT_EQ(here.said[0].first, here.joins[1].first);
}

TEST_F(MirroredRoomTest, who_leaves_there_leaves_here_and_who_changes_joins_anew) {
  mirror.roster(roster_of({sensor_there(7, "left"), sensor_there(8, "right")}));
  auto offline = sensor_there(7, "left");
  offline.set_online(false);
  auto faster = sensor_there(8, "right");
  faster.set_fps(60);
  mirror.roster(roster_of({offline, faster}));
  EXPECT_EQ(here.left.size(), 2u);
  ASSERT_EQ(here.joins.size(), 4u);
  EXPECT_EQ(here.joins[3].second.sensor().fps(), 60);
}

TEST_F(MirroredRoomTest, when_the_other_hub_is_gone_nobody_is_left) {
  mirror.roster(roster_of({sensor_there(7, "left")}));
  mirror.other_hub_is_gone();
  EXPECT_EQ(here.left.size(), 2u);
  mirror.roster(roster_of({sensor_there(7, "left")}));
  EXPECT_EQ(here.joins.size(), 4u) << "and comes back with it";
}

TEST_F(MirroredRoomTest, a_sensor_that_was_sent_away_here_is_back_with_the_next_roster) {
  mirror.roster(roster_of({sensor_there(7, "left")}));
  mirror.let_go(here.joins[1].first);
  mirror.roster(roster_of({sensor_there(7, "left")}));
  EXPECT_EQ(here.joins.size(), 3u);
  EXPECT_TRUE(here.left.empty()) << "the room knows already";
}

}  // namespace
}  // namespace roomcast::upstream
