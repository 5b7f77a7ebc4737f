// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "bench/codec/cpu_stopwatch.h"
#include "bench/codec/peers/peers.h"
#include "bench/codec/peers/rvl.h"
#include "bench/codec/peers/temporal_rvl.h"

namespace roomcast::bench {
namespace {

std::span<const std::uint16_t> pixels_of(const DepthImage& image) {
  return {image.data(), image.view().pixel_count()};
}

class Rvl final : public CodecUnderTest {
 public:
  Result<FrameCost> run(const BenchFrame& frame, bool, BenchFrame& decoded) override {
    decoded.depth_mm.resize(frame.depth_mm.width(), frame.depth_mm.height());
    bytes_.clear();
    const CpuStopwatch encoding;
    encode_rvl(pixels_of(frame.depth_mm), bytes_);
    const double encode_ms = encoding.ms();
    const CpuStopwatch decoding;
    decode_rvl(bytes_, std::span(decoded.depth_mm.data(), pixels_of(decoded.depth_mm).size()));
    return FrameCost{bytes_.size(), 0, encode_ms, decoding.ms()};
  }

 private:
  std::vector<std::uint8_t> bytes_;
};

class TemporalRvl final : public CodecUnderTest {
 public:
  TemporalRvl(std::size_t pixel_count, int max_error_mm)
      : encoder_(pixel_count, max_error_mm), decoder_(pixel_count) {}

  Result<FrameCost> run(const BenchFrame& frame, bool want_key, BenchFrame& decoded) override {
    bytes_.clear();
    const CpuStopwatch encoding;
    encoder_.encode(pixels_of(frame.depth_mm), want_key, bytes_);
    const double encode_ms = encoding.ms();
    const CpuStopwatch decoding;
    const auto depth = decoder_.decode(bytes_, want_key);
    const double decode_ms = decoding.ms();
    decoded.depth_mm.resize(frame.depth_mm.width(), frame.depth_mm.height());
    std::copy(depth.begin(), depth.end(), decoded.depth_mm.data());
    return FrameCost{bytes_.size(), 0, encode_ms, decode_ms};
  }

 private:
  TemporalRvlEncoder encoder_;
  TemporalRvlDecoder decoder_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace

PeerResult make_rvl(const BenchPicture&) {
  return std::unique_ptr<CodecUnderTest>(std::make_unique<Rvl>());
}
PeerResult make_temporal_rvl(const BenchPicture& picture, int max_error_mm) {
  return std::unique_ptr<CodecUnderTest>(std::make_unique<TemporalRvl>(
      static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height),
      max_error_mm));
}

}  // namespace roomcast::bench
