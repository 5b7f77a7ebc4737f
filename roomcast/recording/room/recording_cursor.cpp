// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/room/recording_cursor.h"

#include <utility>

#include "roomcast/wire/audio_header.h"
#include "roomcast/wire/frame_header.h"

namespace roomcast::recording {
namespace {

bool is_sound(const recording::mcap::Message& message) {
  return is_plausible(message.log_time) && is_plausible(message.publish_time);
}

bool is_sound_frame(const recording::mcap::Message& message) {
  const auto header = wire::parse_frame(message.data);
  return header && is_plausible(header->capture_time.time_since_epoch());
}

bool is_sound_voice(const recording::mcap::Message& message) {
  const auto header = wire::parse_audio(message.data);
  return header && is_plausible(header->capture_time.time_since_epoch());
}

}  // namespace

Result<bool> RecordingCursor::next(RecordedMessage& out) {
  while (next_message_ == chunk_.messages.size()) {
    if (next_chunk_ == recording_->file().summary().chunks.size()) return false;
    chunk_ = {};
    next_message_ = 0;
    auto chunk = recording_->file().chunk(next_chunk_++);
    if (!chunk) return chunk.error();
    chunk_ = std::move(*chunk);
  }
  out.message = chunk_.messages[next_message_++];
  out.kind = is_sound(out.message) ? recording_->kind_of(out.message.channel) : MessageKind::kOther;
  if (out.kind == MessageKind::kFrame && !is_sound_frame(out.message))
    out.kind = MessageKind::kOther;
  if (out.kind == MessageKind::kVoice && !is_sound_voice(out.message))
    out.kind = MessageKind::kOther;
  return true;
}

}  // namespace roomcast::recording
