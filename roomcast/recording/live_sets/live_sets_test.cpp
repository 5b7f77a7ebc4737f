// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/live_sets/live_sets.h"

#include <gtest/gtest.h>

namespace roomcast::recording {
namespace {

using namespace std::chrono_literals;

client::RoomSensor sensor(std::uint16_t id, RoomTime captured) {
  auto picture = std::make_shared<client::SensorPicture>();
  picture->capture_time = captured;
  picture->frame.depth_mm = DepthImage(4, 2, 1000);
  picture->frame.color = ColorImage(8, 4, Rgb8{10, 20, 30});
  picture->frame.color_seen = MaskImage(4, 2, 255);
  client::RoomSensor sensor;
  sensor.id = {id};
  sensor.name = "s" + std::to_string(id);
  sensor.online = true;
  sensor.calibration.depth = {.width = 4, .height = 2, .fx = 4, .fy = 4, .cx = 1.5, .cy = 0.5};
  sensor.picture = std::move(picture);
  return sensor;
}

/// A room whose clock is 5 s ahead of this machine's.
client::RoomSnapshot room_of(std::vector<client::RoomSensor> sensors) {
  client::RoomSnapshot room;
  room.newest_set = {7};
  room.clock = client::ClockEstimate{.at = SteadyClock().now(), .room_minus_host = 5s};
  room.sensors = std::move(sensors);
  return room;
}

TEST(LiveSets, times_are_those_of_day_by_this_machines_clock) {
  LiveSets sets;
  const RoomTime captured(SteadyClock().now().time_since_epoch() + 5s - 40ms);
  const LiveSet live = sets.set_of(room_of({sensor(1, captured)}));
  const nanoseconds now = std::chrono::system_clock::now().time_since_epoch();
  ASSERT_EQ(live.set.frames.size(), 1u);
  EXPECT_EQ(live.set.time, live.set.frames[0].time);
  EXPECT_GE(now - live.set.time, 40ms - 1ms);
  EXPECT_LT(now - live.set.time, 10s);
  EXPECT_EQ(live.set.number, 7u);
}

TEST(LiveSets, colour_is_reduced_to_the_depth_grid_once_for_each_picture) {
  LiveSets sets;
  const auto room = room_of({sensor(1, {}), sensor(2, {})});
  const LiveSet first = sets.set_of(room);
  const LiveSet again = sets.set_of(room);
  EXPECT_EQ(first.set.frames[1].pictures->color.width(), 4);
  EXPECT_EQ(first.set.frames[1].pictures, again.set.frames[1].pictures);
  auto later = room;
  later.sensors[1] = sensor(2, RoomTime(1s));
  EXPECT_NE(sets.set_of(later).set.frames[1].pictures, first.set.frames[1].pictures);
}

TEST(LiveSets, sensors_that_are_offline_or_have_sent_nothing_are_not_in_a_set) {
  LiveSets sets;
  auto room = room_of({sensor(1, {}), sensor(2, {}), sensor(3, {})});
  room.sensors[0].online = false;
  room.sensors[1].picture = nullptr;
  const LiveSet live = sets.set_of(room);
  EXPECT_EQ(live.sensors.size(), 3u);
  EXPECT_EQ(live.sensors_sending, 2u);
  ASSERT_EQ(live.set.frames.size(), 1u);
  EXPECT_EQ(live.set.frames[0].sensor, 2u);
  EXPECT_FALSE(live.set.frames[0].world_from_depth.has_value());
}

}  // namespace
}  // namespace roomcast::recording
