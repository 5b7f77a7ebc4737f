// SPDX-License-Identifier: Apache-2.0
// Decodes arbitrary bytes as a depth section and as a colour mask. Input: width - 16, height - 16,
// then the section.
#include "roomcast/codec/lossless/lossless_depth_decoder.h"
#include "roomcast/codec/mask/color_mask.h"
#include "roomcast/codec/payload/payload_sections.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const int width = 16 + data[0] % 64, height = 16 + data[1] % 64;
  const std::span<const std::uint8_t> section(data + 2, size - 2);
  roomcast::DepthImage depth(width, height);
  roomcast::MaskImage mask(width, height);
  roomcast::codec::LosslessDepthDecoder decoder;
  const roomcast::Status status = decoder.decode(section, depth.view());
  if (!status.ok() && status.error().message.empty()) __builtin_trap();
  const roomcast::Status near_lossless = decoder.decode_near_lossless(section, depth.view());
  if (!near_lossless.ok() && near_lossless.error().message.empty()) __builtin_trap();
  roomcast::codec::ColorMaskDecoder masks;
  for (const std::uint8_t codec : {roomcast::codec::kIntraMask, roomcast::codec::kMaskChange}) {
    (void)masks.decode(codec, section, depth, mask.view());
  }
  return 0;
}
