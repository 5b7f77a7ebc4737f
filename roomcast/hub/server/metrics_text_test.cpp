// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/server/metrics_text.h"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(MetricsText, has_the_prometheus_format) {
  std::array<RoomStats, 2> rooms;
  rooms[0] = {
      .room = "lab", .sets = 40, .incomplete_sets = 2, .dropped_sets = 7, .set_skew_s = 0.012};
  rooms[0].sensors.push_back({.name = "left", .online = true, .frames = 41, .bytes = 900});
  rooms[0].viewers.push_back(
      {.id = ViewerId{5}, .name = "Ada", .latency_ms = 80, .bytes = 1234, .dropped_sets = 3});
  rooms[1].room = "kitchen";
  const std::string text = metrics_text({.connections = 9, .refused_joins = 4}, rooms);
  EXPECT_THAT(text, HasSubstr("# TYPE roomcast_sensor_frames_total counter\n"
                              "roomcast_sensor_frames_total{room=\"lab\",sensor=\"left\"} 41\n"));
  EXPECT_THAT(
      text, HasSubstr("roomcast_viewers{room=\"lab\"} 1\nroomcast_viewers{room=\"kitchen\"} 0\n"));
  EXPECT_THAT(text, HasSubstr("roomcast_set_skew_seconds{room=\"lab\"} 0.012\n"));
  EXPECT_THAT(text, HasSubstr("roomcast_dropped_sets_total{room=\"lab\"} 7\n"));
  EXPECT_THAT(
      text,
      HasSubstr("roomcast_viewer_latency_seconds{room=\"lab\",viewer=\"5\",name=\"Ada\"} 0.08\n"));
  EXPECT_THAT(text, HasSubstr("roomcast_refused_joins_total 4\n"));
  EXPECT_THAT(text, Not(HasSubstr("sensor_clock_error_seconds{"))) << "it is not known";
}

TEST(MetricsText, escapes_names) {
  std::array<RoomStats, 1> rooms{RoomStats{.room = "lab"}};
  rooms[0].sensors.push_back({.name = "a\"} 1\\"});
  EXPECT_THAT(metrics_text({}, rooms), HasSubstr("sensor=\"a\\\"} 1\\\\\"}"));
}

}  // namespace
}  // namespace roomcast::hub
