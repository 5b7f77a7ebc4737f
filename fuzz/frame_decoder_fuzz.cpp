// SPDX-License-Identifier: Apache-2.0
// Decodes arbitrary bytes as a sequence of frames of one sensor. Input: for each frame u16 length,
// little-endian, and its payload.
#include <algorithm>

#include "roomcast/codec/frame_codec.h"

namespace {

constexpr int kWidth = 64, kHeight = 48;

void check(const roomcast::codec::DecodedFrame& frame) {
  if (frame.depth_mm.width() != kWidth || frame.depth_mm.height() != kHeight) __builtin_trap();
  if (frame.color.empty() != frame.color_seen.empty()) __builtin_trap();
  if (!frame.color.empty() && frame.color.width() != kWidth) __builtin_trap();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  auto decoder = roomcast::codec::FrameDecoder::create(kWidth, kHeight);
  roomcast::codec::DecodedFrame frame;
  std::span<const std::uint8_t> rest(data, size);
  while (rest.size() >= 2) {
    const std::size_t length = std::min<std::size_t>(rest[0] | rest[1] << 8, rest.size() - 2);
    if ((*decoder)->decode(rest.subspan(2, length), frame).ok()) check(frame);
    rest = rest.subspan(2 + length);
  }
  return 0;
}
