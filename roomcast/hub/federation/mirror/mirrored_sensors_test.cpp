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
  void set_online(std::initializer_list<wire::pb::SensorEntry> entries) {
    std::vector<SensorThere> online;
    for (const auto& entry : entries) online.push_back({.entry = entry});
    mirror.set_online(online);
  }

  RoomHere here;
  MirroredSensors mirror{9, "lab", "own", here, unread_connections()};
};

TEST_F(MirroredSensorsTest, sensors_there_join_here_with_their_properties) {
  set_online({sensor_there(7, "left")});
  ASSERT_EQ(here.joins.size(), 1u);
  const wire::pb::Join& join = here.joins[0].second;
  EXPECT_EQ(join.room(), "lab");
  EXPECT_EQ(join.token(), "own");
  EXPECT_EQ(join.name(), "left");
  EXPECT_EQ(join.sensor().fps(), 30);
  EXPECT_EQ(join.sensor().world_from_depth_size(), 16) << "its pose was given";
  EXPECT_FALSE(here.arrivals[0].token_id_there.has_value());
  EXPECT_EQ(here.arrivals[0].other_hub, 9u);
}

TEST_F(MirroredSensorsTest, joins_with_the_token_id_there) {
  mirror.set_online({{.entry = sensor_there(7, "left"), .token_id = "t1"}});
  EXPECT_EQ(here.arrivals.at(0).token_id_there, "t1");
}

TEST_F(MirroredSensorsTest, frames_have_this_hubs_id_and_time) {
  set_online({sensor_there(7, "left")});
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
  set_online({sensor_there(7, "left")});
  mirror.set_clock({});
  mirror.frame(frame_there());
  welcome(0, 3);
  mirror.on_hub_lost();
  mirror.frame(frame_there());
  mirror.deliver_frames();
  EXPECT_TRUE(here.frames.empty());
}

TEST_F(MirroredSensorsTest, frames_received_together_are_delivered_together) {
  set_online({sensor_there(7, "left")});
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
       frames_are_delivered_before_later_messages_and_not_for_removed_sensors) {
  set_online({sensor_there(7, "left")});
  welcome(0, 3);
  mirror.set_clock({});
  mirror.frame(frame_there());
  set_online({});
  EXPECT_EQ(here.frames.size(), 1u) << "sent before its sensor left";
  set_online({sensor_there(7, "left")});
  welcome(1, 3);
  mirror.frame(frame_there());
  mirror.on_removed(here.joins[1].first);
  mirror.deliver_frames();
  EXPECT_EQ(here.frames.size(), 1u);
}

TEST_F(MirroredSensorsTest, drops_invalid_frames) {
  set_online({sensor_there(7, "left")});
  welcome(0, 3);
  mirror.set_clock({});
  auto cut = frame_there();
  mirror.frame(net::MessageBuffer(cut.payload().first(20)));
  mirror.deliver_frames();
  EXPECT_TRUE(here.frames.empty());
}

TEST_F(MirroredSensorsTest, a_key_request_is_forwarded_with_the_id_there) {
  set_online({sensor_there(7, "left")});
  welcome(0, 3);
  wire::pb::Control control;
  control.mutable_key_request()->set_sensor_id(3);
  const auto request = mirror.on_room_message(here.joins[0].first, control);
  ASSERT_TRUE(request);
  EXPECT_EQ(request->key_request().sensor_id(), 7u);
}

TEST_F(MirroredSensorsTest, forwards_messages_of_welcome_sensors) {
  set_online({sensor_there(7, "left")});
  wire::pb::Control bundle;
  bundle.mutable_calibration_bundle();
  mirror.forward(7, bundle);
  EXPECT_TRUE(here.controls.empty());
  welcome(0, 3);
  mirror.forward(7, bundle);
  mirror.forward(8, bundle);
  ASSERT_EQ(here.controls.size(), 1u);
  EXPECT_EQ(here.controls[0].first, here.joins[0].first);
}

TEST_F(MirroredSensorsTest, a_move_is_reported_once) {
  auto entry = sensor_there(7, "left", wire::pb::PLACEMENT_ALIGNED);
  set_online({entry});
  welcome(0, 3);
  entry.set_moved(true);
  set_online({entry});
  set_online({entry});
  ASSERT_EQ(here.controls.size(), 1u);
  EXPECT_TRUE(here.controls[0].second.has_sensor_moved());
}

TEST_F(MirroredSensorsTest, a_sensor_that_leaves_there_leaves_here_and_a_changed_one_rejoins) {
  set_online({sensor_there(7, "left"), sensor_there(8, "right")});
  auto faster = sensor_there(8, "right");
  faster.set_fps(60);
  set_online({faster});
  EXPECT_EQ(here.left.size(), 2u);
  ASSERT_EQ(here.joins.size(), 3u);
  EXPECT_EQ(here.joins[2].second.sensor().fps(), 60);
}

TEST_F(MirroredSensorsTest, has_a_sensor_after_its_welcome) {
  set_online({sensor_there(7, "left")});
  EXPECT_FALSE(mirror.has("left"));
  welcome(0, 3);
  EXPECT_TRUE(mirror.has("left"));
  EXPECT_TRUE(mirror.on_removed(here.joins[0].first));
  EXPECT_FALSE(mirror.has("left"));
  EXPECT_FALSE(mirror.on_removed(here.joins[0].first));
}

}  // namespace
}  // namespace roomcast::hub::federation
