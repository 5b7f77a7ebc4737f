// SPDX-License-Identifier: Apache-2.0
// SensorFeed: the capture pipeline of a sensor, the paper's Algorithm 1 from end to end: capture,
// map colour into the depth grid, compress, send. While nobody watches the room, or nobody there
// sees what the sensor shows, the feed captures a few frames a second, by which it notices that the
// sensor is moved, and sends none. A microphone's sound goes along while somebody watches.
// Threading: runs on a thread of its own; the methods are thread-safe.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

#include "roomcast/client/credential.h"
#include "roomcast/core/log.h"
#include "roomcast/core/result.h"
#include "roomcast/sensor/interference_meter.h"
#include "roomcast/sensor/room_microphone.h"
#include "roomcast/sensor/sender/codec_choice.h"
#include "roomcast/sound/microphone.h"
#include "roomcast/source/frame_source.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::sensor {

struct SensorFeedOptions {
  std::string hub_url;
  std::string room;
  client::Credential credential = {};
  std::string name;  // empty: the source's own
  CodecChoice codec;
  bool send_unwatched = false;  // send frames while nobody watches, too
  bool follows_rate = true;     // in live mode: keep to the share of the room's uplink
  bool wait_for_hub = false;
  bool filter_interference = true;  // live mode only; other modes send depth as it comes
  bool fill_holes = true;  // likewise: depth of large planes and between scattered readings
  bool send_pose = true;   // send the source's pose; else the hub's aligner estimates it
  std::optional<std::filesystem::path> frame_log;  // one JSON line per frame sent
  bool append_to_frame_log = false;
  sound::OpenMicrophone microphone = {};  // whose sound is sent with the frames; none: no sound
  std::filesystem::path preview;          // path of a picture, written once a second; empty: none
  LogSink log;
  std::stop_token stop = {};  // ends the wait of start() for the hub
  /// As in client::PublisherOptions.
  std::optional<wire::pb::SensorSettings> settings = {};
  std::function<void(const wire::pb::SettingsRequest&)> on_settings_request = {};
  std::function<void(const std::string& token)> on_token = {};
};

struct SensorFeedStats {
  std::uint64_t frames_sent = 0;
  std::uint64_t frames_skipped = 0;
  std::uint64_t bytes_sent = 0;
  bool is_watched = true;     // false: nobody watches the room
  bool frames_wanted = true;  // false: nobody watches or sees it, and no frames are sent
  double room_mbit = 0;       // its share of the room's uplink, Mbit/s; 0: any rate
  source::SourceHealth source;
  InterferenceFigures interference;
  /// What the line to the hub carries, with headers of TCP and IP, by estimate; 0: not estimated.
  double line_mbit_per_s = 0;
  std::optional<RoomMicrophoneStats> microphone = {};  // of a feed that has one
  bool has_finest_quality = false;  // with a target rate: more bytes would not be used
};

class SensorFeed {
 public:
  /// Opens the microphone, joins the hub, then starts sending. Errors: those of the microphone,
  /// registration, encoder and Publisher::open.
  static Result<std::unique_ptr<SensorFeed>> start(std::unique_ptr<source::FrameSource> source,
                                                   SensorFeedOptions options);
  /// Stops and leaves the hub.
  ~SensorFeed();

  [[nodiscard]] SensorFeedStats stats() const;
  /// Answers a request for other settings; an empty refusal agrees.
  void answer(std::uint32_t number, const std::string& refusal);
  /// The outcome, once the source or the connection has ended; nothing while the feed runs.
  [[nodiscard]] std::optional<Status> result() const;

 private:
  class Worker;
  explicit SensorFeed(std::unique_ptr<Worker> worker);
  std::unique_ptr<Worker> worker_;
  std::jthread thread_;
};

}  // namespace roomcast::sensor
