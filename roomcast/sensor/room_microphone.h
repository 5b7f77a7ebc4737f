// SPDX-License-Identifier: Apache-2.0
// RoomMicrophone: the sound at a sensor, to its hub: 20 ms at a time, as Opus, ahead of the
// sensor's frames. Sends while somebody is there to hear it and the room permits it. A device that
// goes away is looked for until it is back. Threading: runs on a thread of its own; the methods are
// thread-safe.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "roomcast/client/publisher.h"
#include "roomcast/client/voices/spoken_voice.h"
#include "roomcast/core/log.h"
#include "roomcast/sound/microphone.h"

namespace roomcast::sensor {

struct RoomMicrophoneStats {
  bool is_connected = true;   // to the device
  bool is_permitted = false;  // by the room
  bool has_ended = false;     // a file that is played once
  double loudness = 0;        // of the newest 20 ms: root of the mean square, full scale is 1
  std::uint64_t packets_sent = 0;
};

class RoomMicrophone {
 public:
  /// `reopens` finds the device again. `publisher` outlives this.
  RoomMicrophone(std::unique_ptr<sound::Microphone> microphone, sound::OpenMicrophone reopens,
                 client::Publisher& publisher, LogSink log);
  ~RoomMicrophone();

  [[nodiscard]] RoomMicrophoneStats stats() const;

 private:
  void run(const std::stop_token& stop);
  [[nodiscard]] bool look_for_device(const std::stop_token& stop);
  void take(const sound::Microphone::Block& block);
  void pause();
  void send(client::SpokenPacket packet);
  void tell_of_permission(bool is_permitted);
  template <class Change>
  void change(Change how) {
    const std::lock_guard lock(mutex_);
    how(stats_);
  }

  std::unique_ptr<sound::Microphone> microphone_;
  const sound::OpenMicrophone reopens_;
  client::Publisher& publisher_;
  const LogSink log_;
  client::SpokenVoice voice_;
  bool was_refused_ = false;

  mutable std::mutex mutex_;
  RoomMicrophoneStats stats_;
  std::jthread thread_;  // last: uses all of the above
};

}  // namespace roomcast::sensor
