// SPDX-License-Identifier: Apache-2.0
// What is wrong with a room, in plain words, worst first; the same as on the page
// (web/src/panel/problems.ts). Pure.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "roomcast/client/room/room_snapshot.h"

namespace roomcast::viewer {

struct RoomProblem {
  enum class Severity { kError, kNotice };
  Severity severity = Severity::kError;
  std::string about;     // stays the same while the sentence changes: "hub", or a sensor's name
  std::string sentence;  // with a full stop
};

/// A sensor of which nothing came for so long, and three of its frames, is silent.
inline constexpr std::chrono::seconds kSilence{3};

/// `now`: of this machine.
[[nodiscard]] std::vector<RoomProblem> room_problems(const client::RoomSnapshot& room, HostTime now);

}  // namespace roomcast::viewer
