// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/server/metrics_text.h"

#include <optional>
#include <sstream>

namespace roomcast::hub {

namespace {

/// A label's value in quotes; names come from clients and may contain any character.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

/// Writes one metric after another, each with a line per room, sensor or viewer.
class MetricsWriter {
 public:
  explicit MetricsWriter(std::span<const RoomStats> rooms) : rooms_(rooms) {}

  template <class Value>
  void of_hub(const char* name, const char* type, const char* help, Value value) {
    begin(name, type, help);
    out_ << "roomcast_" << name << " " << value << "\n";
  }
  /// Uses the prefix `process_`, as programs of all kinds do.
  template <class Value>
  void of_process(const char* name, const char* type, const char* help, Value value) {
    out_ << "# HELP process_" << name << " " << help << "\n# TYPE process_" << name << " " << type
         << "\nprocess_" << name << " " << value << "\n";
  }
  void build_info(const std::string& version) {
    begin("build_info", "gauge", "Always 1; the label is the version.");
    out_ << "roomcast_build_info{version=" << quoted(version) << "} 1\n";
  }
  template <class ValueOf>
  void of_rooms(const char* name, const char* type, const char* help, ValueOf value_of) {
    begin(name, type, help);
    for (const auto& room : rooms_) {
      out_ << "roomcast_" << name << "{room=" << quoted(room.room) << "} " << value_of(room)
           << "\n";
    }
  }
  /// `value_of` may return an optional; an empty one writes no line.
  template <class ValueOf>
  void of_sensors(const char* name, const char* type, const char* help, ValueOf value_of) {
    begin(name, type, help);
    for (const auto& room : rooms_) {
      for (const auto& sensor : room.sensors) {
        if (const auto value = std::optional(value_of(sensor))) line(name, room, sensor, *value);
      }
    }
  }
  template <class ValueOf>
  void of_viewers(const char* name, const char* type, const char* help, ValueOf value_of) {
    begin(name, type, help);
    for (const auto& room : rooms_) {
      for (const auto& viewer : room.viewers) {
        out_ << "roomcast_" << name << "{room=" << quoted(room.room) << ",viewer=\""
             << viewer.id.value << "\",name=" << quoted(viewer.name) << "} " << value_of(viewer)
             << "\n";
      }
    }
  }
  [[nodiscard]] std::string text() const { return out_.str(); }

 private:
  void begin(const char* name, const char* type, const char* help) {
    out_ << "# HELP roomcast_" << name << " " << help << "\n# TYPE roomcast_" << name << " " << type
         << "\n";
  }
  template <class Value>
  void line(const char* name, const RoomStats& room, const SensorStats& sensor,
            const Value& value) {
    out_ << "roomcast_" << name << "{room=" << quoted(room.room)
         << ",sensor=" << quoted(sensor.name) << "} " << value << "\n";
  }

  const std::span<const RoomStats> rooms_;
  std::ostringstream out_;
};

void write_hub(const HubStats& hub, MetricsWriter& out) {
  out.of_hub("connections", "gauge", "Open connections of all kinds.", hub.connections);
  out.of_hub("refused_joins_total", "counter",
             "Joins refused because of their token, their rights or an unknown room.",
             hub.refused_joins);
  out.of_hub("banned_peers", "gauge", "Banned addresses.", hub.banned_peers);
  out.build_info(hub.version);
  out.of_process("cpu_seconds_total", "counter", "Processor time, user and system.",
                 hub.process.cpu_s);
  out.of_process("resident_memory_bytes", "gauge", "Memory in use.", hub.process.resident_bytes);
}

void write_backplane(const BackplaneStats& stats, MetricsWriter& out) {
  out.of_hub("backplane_links", "gauge",
             "Links to other hubs that are needed: to NATS, or one per room pulled.", stats.links);
  out.of_hub("backplane_links_up", "gauge", "Links to other hubs that are connected.",
             stats.links_up);
  out.of_hub("backplane_other_hubs", "gauge", "Other hubs known over NATS.", stats.other_hubs);
  out.of_hub("backplane_sent_messages_total", "counter", "Messages to other hubs.",
             stats.sent.messages);
  out.of_hub("backplane_sent_bytes_total", "counter", "Bytes of these.", stats.sent.bytes);
  out.of_hub("backplane_received_messages_total", "counter", "Messages from other hubs.",
             stats.received.messages);
  out.of_hub("backplane_received_bytes_total", "counter", "Bytes of these.", stats.received.bytes);
  out.of_hub("backplane_dropped_messages_total", "counter",
             "Messages to other hubs that could not be sent.", stats.dropped);
}

void write_rooms(MetricsWriter& out) {
  out.of_rooms("viewers", "gauge", "Viewers in the room.",
               [](const RoomStats& room) { return room.viewers.size(); });
  out.of_rooms("frames_wanted", "gauge",
               "0 while nobody watches and the sensors therefore send no frames.",
               [](const RoomStats& room) { return room.frames_wanted ? 1 : 0; });
  out.of_rooms("sets_total", "counter", "Frame sets that were closed.",
               [](const RoomStats& room) { return room.sets; });
  out.of_rooms("incomplete_sets_total", "counter",
               "Closed sets without a frame of every online sensor.",
               [](const RoomStats& room) { return room.incomplete_sets; });
  out.of_rooms("set_skew_seconds", "gauge", "First to last capture in the newest set.",
               [](const RoomStats& room) { return room.set_skew_s; });
  out.of_rooms("dropped_sets_total", "counter", "Sets dropped for slow viewers, over all viewers.",
               [](const RoomStats& room) { return room.dropped_sets; });
  out.of_rooms("speakers", "gauge", "Viewers that are speaking.",
               [](const RoomStats& room) { return room.speakers; });
  out.of_rooms("audio_packets_total", "counter", "Audio packets received from viewers.",
               [](const RoomStats& room) { return room.audio_packets; });
}

void write_sensors(MetricsWriter& out) {
  out.of_sensors("sensor_online", "gauge", "1 while the sensor is connected.",
                 [](const SensorStats& s) { return s.online ? 1 : 0; });
  out.of_sensors("sensor_frames_total", "counter", "Frames received from the sensor.",
                 [](const SensorStats& s) { return s.frames; });
  out.of_sensors("sensor_bytes_total", "counter", "Bytes of these frames.",
                 [](const SensorStats& s) { return s.bytes; });
  out.of_sensors("sensor_dropped_frames_total", "counter",
                 "Frames missing from the sensor's sequence numbers.",
                 [](const SensorStats& s) { return s.missed; });
  out.of_sensors("sensor_frames_per_second", "gauge", "Lately.",
                 [](const SensorStats& s) { return s.frames_per_s; });
  out.of_sensors("sensor_delay_seconds", "gauge", "Capture to arrival of the newest frame.",
                 [](const SensorStats& s) { return s.delay_s; });
  out.of_sensors("sensor_clock_error_seconds", "gauge",
                 "The sensor's own bound on its capture times.",
                 [](const SensorStats& s) { return s.clock_error_s; });
}

void write_viewers(MetricsWriter& out) {
  out.of_viewers("viewer_bytes_total", "counter", "Bytes sent to the viewer.",
                 [](const ViewerStats& v) { return v.bytes; });
  out.of_viewers("viewer_bytes_per_second", "gauge", "Lately.",
                 [](const ViewerStats& v) { return v.bytes_per_s; });
  out.of_viewers("viewer_dropped_sets_total", "counter",
                 "Sets dropped because the viewer reads slowly.",
                 [](const ViewerStats& v) { return v.dropped_sets; });
  out.of_viewers("viewer_dropped_audio_packets_total", "counter",
                 "Audio packets dropped because the viewer reads slowly.",
                 [](const ViewerStats& v) { return v.dropped_audio; });
  out.of_viewers("viewer_small_sensors", "gauge",
                 "Sensors of which the viewer gets the small rendition.",
                 [](const ViewerStats& v) { return v.small_sensors; });
  out.of_viewers("viewer_shown_per_second", "gauge",
                 "Frame sets that the viewer reports to have shown per second.",
                 [](const ViewerStats& v) { return v.shown_fps; });
  out.of_viewers("viewer_latency_seconds", "gauge",
                 "Capture to display, as reported by the viewer.",
                 [](const ViewerStats& v) { return v.latency_ms / 1000; });
}

}  // namespace

std::string metrics_text(const HubStats& hub, std::span<const RoomStats> rooms) {
  MetricsWriter out(rooms);
  write_hub(hub, out);
  if (hub.backplane) write_backplane(*hub.backplane, out);
  write_rooms(out);
  write_sensors(out);
  write_viewers(out);
  return out.text();
}

}  // namespace roomcast::hub
