// SPDX-License-Identifier: Apache-2.0
// RecordingCursor: iterates over the messages of a recording in the order in which they were
// recorded. Memory: one chunk. Single-threaded.
#pragma once

#include <cstddef>

#include "roomcast/core/result.h"
#include "roomcast/recording/room/room_recording.h"

namespace roomcast::recording {

struct RecordedMessage {
  /// kFrame only if wire::parse_frame accepts the message and its times are plausible; kVoice
  /// likewise by wire::parse_audio.
  MessageKind kind = MessageKind::kOther;
  recording::mcap::Message message;  // data is valid until the next call of next()
};

class RecordingCursor {
 public:
  /// Starts with the first message of `chunk`. `recording` must outlive the cursor.
  explicit RecordingCursor(const RoomRecording& recording, std::size_t chunk = 0)
      : recording_(&recording), next_chunk_(chunk) {}

  /// Returns false at the end. An error describes a damaged chunk; the following call continues
  /// with the next chunk.
  [[nodiscard]] Result<bool> next(RecordedMessage& out);

 private:
  const RoomRecording* recording_;
  std::size_t next_chunk_;
  recording::mcap::ChunkContents chunk_;
  std::size_t next_message_ = 0;
};

}  // namespace roomcast::recording
