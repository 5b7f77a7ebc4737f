// SPDX-License-Identifier: Apache-2.0
// RoomPlayer: plays a recording into a hub. It joins as each recorded sensor and sends the recorded
// payloads unchanged, at the recorded capture intervals. Recorded frames cannot be turned into key
// frames: a viewer that joins sees a sensor from its next recorded key frame on, which come every
// few seconds. Threading: run() on one thread; progress() from any.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "roomcast/client/publisher.h"
#include "roomcast/client/room/frame_chain.h"
#include "roomcast/core/log.h"
#include "roomcast/core/result.h"
#include "roomcast/recording/room/room_recording.h"

namespace roomcast::recording {

struct RoomPlayerOptions {
  std::string hub_url;
  std::string room;                    // empty: the hub's only room
  client::Credential credential = {};  // used by every sensor
  double from_s = 0;  // start in the recording; decoding begins at the key frames before
  double speed = 1;   // 2: twice as fast
  bool loop = false;
  LogSink log;

  /// kInvalidArgument unless 0 <= from_s and 0.1 <= speed <= 10.
  [[nodiscard]] Status check() const;
};

struct PlayProgress {
  double position_s = 0;  // in the recording
  std::uint64_t frames_sent = 0;
};

class RoomPlayer {
 public:
  /// Joins as every sensor of `recording`, which must outlive this object. Errors as
  /// Publisher::open.
  static Result<std::unique_ptr<RoomPlayer>> open(const recording::RoomRecording& recording,
                                                  RoomPlayerOptions options);

  /// Plays until the end or `stop`. Damage in the recording (kMalformed) is only logged; returned
  /// errors are those of the hub.
  Status run(std::stop_token stop);

  [[nodiscard]] PlayProgress progress() const;

 private:
  struct Sensor {
    std::unique_ptr<client::Publisher> publisher;
    client::FrameChain chain;  // of the frames sent
    std::uint64_t session = 0;
  };

  RoomPlayer(const recording::RoomRecording& recording, RoomPlayerOptions options)
      : recording_(recording), options_(std::move(options)) {}
  Status join();
  void send_bundles();
  /// Plays once from `from` to the end. Returns false when stopped.
  Result<bool> play_from(nanoseconds from, const std::stop_token& stop);
  Status send(Sensor& sensor, const recording::mcap::Message& message, HostTime capture_time,
              const std::stop_token& stop);
  void wait_until_sent(const std::stop_token& stop) const;

  const recording::RoomRecording& recording_;
  const RoomPlayerOptions options_;
  std::map<recording::mcap::ChannelId, Sensor> sensors_;
  std::atomic<double> position_s_ = 0;
  std::atomic<std::uint64_t> published_ = 0;
};

}  // namespace roomcast::recording
