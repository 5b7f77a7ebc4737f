// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/retention.h"

#include <algorithm>
#include <map>

namespace roomcast::hub::daemon {

std::vector<AgingRecording> outdated(std::vector<AgingRecording> recordings,
                                     const Retention& retention, nanoseconds now) {
  std::erase_if(recordings, [](const auto& recording) { return recording.room.empty(); });
  std::ranges::stable_sort(recordings, {}, &AgingRecording::ended_at);
  std::map<std::string, std::uint64_t> bytes_of;
  for (const auto& recording : recordings) bytes_of[recording.room] += recording.bytes;
  std::vector<AgingRecording> deleted;
  for (const auto& recording : recordings) {
    if (recording.running) continue;
    std::uint64_t& bytes = bytes_of[recording.room];
    const auto age = std::chrono::duration_cast<std::chrono::days>(now - recording.ended_at);
    const RoomRetention& limits = retention.of(recording.room);
    const bool too_old = limits.max_age.count() > 0 && age >= limits.max_age;
    const bool too_many = limits.max_bytes > 0 && bytes > limits.max_bytes;
    if (!too_old && !too_many) continue;
    bytes -= recording.bytes;
    deleted.push_back(recording);
  }
  return deleted;
}

}  // namespace roomcast::hub::daemon
