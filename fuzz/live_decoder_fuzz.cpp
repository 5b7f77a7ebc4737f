// SPDX-License-Identifier: Apache-2.0
// Decodes arbitrary bytes as a sequence of live depth sections. Input: for each section u16 length,
// little-endian, and its bytes. The hash of each is corrected, because otherwise nothing after the
// first key frame would be decoded.
#include <algorithm>
#include <vector>

#include "roomcast/codec/live/live_depth_decoder.h"
#include "roomcast/core/little_endian.h"

namespace {

using namespace roomcast;  // NOLINT: only glue in this file

constexpr int kWidth = 33, kHeight = 18;  // those of the golden frames live_random
constexpr std::size_t kMaxSections = 24;

void decode(codec::LiveDepthDecoder& decoder, std::span<const std::uint8_t> bytes,
            DepthImage& out) {
  std::vector<std::uint8_t> section(bytes.begin(), bytes.end());
  codec::LiveDepthDecoder trial = decoder;
  if (section.size() >= 6 && !trial.decode(section, out.view()).ok()) {
    write_u32(&section[codec::kLiveHashOffset], trial.state().hash);
  }
  (void)decoder.decode(section, out.view());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  codec::LiveDepthDecoder decoder;
  DepthImage out(kWidth, kHeight);
  std::span<const std::uint8_t> rest(data, size);
  for (std::size_t i = 0; i < kMaxSections && rest.size() >= 2; ++i) {
    const std::size_t length = std::min<std::size_t>(rest[0] | rest[1] << 8, rest.size() - 2);
    decode(decoder, rest.subspan(2, length), out);
    rest = rest.subspan(2 + length);
  }
  return 0;
}
