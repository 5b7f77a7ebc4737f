// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/service/picture_bytes.h"

#include <utility>
#include <vector>

#include "roomcast/codec/frame_codec.h"

namespace roomcast::alignment {

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

Result<std::string> lossless_bytes(DepthView picture) {
  codec::FrameEncoderOptions options;
  options.width = picture.width;
  options.height = picture.height;
  options.temporal_layers = 1;
  options.depth_mode = codec::DepthMode::kLossless;
  const auto encoder = codec::FrameEncoder::create(options);
  if (!encoder) return encoder.error();
  std::vector<std::uint8_t> bytes;
  const auto encoded = (*encoder)->encode(picture, {}, {}, true, bytes);
  if (!encoded) return encoded.error();
  return std::string(bytes.begin(), bytes.end());
}

Result<DepthImage> picture_of_bytes(const std::string& bytes, int width, int height) {
  const auto decoder = codec::FrameDecoder::create(width, height);
  if (!decoder) return decoder.error();
  codec::DecodedFrame frame;
  if (auto status = (*decoder)->decode(bytes_of(bytes), frame); !status) return status.error();
  return std::move(frame.depth_mm);
}

}  // namespace roomcast::alignment
