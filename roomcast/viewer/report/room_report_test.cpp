// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/report/room_report.h"

#include <gtest/gtest.h>

#include "roomcast/viewer/report/host_time_fixture.h"

namespace roomcast::viewer {
namespace {

using namespace std::chrono_literals;

TEST(RoomReport, has_the_rate_and_losses_of_each_sensor) {
  RoomReport report;
  client::RoomSnapshot room;
  room.sensors.resize(1);
  client::RoomSensor& sensor = room.sensors[0];
  sensor.id = SensorId{3};
  for (int i = 0; i <= 60; ++i) {
    sensor.frames_received += 3;
    sensor.frames_missed += 1;
    sensor.bytes_received += 100'000;
    room.bytes_received += 100'000;
    room.sets_received += 3;
    report.follow(room, at(i * 100ms));
  }
  const RoomFigures& figures = report.figures();
  ASSERT_EQ(figures.sensors.size(), 1U);
  EXPECT_EQ(figures.sensors[0].id, SensorId{3});
  EXPECT_NEAR(figures.sensors[0].fps, 30, 1e-9);
  EXPECT_NEAR(figures.sensors[0].missed_per_s, 10, 1e-9);
  EXPECT_NEAR(figures.sensors[0].megabytes_per_s, 1, 1e-9);
  EXPECT_EQ(figures.sensors[0].missed, 61U);
  EXPECT_NEAR(figures.megabytes_per_s, 1, 1e-9);
  EXPECT_NEAR(figures.sets_per_s, 30, 1e-9);
}

TEST(RoomReport, a_room_that_stands_still_slows_down_to_nothing) {
  RoomReport report;
  client::RoomSnapshot room;
  for (int i = 0; i < 100; ++i) {
    if (i < 50) room.sets_received += 3;
    report.follow(room, at(i * 100ms));
  }
  EXPECT_EQ(report.figures().sets_per_s, 0);
}

TEST(RoomReport, an_age_needs_the_hubs_clock) {
  RoomReport report;
  client::RoomSnapshot room;
  room.sensors.resize(1);
  auto picture = std::make_shared<client::SensorPicture>();
  picture->capture_time = RoomTime(1h + 5s);
  room.sensors[0].picture = picture;
  report.follow(room, at(80ms));
  EXPECT_FALSE(report.figures().sensors[0].age_ms);
  room.clock = client::ClockEstimate{at(0s), 5s, 0, 1ms};
  report.follow(room, at(80ms));
  EXPECT_NEAR(report.figures().sensors[0].age_ms.value(), 80, 1e-6);
}

}  // namespace
}  // namespace roomcast::viewer
