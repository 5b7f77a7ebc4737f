// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/mirror/mirrored_sensors.h"

#include <vector>

#include <gtest/gtest.h>

#include "roomcast/hub/federation/mirror/room_here_fixture.h"

namespace roomcast::hub::federation {
namespace {

class MirroredSensorsTest : public testing::Test {
 protected:
  /// The room here sends a welcome to the `n`th client that joined, as sensor `id`.
  void welcome(std::size_t n, std::uint32_t id) {
    wire::pb::Control control;
    control.mutable_welcome()->set_sensor_id(id);
    EXPECT_FALSE(mirror.on_room_message(here.joins.at(n).first, control).has_value());
  }
  void follow(std::initializer_list<wire::pb::SensorEntry> entries) {
    std::vector<SensorThere> online;
    for (const auto& entry : entries) online.push_back({.entry = entry});
    mirror.follow(online);
  }

  RoomHere here;
  MirroredSensors mirror{9, "lab", "own", here, unread_connections()};
};

TEST_F(MirroredSensorsTest, sensors_there_join_here_as_themselves) {
  follow({sensor_there(7, "left")});
  ASSERT_EQ(here.joins.size(), 1u);
  const wire::pb::Join& join = here.joins[0].second;
  EXPECT_EQ(join.room(), "lab");
  EXPECT_EQ(join.token(), "own");
  EXPECT_EQ(join.name(), "left");
  EXPECT_EQ(join.sensor().fps(), 30);
  EXPECT_EQ(join.sensor().world_from_depth_size(), 16) << "somebody gave its pose";
  EXPECT_FALSE(here.arrivals[0].token_id_there.has_value());
  EXPECT_EQ(here.arrivals[0].other_hub, 9u);
}

TEST_F(MirroredSensorsTest, whose_token_a_sensor_showed_there_is_said_here) {
  mirror.follow({{.entry = sensor_there(7, "left"), .token_id = "t1"}});
  EXPECT_EQ(here.arrivals.at(0).token_id_there, "t1");
}

TEST_F(MirroredSensorsTest, frames_have_this_hubs_id_and_time) {
  follow({sensor_there(7, "left")});
  welcome(0, 3);
  mirror.set_clock({.at = HostTime(14s), .room_minus_host = -4s, .drift = 0, .error = 50us});
  mirror.frame(frame_there());
  mirror.deliver_frames();
  ASSERT_EQ(here.frames.size(), 1u);
  EXPECT_EQ(here.frames[0].first, here.joins[0].first);
  EXPECT_EQ(here.frames[0].second.sensor, SensorId{3});
  EXPECT_EQ(here.frames[0].second.capture_time, RoomTime(14s));
  EXPECT_EQ(here.frames[0].second.clock_error_us, 150u);
}

TEST_F(MirroredSensorsTest, frames_are_dropped_before_clock_and_id_are_known) {
  mirror.frame(frame_there());
  follow({sensor_there(7, "left")});
  mirror.set_clock({});
  mirror.frame(frame_there());
  welcome(0, 3);
  mirror.other_hub_is_gone();
  mirror.frame(frame_there());
  mirror.deliver_frames();
  EXPECT_TRUE(here.frames.empty());
}

TEST_F(MirroredSensorsTest, frames_that_come_together_go_on_together) {
  follow({sensor_there(7, "left")});
  welcome(0, 3);
  mirror.set_clock({});
  mirror.frame(frame_there());
  mirror.frame(frame_there());
  EXPECT_TRUE(here.frames.empty());
  mirror.deliver_frames();
  mirror.deliver_frames();
  mirror.frame(frame_there());
  mirror.deliver_frames();
  EXPECT_EQ(here.batches, (std::vector<std::size_t>{2, 1}));
}

TEST_F(MirroredSensorsTest,
       frames_go_on_before_what_was_said_after_them_and_none_of_who_was_sent_away) {
  follow({sensor_there(7, "left")});
  welcome(0, 3);
  mirror.set_clock({});
  mirror.frame(frame_there());
  follow({});
  EXPECT_EQ(here.frames.size(), 1u) << "sent before its sensor left";
  follow({sensor_there(7, "left")});
  welcome(1, 3);
  mirror.frame(frame_there());
  mirror.on_removed(here.joins[1].first);
  mirror.deliver_frames();
  EXPECT_EQ(here.frames.size(), 1u);
}

TEST_F(MirroredSensorsTest, what_is_no_frame_is_dropped) {
  follow({sensor_there(7, "left")});
  welcome(0, 3);
  mirror.set_clock({});
  auto cut = frame_there();
  mirror.frame(net::MessageBuffer(cut.payload().first(20)));
  mirror.deliver_frames();
  EXPECT_TRUE(here.frames.empty());
}

TEST_F(MirroredSensorsTest, a_key_request_is_handed_on_with_the_id_there) {
  follow({sensor_there(7, "left")});
  welcome(0, 3);
  wire::pb::Control control;
  control.mutable_key_request()->set_sensor_id(3);
  const auto request = mirror.on_room_message(here.joins[0].first, control);
  ASSERT_TRUE(request);
  EXPECT_EQ(request->key_request().sensor_id(), 7u);
}

TEST_F(MirroredSensorsTest, what_a_sensor_says_there_it_says_here_once_it_is_welcome) {
  follow({sensor_there(7, "left")});
  wire::pb::Control bundle;
  bundle.mutable_calibration_bundle();
  mirror.forward(7, bundle);
  EXPECT_TRUE(here.said.empty());
  welcome(0, 3);
  mirror.forward(7, bundle);
  mirror.forward(8, bundle);
  ASSERT_EQ(here.said.size(), 1u);
  EXPECT_EQ(here.said[0].first, here.joins[0].first);
}

TEST_F(MirroredSensorsTest, a_sensor_that_was_moved_says_so_once) {
  auto entry = sensor_there(7, "left", wire::pb::PLACEMENT_ALIGNED);
  follow({entry});
  welcome(0, 3);
  entry.set_moved(true);
  follow({entry});
  follow({entry});
  ASSERT_EQ(here.said.size(), 1u);
  EXPECT_TRUE(here.said[0].second.has_sensor_moved());
}

TEST_F(MirroredSensorsTest, who_leaves_there_leaves_here_and_who_changes_joins_anew) {
  follow({sensor_there(7, "left"), sensor_there(8, "right")});
  auto faster = sensor_there(8, "right");
  faster.set_fps(60);
  follow({faster});
  EXPECT_EQ(here.left.size(), 2u);
  ASSERT_EQ(here.joins.size(), 3u);
  EXPECT_EQ(here.joins[2].second.sensor().fps(), 60);
}

TEST_F(MirroredSensorsTest, it_has_a_sensor_once_the_room_here_has_welcomed_it) {
  follow({sensor_there(7, "left")});
  EXPECT_FALSE(mirror.has("left"));
  welcome(0, 3);
  EXPECT_TRUE(mirror.has("left"));
  EXPECT_TRUE(mirror.on_removed(here.joins[0].first));
  EXPECT_FALSE(mirror.has("left"));
  EXPECT_FALSE(mirror.on_removed(here.joins[0].first));
}

}  // namespace
}  // namespace roomcast::hub::federation
