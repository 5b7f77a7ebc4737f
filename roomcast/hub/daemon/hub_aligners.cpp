// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/hub_aligners.h"

#include <utility>

namespace roomcast::hub::daemon {

/// Starts a new aligner also for a room that was closed and opened again, because the old one has
/// ended.
void HubAligners::start(const std::string& room) {
  const OwnHub::Access access = hub_.access();
  const std::lock_guard lock(mutex_);
  auto started = alignment::RoomAligner::open(
      {.hub_url = access.url, .room = room, .token = access.token, .log = log_});
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
