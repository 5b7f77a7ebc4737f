// SPDX-License-Identifier: Apache-2.0
#include "bench/codec_under_test.h"
#include "roomcast/codec/frame_codec.h"
#include "roomcast/codec/lossless_depth_decoder.h"
#include "roomcast/codec/lossless_depth_encoder.h"
#include "roomcast/codec/payload_sections.h"

namespace roomcast::bench {
namespace {

class Roomcast final : public CodecUnderTest {
 public:
  Roomcast(std::unique_ptr<codec::FrameEncoder> encoder,
           std::unique_ptr<codec::FrameDecoder> decoder)
      : encoder_(std::move(encoder)), decoder_(std::move(decoder)) {}
  std::string name() const override { return "roomcast"; }
  std::string mode() const override { return "lossless"; }

  Result<FrameCost> run(const BenchFrame& frame, BenchFrame& decoded) override {
    payload_.clear();
    const ColorView color = frame.color.empty() ? ColorView{} : ColorView(frame.color);
    const MaskView seen = frame.color.empty() ? MaskView{} : MaskView(frame.seen);
    const double start = thread_cpu_ms();
    const auto info = encoder_->encode(frame.depth_mm, color, seen, false, payload_);
    if (!info.ok()) return info.error();
    const double encoded = thread_cpu_ms();
    if (Status s = decoder_->decode(payload_, decoded_); !s.ok()) return s.error();
    FrameCost cost;
    cost.encode_ms = encoded - start;
    cost.decode_ms = thread_cpu_ms() - encoded;
    const auto sections =
        codec::parse_sections(payload_, frame.depth_mm.width(), frame.depth_mm.height());
    if (!sections.ok()) return sections.error();
    cost.color_bytes =
        sections->has_color ? sections->color.size() + codec::kSectionHeaderLength : 0;
    cost.depth_bytes = payload_.size() - cost.color_bytes;
    decoded.depth_mm = decoded_.depth_mm;
    decoded.color = decoded_.color;
    decoded.seen = decoded_.color_seen;
    return measure_depth(frame, cost);
  }

 private:
  /// The same once more without colour, for the columns that compare depth codecs.
  Result<FrameCost> measure_depth(const BenchFrame& frame, FrameCost cost) {
    section_.clear();
    const double start = thread_cpu_ms();
    depth_encoder_.encode(frame.depth_mm, section_);
    const double encoded = thread_cpu_ms();
    if (Status s = depth_decoder_.decode(section_, decoded_.depth_mm.view()); !s.ok())
      return s.error();
    cost.depth_encode_ms = encoded - start;
    cost.depth_decode_ms = thread_cpu_ms() - encoded;
    return cost;
  }

  std::unique_ptr<codec::FrameEncoder> encoder_;
  std::unique_ptr<codec::FrameDecoder> decoder_;
  codec::LosslessDepthEncoder depth_encoder_;
  codec::LosslessDepthDecoder depth_decoder_;
  codec::DecodedFrame decoded_;
  std::vector<std::uint8_t> payload_, section_;
};

}  // namespace

Result<std::unique_ptr<CodecUnderTest>> make_roomcast(int width, int height, double fps,
                                                      int color_kbit_per_s) {
  codec::FrameEncoderOptions options;
  options.width = width;
  options.height = height;
  options.fps = fps;
  options.color_kbit_per_s = color_kbit_per_s;
  auto encoder = codec::FrameEncoder::create(options);
  if (!encoder.ok()) return encoder.error();
  auto decoder = codec::FrameDecoder::create(width, height);
  if (!decoder.ok()) return decoder.error();
  return std::unique_ptr<CodecUnderTest>(
      std::make_unique<Roomcast>(std::move(*encoder), std::move(*decoder)));
}

}  // namespace roomcast::bench
