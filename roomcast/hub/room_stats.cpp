// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room_stats.h"

#include <algorithm>
#include <map>

namespace roomcast::hub {

namespace {

std::map<SensorId, RoomTime> newest_captures(const FrameSet& set) {
  std::map<SensorId, RoomTime> newest;
  for (const SetFrame& frame : set.frames) {
    RoomTime& time = newest[frame.header.sensor];
    time = std::max(time, frame.header.capture_time);
  }
  return newest;
}

}  // namespace

nanoseconds capture_skew(const FrameSet& set) {
  const auto newest = newest_captures(set);
  if (newest.empty()) return {};
  const auto by_time = [](const auto& a, const auto& b) { return a.second < b.second; };
  const auto [first, last] = std::minmax_element(newest.begin(), newest.end(), by_time);
  return last->second - first->second;
}

std::size_t sensor_count(const FrameSet& set) {
  return newest_captures(set).size();
}

void count_frame(const wire::FrameHeader& header, std::size_t bytes, RoomTime now,
                 SensorStats& stats) {
  ++stats.frames;
  stats.bytes += bytes;
  stats.delay_s = std::chrono::duration<double>(now - header.capture_time).count();
  stats.clock_error_s.reset();
  if (header.clock_error_us != wire::kClockErrorUnknown) {
    stats.clock_error_s = 1e-6 * header.clock_error_us;
  }
}

void count_set(const FrameSet& set, std::size_t online_sensors, RoomStats& stats) {
  ++stats.sets;
  if (sensor_count(set) < online_sensors) ++stats.incomplete_sets;
  stats.set_skew_s = std::chrono::duration<double>(capture_skew(set)).count();
}

}  // namespace roomcast::hub
