// SPDX-License-Identifier: Apache-2.0
// The current problems of a room, in plain words, worst first; the same as on the page
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
  std::string about;     // constant while the sentence changes: "hub", or a sensor's name
  std::string sentence;  // ends with a full stop
};

/// A sensor is silent if nothing arrived for this long and for three of its frame intervals.
inline constexpr std::chrono::seconds kSilence{3};
/// The same while the viewer's line takes only the small rendition.
inline constexpr std::chrono::seconds kSilenceOnSlowLine{10};

/// `now`: this machine's clock.
[[nodiscard]] std::vector<RoomProblem> room_problems(const client::RoomSnapshot& room,
                                                     HostTime now);

}  // namespace roomcast::viewer
