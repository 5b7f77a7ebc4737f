// SPDX-License-Identifier: Apache-2.0
// An arbitrary picture decodes bit for bit, or within the bound if there is one. Input: width - 16,
// height - 16, then pixels, repeated to fill the picture.
#include <cstdlib>

#include "roomcast/codec/lossless/lossless_depth_decoder.h"
#include "roomcast/codec/lossless/lossless_depth_encoder.h"

namespace {

using namespace roomcast;  // NOLINT: only glue in this file

void expect_lossless(const DepthImage& depth) {
  std::vector<std::uint8_t> section;
  codec::LosslessDepthEncoder().encode(depth, section);
  DepthImage decoded(depth.width(), depth.height());
  const Status status = codec::LosslessDepthDecoder().decode(section, decoded.view());
  if (!status.ok() || !(decoded == depth)) __builtin_trap();
}

void expect_near_lossless(const DepthImage& depth, int bound_mm) {
  std::vector<std::uint8_t> section;
  codec::LosslessDepthEncoder().encode_near_lossless(depth, bound_mm, section);
  DepthImage decoded(depth.width(), depth.height());
  const Status status = codec::LosslessDepthDecoder().decode_near_lossless(section, decoded.view());
  if (!status.ok()) __builtin_trap();
  for (std::size_t i = 0; i < depth.view().pixel_count(); ++i) {
    const int in = depth.data()[i], out = decoded.data()[i];
    if ((in == 0) != (out == 0) || std::abs(in - out) > bound_mm) __builtin_trap();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 4) return 0;
  const int width = 16 + data[0] % 64, height = 16 + data[1] % 64;
  const std::size_t pixels_given = (size - 2) / 2;
  DepthImage depth(width, height);
  for (std::size_t i = 0; i < depth.view().pixel_count(); ++i) {
    const std::uint8_t* pixel = data + 2 + 2 * (i % pixels_given);
    depth.data()[i] = static_cast<std::uint16_t>(pixel[0] | pixel[1] << 8);
  }
  expect_lossless(depth);
  expect_near_lossless(depth, 1 + data[0] / 64 * 20 + data[1] / 64);
  return 0;
}
