// SPDX-License-Identifier: Apache-2.0
// Reads an untrusted recording of a room: it is refused, or read up to its end or the damage.
#include <cstddef>
#include <cstdint>

#include "roomcast/recording/room/recording_cursor.h"
#include "roomcast/recording/room/room_recording.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace roomcast;
  auto file =
      recording::mcap::Reader::read(recording::bytes_in_memory({data, data + size}), "fuzz");
  if (!file || file->summary().chunks.size() > 64) return 0;
  const auto recording = recording::RoomRecording::from(std::move(*file));
  if (!recording) return 0;
  recording::RecordingCursor cursor(
      *recording, recording->chunk_to_decode_from(recording->origin() + std::chrono::seconds(1),
                                                  recording->sensors()));
  recording::RecordedMessage message;
  for (auto more = cursor.next(message); !more || *more; more = cursor.next(message)) {
    if (more && message.kind == recording::MessageKind::kFrame && message.message.data.empty())
      __builtin_trap();
  }
  return 0;
}
