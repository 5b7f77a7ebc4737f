// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room_stats.h"

#include <algorithm>
#include <map>
#include <sstream>

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

/// A label's value: names come from sensors, which may say anything.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

class MetricsWriter {
 public:
  explicit MetricsWriter(std::string room) : room_(std::move(room)) {}

  void begin(const char* name, const char* type, const char* help) {
    name_ = name;
    out_ << "# HELP roomcast_" << name << " " << help << "\n# TYPE roomcast_" << name << " " << type
         << "\n";
  }
  template <class Value>
  void of_room(Value value) {
    out_ << "roomcast_" << name_ << "{room=" << quoted(room_) << "} " << value << "\n";
  }
  template <class Value>
  void of_sensor(const SensorStats& sensor, Value value) {
    out_ << "roomcast_" << name_ << "{room=" << quoted(room_) << ",sensor=" << quoted(sensor.name)
         << "} " << value << "\n";
  }
  [[nodiscard]] std::string text() const { return out_.str(); }

 private:
  const std::string room_;
  const char* name_ = "";
  std::ostringstream out_;
};

void write_sensors(const std::vector<SensorStats>& sensors, MetricsWriter& out) {
  out.begin("sensor_online", "gauge", "1 while the sensor is connected.");
  for (const auto& sensor : sensors) out.of_sensor(sensor, sensor.online ? 1 : 0);
  out.begin("sensor_frames_total", "counter", "Frames that came from the sensor.");
  for (const auto& sensor : sensors) out.of_sensor(sensor, sensor.frames);
  out.begin("sensor_bytes_total", "counter", "Bytes of these frames.");
  for (const auto& sensor : sensors) out.of_sensor(sensor, sensor.bytes);
  out.begin("sensor_delay_seconds", "gauge", "Capture to arrival of the newest frame.");
  for (const auto& sensor : sensors) out.of_sensor(sensor, sensor.delay_s);
  out.begin("sensor_clock_error_seconds", "gauge", "The sensor's own bound on its capture times.");
  for (const auto& sensor : sensors) {
    if (sensor.clock_error_s) out.of_sensor(sensor, *sensor.clock_error_s);
  }
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

std::string metrics_text(const RoomStats& stats, std::uint64_t dropped_sets) {
  MetricsWriter out(stats.room);
  write_sensors(stats.sensors, out);
  out.begin("viewers", "gauge", "Viewers in the room.");
  out.of_room(stats.viewers);
  out.begin("sets_total", "counter", "Frame sets that were closed.");
  out.of_room(stats.sets);
  out.begin("incomplete_sets_total", "counter", "Those without a frame of every sensor online.");
  out.of_room(stats.incomplete_sets);
  out.begin("set_skew_seconds", "gauge", "First to last capture in the newest set.");
  out.of_room(stats.set_skew_s);
  out.begin("dropped_sets_total", "counter", "Sets left out for slow viewers, over all viewers.");
  out.of_room(dropped_sets);
  return out.text();
}

}  // namespace roomcast::hub
