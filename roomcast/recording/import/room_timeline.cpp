// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/room_timeline.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace roomcast::recording {
namespace {

using Sensors = std::vector<const SensorFileInfo*>;

constexpr nanoseconds kShortGap = std::chrono::seconds(1);

double seconds_of(nanoseconds time) {
  return std::chrono::duration<double>(time).count();
}

bool joined_by_cable(const Sensors& sensors) {
  const auto on_cable = [](const SensorFileInfo* s) {
    return s->clock.is_cable_primary || s->clock.is_cable_secondary;
  };
  const auto primary = [](const SensorFileInfo* s) { return s->clock.is_cable_primary; };
  return std::ranges::all_of(sensors, on_cable) && std::ranges::count_if(sensors, primary) <= 1;
}

bool in_one_recording(const Sensors& sensors) {
  const std::string& recording = sensors.front()->clock.recording;
  return !recording.empty() && std::ranges::all_of(sensors, [&](const SensorFileInfo* s) {
    return s->clock.recording == recording;
  });
}

const SensorFileInfo* without_utc(const Sensors& sensors) {
  const auto found = std::ranges::find_if(
      sensors, [](const SensorFileInfo* s) { return !s->clock.utc_minus_device; });
  return found == sensors.end() ? nullptr : *found;
}

nanoseconds largest_utc_error(const Sensors& sensors) {
  nanoseconds largest{};
  for (const SensorFileInfo* s : sensors) largest = std::max(largest, s->clock.utc_error);
  return largest;
}

std::string time_of_day_text(nanoseconds error) {
  if (error <= std::chrono::milliseconds(1)) return "the time of day at which frames were taken";
  char text[80];
  std::snprintf(text, sizeof(text), "the time of day that the files state, to about %.0f s",
                std::ceil(seconds_of(error)));
  return text;
}

Result<JoiningClock> choose(const Sensors& sensors, JoiningClock wanted) {
  const bool cable = joined_by_cable(sensors);
  const SensorFileInfo* const timeless = without_utc(sensors);
  if (wanted == JoiningClock::kCable && !cable) {
    return invalid_argument(
        "these recordings do not say that a sync cable joined their cameras; choose another clock");
  }
  if (wanted == JoiningClock::kTimeOfDay && timeless != nullptr) {
    return invalid_argument("the recording of " + timeless->description.name +
                            " does not state the time of day; choose another clock");
  }
  if (wanted != JoiningClock::kAutomatic) return wanted;
  if (sensors.size() == 1) return JoiningClock::kStart;
  if (cable) return JoiningClock::kCable;
  if (timeless == nullptr) return JoiningClock::kTimeOfDay;
  return in_one_recording(sensors) ? JoiningClock::kRecording : JoiningClock::kStart;
}

std::string explain(JoiningClock clock, const Sensors& sensors) {
  if (sensors.size() == 1) return "the sensor's own clock";
  if (clock == JoiningClock::kCable) return "the cameras' own clocks, which a sync cable joined";
  if (clock == JoiningClock::kTimeOfDay) return time_of_day_text(largest_utc_error(sensors));
  if (clock == JoiningClock::kRecording) return "the clock of the recording that they are in";
  return "their first frames, put at the same instant";
}

nanoseconds offset_of(const SensorFileInfo& sensor, JoiningClock clock, std::size_t count) {
  if (clock == JoiningClock::kTimeOfDay) return -*sensor.clock.utc_minus_device;
  if (clock == JoiningClock::kStart && count > 1) return sensor.times.front();
  return nanoseconds(0);
}

struct Span {
  nanoseconds first{}, last{};
  const SensorFileInfo* sensor = nullptr;
};

std::vector<Span> spans_of(const Sensors& sensors, const std::vector<nanoseconds>& offsets) {
  std::vector<Span> spans;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    const auto& times = sensors[i]->times;
    spans.push_back({times.front() - offsets[i], times.back() - offsets[i], sensors[i]});
  }
  std::ranges::sort(spans, {}, &Span::first);
  return spans;
}

/// Recordings of different days would play one after the other, with hours of nothing between.
Status check_overlap(const std::vector<Span>& spans, nanoseconds tolerance) {
  Span latest = spans.front();
  for (const Span& span : spans) {
    if (span.first > latest.last + tolerance) {
      char gap[40];
      std::snprintf(gap, sizeof(gap), "%.1f s", seconds_of(span.first - latest.last));
      return invalid_argument("the recording of " + span.sensor->description.name + " begins " +
                              gap + " after that of " + latest.sensor->description.name +
                              " has ended; choose the clock \"start\" to let them begin together");
    }
    if (span.last > latest.last) latest = span;
  }
  return {};
}

}  // namespace

Result<RoomTimeline> join_clocks(const Sensors& sensors, JoiningClock wanted) {
  const auto clock = choose(sensors, wanted);
  if (!clock) return clock.error();
  RoomTimeline line;
  line.clock = *clock;
  line.explanation = explain(*clock, sensors);
  line.fps = 0;
  for (const SensorFileInfo* sensor : sensors) {
    line.clock_offsets.push_back(offset_of(*sensor, *clock, sensors.size()));
    line.fps = std::max(line.fps, sensor->description.fps);
  }
  const auto spans = spans_of(sensors, line.clock_offsets);
  const nanoseconds tolerance = kShortGap + largest_utc_error(sensors);
  if (Status status = check_overlap(spans, tolerance); !status) return status.error();
  line.start = spans.front().first;
  const nanoseconds last = std::ranges::max(spans, {}, &Span::last).last;
  const double frames = std::floor(seconds_of(last - line.start) * line.fps + 0.5) + 1;
  line.loop_duration = nanoseconds(std::llround(frames / line.fps * 1e9));
  return line;
}

}  // namespace roomcast::recording
