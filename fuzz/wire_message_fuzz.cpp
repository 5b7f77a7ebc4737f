// SPDX-License-Identifier: Apache-2.0
// Parses arbitrary bytes as one wire message, from both sides. Accepted messages must satisfy the
// invariants that hub and clients rely on: the lengths of a frame or an audio packet add up,
// stamping it changes nothing else, a control message is unchanged after writing and reading.
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "roomcast/core/assert.h"
#include "roomcast/wire/audio_header.h"
#include "roomcast/wire/control.h"
#include "roomcast/wire/frame_header.h"
#include "roomcast/wire/limits.h"

namespace {

using namespace roomcast;
using namespace roomcast::wire;

void read_frame(std::span<const std::uint8_t> message) {
  const auto header = parse_frame(message);
  if (!header) return;
  ROOMCAST_ASSERT(header->header_length + header->payload_length == message.size());
  std::vector<std::uint8_t> copy(message.begin(), message.end());
  stamp_frame_set(copy, SetId{42}, !header->last);
  auto expected = *header;
  expected.set = SetId{42};
  expected.last = !header->last;
  ROOMCAST_ASSERT(*parse_frame(copy) == expected);
}

void read_audio(std::span<const std::uint8_t> message) {
  const auto header = parse_audio(message);
  if (!header) return;
  ROOMCAST_ASSERT(std::size_t{header->header_length} + header->payload_length == message.size());
  std::vector<std::uint8_t> copy(message.begin(), message.end());
  stamp_speaker(copy, ViewerId{42});
  auto expected = *header;
  expected.speaker = ViewerId{42};
  ROOMCAST_ASSERT(*parse_audio(copy) == expected);
}

void read_control(std::span<const std::uint8_t> message, Sender sender) {
  const auto control = decode_control(message, sender);
  if (!control) {
    ROOMCAST_ASSERT(!control.error().message.empty());
    return;
  }
  std::vector<std::uint8_t> written;
  encode_control(*control, written);
  if (written.size() <= kMaxControlFromClientBytes)
    ROOMCAST_ASSERT(decode_control(written, sender).ok());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span message(data, size);
  const auto type = message_type(message);
  if (!type) return 0;
  if (*type == MessageType::kFrame) {
    read_frame(message);
  } else if (*type == MessageType::kAudio) {
    read_audio(message);
  } else {
    read_control(message, Sender::kClient);
    read_control(message, Sender::kHub);
  }
  return 0;
}
