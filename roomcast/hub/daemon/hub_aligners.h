// SPDX-License-Identifier: Apache-2.0
// The hub's built-in aligners: one for each room that has had a sensor. They run in the hub's
// process but connect as clients. Threading: thread-safe.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "roomcast/alignment/service/room_aligner.h"
#include "roomcast/core/log.h"
#include "roomcast/hub/daemon/own_hub.h"

namespace roomcast::hub::daemon {

class HubAligners {
 public:
  /// `hub` must outlive the aligners.
  HubAligners(const OwnHub& hub, LogSink log) : hub_(hub), log_(std::move(log)) {}

  /// A room has its first sensor.
  void start(const std::string& room);
  /// Another hub aligns the room from now on. Does not block.
  void stop(const std::string& room);

 private:
  const OwnHub& hub_;
  const LogSink log_;
  std::mutex mutex_;
  std::map<std::string, std::unique_ptr<alignment::RoomAligner>> aligners_;  // by room
  std::vector<std::jthread> ending_;  // each waits until an aligner has finished
};

}  // namespace roomcast::hub::daemon
