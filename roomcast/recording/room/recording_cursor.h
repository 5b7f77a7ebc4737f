// SPDX-License-Identifier: Apache-2.0
// RecordingCursor: the messages of a recording, one after the other, in the order in which they
// were recorded. Memory: one chunk. Single-threaded.
#pragma once

#include <cstddef>

#include "roomcast/core/result.h"
#include "roomcast/recording/room/room_recording.h"

namespace roomcast::recording {

struct RecordedMessage {
  /// kFrame only where wire::parse_frame takes it and its times are plausible.
  MessageKind kind = MessageKind::kOther;
  recording::mcap::Message message;  // its data is valid until the next call of next()
};

class RecordingCursor {
 public:
  /// Begins with the first message of this chunk. `recording` outlives it.
  explicit RecordingCursor(const RoomRecording& recording, std::size_t chunk = 0)
      : recording_(&recording), next_chunk_(chunk) {}

  /// False at the end. An error says what is wrong with a chunk; the call after that goes on with
  /// the next one.
  [[nodiscard]] Result<bool> next(RecordedMessage& out);

 private:
  const RoomRecording* recording_;
  std::size_t next_chunk_;
  recording::mcap::ChunkContents chunk_;
  std::size_t next_message_ = 0;
};

}  // namespace roomcast::recording
