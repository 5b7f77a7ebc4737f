// SPDX-License-Identifier: Apache-2.0
// Any picture comes back bit for bit. Input: width - 16, height - 16, then pixels, repeated to fill
// the picture.
#include "roomcast/codec/lossless/lossless_depth_decoder.h"
#include "roomcast/codec/lossless/lossless_depth_encoder.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 4) return 0;
  const int width = 16 + data[0] % 64, height = 16 + data[1] % 64;
  const std::size_t pixels_given = (size - 2) / 2;
  roomcast::DepthImage depth(width, height), decoded(width, height);
  for (std::size_t i = 0; i < depth.view().pixel_count(); ++i) {
    const std::uint8_t* pixel = data + 2 + 2 * (i % pixels_given);
    depth.data()[i] = static_cast<std::uint16_t>(pixel[0] | pixel[1] << 8);
  }
  std::vector<std::uint8_t> section;
  roomcast::codec::LosslessDepthEncoder().encode(depth, section);
  const roomcast::Status status =
      roomcast::codec::LosslessDepthDecoder().decode(section, decoded.view());
  if (!status.ok() || !(decoded == depth)) __builtin_trap();
  return 0;
}
