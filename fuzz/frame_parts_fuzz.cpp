// SPDX-License-Identifier: Apache-2.0
// Parts of frames from a broker: arbitrary bytes are safe, and packed frames are unpacked
// unchanged. Input: length and bytes of each message; for packing, the same pieces are the frames.
#include <algorithm>
#include <span>
#include <vector>

#include "roomcast/hub/federation/cluster/frame_parts.h"
#include "roomcast/wire/limits.h"

namespace {

using Bytes = std::span<const std::uint8_t>;
using roomcast::hub::federation::FramePacker, roomcast::hub::federation::FrameUnpacker;

std::vector<Bytes> pieces_of(Bytes input) {
  std::vector<Bytes> pieces;
  while (!input.empty()) {
    const std::size_t size = std::min<std::size_t>(input[0], input.size() - 1);
    pieces.push_back(input.subspan(1, size));
    input = input.subspan(1 + size);
  }
  return pieces;
}

void take_anything(const std::vector<Bytes>& messages) {
  FrameUnpacker unpacker;
  for (const Bytes message : messages) {
    unpacker.take(message, [](const roomcast::net::MessageBuffer& frame) {
      if (frame.size() > roomcast::wire::kMaxFrameBytes) __builtin_trap();
    });
    if (unpacker.partial_bytes() > 2 * roomcast::wire::kMaxFrameBytes) __builtin_trap();
  }
}

void give_back_what_was_packed(const std::vector<Bytes>& frames, std::size_t max_message_bytes) {
  FramePacker packer(max_message_bytes);
  for (const Bytes frame : frames) packer.add(frame);
  FrameUnpacker unpacker;
  std::size_t next = 0;
  for (const auto& message : packer.take()) {
    if (message.size() > max_message_bytes) __builtin_trap();
    unpacker.take(message, [&](const roomcast::net::MessageBuffer& frame) {
      if (!std::ranges::equal(frame.payload(), frames[next++])) __builtin_trap();
    });
  }
  if (next != frames.size()) __builtin_trap();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto pieces = pieces_of({data, size});
  take_anything(pieces);
  give_back_what_was_packed(pieces, roomcast::hub::federation::kPartHeaderBytes + 1 + data[0] % 64);
  return 0;
}
