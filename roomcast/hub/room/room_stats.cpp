// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/room_stats.h"

#include <algorithm>
#include <optional>

namespace roomcast::hub {

namespace {

/// Returns whether this frame is its sensor's newest in the set, by capture time.
bool is_newest(const FrameSet& set, const SetFrame& frame) {
  return std::ranges::none_of(set.frames, [&frame](const SetFrame& other) {
    return other.header.sensor == frame.header.sensor &&
           (other.header.capture_time > frame.header.capture_time ||
            (other.header.capture_time == frame.header.capture_time && &other > &frame));
  });
}

/// The number of frames missing between two sequence numbers, modulo 2^32; 0 if the sensor
/// restarted its count.
std::uint32_t frames_between(std::uint32_t before, std::uint32_t after) {
  constexpr std::uint32_t kBackwards = 1U << 31U;
  const std::uint32_t between = after - before - 1;
  return between < kBackwards ? between : 0;
}

}  // namespace

nanoseconds capture_skew(const FrameSet& set) {
  std::optional<RoomTime> first, last;
  for (const SetFrame& frame : set.frames) {
    if (!is_newest(set, frame)) continue;
    const RoomTime time = frame.header.capture_time;
    first = std::min(first.value_or(time), time);
    last = std::max(last.value_or(time), time);
  }
  return first ? *last - *first : nanoseconds(0);
}

std::size_t sensor_count(const FrameSet& set) {
  return static_cast<std::size_t>(std::ranges::count_if(
      set.frames, [&set](const SetFrame& frame) { return is_newest(set, frame); }));
}

void count_frame(const wire::FrameHeader& header, std::size_t bytes, RoomTime now,
                 SensorStats& stats) {
  stats.bytes += bytes;
  if (header.small) return;  // it comes beside a frame that is counted
  ++stats.frames;
  if (stats.newest_seq) stats.missed += frames_between(*stats.newest_seq, header.seq);
  stats.newest_seq = header.seq;
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
