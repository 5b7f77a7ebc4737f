// SPDX-License-Identifier: Apache-2.0
// RoomRecordings: the admin interface's view of the recorder that writes this hub's rooms to files.
// The hub itself writes none. Threading: called on the rooms' thread; no member may block.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "roomcast/core/result.h"
#include "roomcast/hub/runtime/kept_recordings.h"

namespace roomcast::hub {

enum class RecordingState { kOff, kStarting, kOn, kStopping, kFailed };

[[nodiscard]] constexpr std::string_view name_of(RecordingState state) {
  switch (state) {
    case RecordingState::kOff:
      return "off";
    case RecordingState::kStarting:
      return "starting";
    case RecordingState::kOn:
      return "on";
    case RecordingState::kStopping:
      return "stopping";
    case RecordingState::kFailed:
      break;
  }
  return "failed";
}

/// The running recording of a room, or its last one.
struct RoomRecording {
  RecordingState state = RecordingState::kOff;
  std::string file;  // on the hub's machine; empty: no recording yet
  double seconds = 0;
  std::uint64_t frames = 0, bytes = 0;
  std::string problem;  // why it failed; empty: it did not fail
};

class RoomRecordings {
 public:
  virtual ~RoomRecordings() = default;
  /// `by`: who wants it, for the file; may be empty. kInvalidArgument: the room is being recorded
  /// already.
  virtual Status start(const std::string& room, const std::string& by) = 0;
  /// kInvalidArgument: it is not being recorded.
  virtual Status stop(const std::string& room) = 0;
  [[nodiscard]] virtual RoomRecording now(const std::string& room) const = 0;
  /// The files made so far.
  [[nodiscard]] virtual KeptRecordings& kept() = 0;
};

}  // namespace roomcast::hub
