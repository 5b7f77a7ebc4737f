// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/hub_aligners.h"

#include <utility>

#include <fmt/format.h>

namespace roomcast::hub::daemon {

std::string own_hub_url(const OwnHub& hub) {
  std::string host = hub.listen_address;
  if (host == "0.0.0.0") host = "127.0.0.1";
  if (host == "::") host = "::1";
  if (host.find(':') != std::string::npos) host = "[" + host + "]";
  if (!hub.certificate) return fmt::format("ws://{}:{}", host, hub.port);
  return fmt::format("wss://{}:{}#sha256={}", host, hub.port, net::to_string(*hub.certificate));
}

void HubAligners::serve(OwnHub hub, std::string token) {
  const std::lock_guard lock(mutex_);
  hub_ = std::move(hub);
  token_ = std::move(token);
}

void HubAligners::trust(const net::Fingerprint& certificate) {
  const std::lock_guard lock(mutex_);
  hub_.certificate = certificate;
}

/// Starts a new aligner also for a room that was closed and opened again, because the old one has
/// ended.
void HubAligners::start(const std::string& room) {
  const std::lock_guard lock(mutex_);
  auto started = alignment::RoomAligner::open(
      {.hub_url = own_hub_url(hub_), .room = room, .token = token_, .log = log_});
  if (!started) return log_(LogLevel::kWarning, started.error().message);
  aligners_[room] = *std::move(started);
}

void HubAligners::stop(const std::string& room) {
  const std::lock_guard lock(mutex_);
  auto stopped = aligners_.extract(room);
  if (stopped)
    ending_.emplace_back([aligner = std::move(stopped.mapped())]() mutable { aligner.reset(); });
}

}  // namespace roomcast::hub::daemon
