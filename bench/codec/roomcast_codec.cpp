// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/roomcast_codec.h"

#include <limits>
#include <vector>

#include "bench/codec/cpu_stopwatch.h"
#include "roomcast/codec/color/vp9_color_decoder.h"
#include "roomcast/codec/color/vp9_color_encoder.h"
#include "roomcast/codec/frame_codec.h"
#include "roomcast/codec/payload/layer_schedule.h"
#include "roomcast/codec/payload/payload_sections.h"

namespace roomcast::bench {
namespace {

constexpr double kWhenAskedFor_s = 3600;

codec::FrameEncoderOptions options_for(const BenchPicture& picture, codec::DepthMode mode) {
  codec::FrameEncoderOptions options;
  options.width = picture.width;
  options.height = picture.height;
  options.fps = picture.fps;
  options.depth_mode = mode;
  options.key_interval_s = kWhenAskedFor_s;
  options.color_kbit_per_s = picture.color_kbit_per_s;
  return options;
}

class RoomcastFrames final : public CodecUnderTest {
 public:
  RoomcastFrames(bool with_color, std::unique_ptr<codec::FrameEncoder> encoder,
                 std::unique_ptr<codec::FrameDecoder> decoder)
      : with_color_(with_color), encoder_(std::move(encoder)), decoder_(std::move(decoder)) {}

  Result<FrameCost> run(const BenchFrame& frame, bool want_key, BenchFrame& decoded) override {
    const bool colored = with_color_ && !frame.color.empty();
    payload_.clear();
    const CpuStopwatch encoding;
    const auto info =
        encoder_->encode(frame.depth_mm, colored ? ColorView(frame.color) : ColorView{},
                         colored ? MaskView(frame.seen) : MaskView{}, want_key, payload_);
    if (!info.ok()) return info.error();
    FrameCost cost;
    cost.encode_ms = encoding.ms();
    const CpuStopwatch decoding;
    if (Status s = decoder_->decode(payload_, decoded_); !s.ok()) return s.error();
    cost.decode_ms = decoding.ms();
    decoded.depth_mm = decoded_.depth_mm;
    decoded.color = decoded_.color;
    decoded.seen = decoded_.color_seen;
    return share(frame, cost);
  }

 private:
  /// Splits the cost: the colour section counts as colour, everything else as depth.
  Result<FrameCost> share(const BenchFrame& frame, FrameCost cost) const {
    const auto sections =
        codec::parse_sections(payload_, frame.depth_mm.width(), frame.depth_mm.height());
    if (!sections.ok()) return sections.error();
    if (sections->has_color)
      cost.color_bytes = sections->color.size() + codec::kSectionHeaderLength;
    cost.depth_bytes = payload_.size() - cost.color_bytes;
    return cost;
  }

  const bool with_color_;
  std::unique_ptr<codec::FrameEncoder> encoder_;
  std::unique_ptr<codec::FrameDecoder> decoder_;
  codec::DecodedFrame decoded_;
  std::vector<std::uint8_t> payload_;
};

class RoomcastColor final : public CodecUnderTest {
 public:
  RoomcastColor(const codec::FrameEncoderOptions& options,
                std::unique_ptr<codec::Vp9ColorEncoder> encoder,
                std::unique_ptr<codec::Vp9ColorDecoder> decoder)
      : schedule_(options.temporal_layers, std::numeric_limits<int>::max()),
        encoder_(std::move(encoder)),
        decoder_(std::move(decoder)) {}

  Result<FrameCost> run(const BenchFrame& frame, bool want_key, BenchFrame& decoded) override {
    bytes_.clear();
    const CpuStopwatch encoding;
    const codec::FrameRole role = schedule_.next(want_key);
    if (Status s = encoder_->encode(frame.color, frame.seen, role, bytes_); !s.ok())
      return s.error();
    const double encode_ms = encoding.ms();
    const CpuStopwatch decoding;
    if (Status s = decoder_->decode(bytes_, decoded.color); !s.ok()) return s.error();
    decoded.seen = frame.seen;
    return FrameCost{0, bytes_.size(), encode_ms, decoding.ms()};
  }

 private:
  codec::LayerSchedule schedule_;
  std::unique_ptr<codec::Vp9ColorEncoder> encoder_;
  std::unique_ptr<codec::Vp9ColorDecoder> decoder_;
  std::vector<std::uint8_t> bytes_;
};

Result<std::unique_ptr<CodecUnderTest>> make_frames(const codec::FrameEncoderOptions& options,
                                                    bool with_color,
                                                    const codec::FrameTarget& target = {}) {
  auto encoder = codec::FrameEncoder::create(options);
  if (!encoder.ok()) return encoder.error();
  (*encoder)->set_target(target);
  auto decoder = codec::FrameDecoder::create(options.width, options.height);
  if (!decoder.ok()) return decoder.error();
  return std::unique_ptr<CodecUnderTest>(
      std::make_unique<RoomcastFrames>(with_color, std::move(*encoder), std::move(*decoder)));
}

}  // namespace

Result<std::unique_ptr<CodecUnderTest>> make_roomcast_lossless(const BenchPicture& picture) {
  return make_frames(options_for(picture, codec::DepthMode::kLossless), false);
}

Result<std::unique_ptr<CodecUnderTest>> make_roomcast_near_lossless(const BenchPicture& picture,
                                                                    int bound_mm) {
  auto options = options_for(picture, codec::DepthMode::kNearLossless);
  options.depth_bound_mm = bound_mm;
  return make_frames(options, false);
}

Result<std::unique_ptr<CodecUnderTest>> make_roomcast_live(const BenchPicture& picture) {
  return make_frames(options_for(picture, codec::DepthMode::kLive), false);
}

Result<std::unique_ptr<CodecUnderTest>> make_roomcast_live_with_color(const BenchPicture& picture) {
  return make_frames(options_for(picture, codec::DepthMode::kLive), true);
}

Result<std::unique_ptr<CodecUnderTest>> make_roomcast_live_at_rate(const BenchPicture& picture,
                                                                   double mbit_per_s) {
  constexpr double kKeyCost_s = 0.3;  // RateControl's
  const double bytes_per_s = mbit_per_s * 1e6 / 8;
  return make_frames(options_for(picture, codec::DepthMode::kLive), true,
                     {bytes_per_s / picture.fps, kKeyCost_s * bytes_per_s});
}

Result<std::unique_ptr<CodecUnderTest>> make_roomcast_color(const BenchPicture& picture) {
  const auto options = options_for(picture, codec::DepthMode::kLive);
  auto encoder = codec::Vp9ColorEncoder::create(options);
  if (!encoder.ok()) return encoder.error();
  auto decoder = codec::Vp9ColorDecoder::create(picture.width, picture.height);
  if (!decoder.ok()) return decoder.error();
  return std::unique_ptr<CodecUnderTest>(
      std::make_unique<RoomcastColor>(options, std::move(*encoder), std::move(*decoder)));
}

}  // namespace roomcast::bench
