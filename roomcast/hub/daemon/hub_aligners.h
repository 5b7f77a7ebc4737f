// SPDX-License-Identifier: Apache-2.0
// The hub's built-in aligners: one for each room that has had a sensor. They run in the hub's
// process but connect as clients. Threading: thread-safe.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "roomcast/alignment/service/room_aligner.h"
#include "roomcast/core/log.h"
#include "roomcast/core/result.h"
#include "roomcast/net/tls/fingerprint.h"

namespace roomcast::hub::daemon {

struct OwnHub {
  std::string listen_address = "127.0.0.1";
  std::uint16_t port = 0;
  std::optional<net::Fingerprint> certificate;  // if the hub uses TLS
};

/// The URL of the hub for clients on its own machine.
[[nodiscard]] std::string own_hub_url(const OwnHub& hub);

class HubAligners {
 public:
  explicit HubAligners(LogSink log) : log_(std::move(log)) {}

  /// The hub is open and accepts this token. Must be called before the hub runs.
  void serve(OwnHub hub, std::string token);
  /// The hub's certificate was renewed.
  void trust(const net::Fingerprint& certificate);

  /// A room has its first sensor.
  void start(const std::string& room);
  /// Another hub aligns the room from now on. Does not block.
  void stop(const std::string& room);

 private:
  const LogSink log_;
  std::mutex mutex_;
  OwnHub hub_;
  std::string token_;
  std::map<std::string, std::unique_ptr<alignment::RoomAligner>> aligners_;  // by room
  std::vector<std::jthread> ending_;  // each waits until an aligner has finished
};

}  // namespace roomcast::hub::daemon
