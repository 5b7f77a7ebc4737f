// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <vector>

#include <aom/aom_decoder.h>
#include <aom/aom_encoder.h>
#include <aom/aomcx.h>
#include <aom/aomdx.h>
#include <zstd.h>

#include "bench/codec/cpu_stopwatch.h"
#include "bench/codec/peers/peers.h"

namespace roomcast::bench {
namespace {

constexpr int kBits = 12, kMaxValue = (1 << kBits) - 1;
constexpr int kSpeed = 8;  // fast enough for live video
constexpr int kMaskLevel = 3;
constexpr int kKeyEvery = 9999;  // key frames are requested explicitly

Error av1_failure(const char* what) {
  return {ErrorCode::kUnavailable, std::string("libaom could not ") + what + "."};
}

/// Destroys the codec context with its owner.
struct AomContext {
  AomContext() = default;
  AomContext(const AomContext&) = delete;
  AomContext& operator=(const AomContext&) = delete;
  ~AomContext() {
    if (open) aom_codec_destroy(&context);
  }
  aom_codec_ctx_t context{};
  bool open = false;
};

bool open_encoder(const BenchPicture& picture, int quality, AomContext& encoder) {
  aom_codec_enc_cfg_t config;
  if (aom_codec_enc_config_default(aom_codec_av1_cx(), &config, AOM_USAGE_REALTIME) != AOM_CODEC_OK)
    return false;
  config.g_w = static_cast<unsigned>(picture.width);
  config.g_h = static_cast<unsigned>(picture.height);
  config.g_timebase = {1000, static_cast<int>(std::lround(picture.fps * 1000))};
  config.g_profile = 2;
  config.g_bit_depth = AOM_BITS_12;
  config.g_input_bit_depth = kBits;
  config.monochrome = 1;
  config.g_threads = 1;
  config.g_lag_in_frames = 0;
  config.rc_end_usage = AOM_Q;
  config.kf_max_dist = kKeyEvery;
  if (aom_codec_enc_init(&encoder.context, aom_codec_av1_cx(), &config,
                         AOM_CODEC_USE_HIGHBITDEPTH) != AOM_CODEC_OK) {
    return false;
  }
  encoder.open = true;
  return aom_codec_control(&encoder.context, AOME_SET_CPUUSED, kSpeed) == AOM_CODEC_OK &&
         aom_codec_control(&encoder.context, AOME_SET_CQ_LEVEL, quality) == AOM_CODEC_OK;
}

bool open_decoder(AomContext& decoder) {
  const aom_codec_dec_cfg_t config{1, 0, 0, 1};
  decoder.open =
      aom_codec_dec_init(&decoder.context, aom_codec_av1_dx(), &config, 0) == AOM_CODEC_OK;
  return decoder.open;
}

/// Packs the validity mask, one bit per pixel.
class MaskPacker {
 public:
  std::size_t pack(const DepthImage& depth_mm) {
    bits_.assign((depth_mm.view().pixel_count() + 7) / 8, 0);
    for (std::size_t i = 0; i < depth_mm.view().pixel_count(); ++i) {
      if (depth_mm.data()[i]) bits_[i / 8] |= static_cast<std::uint8_t>(1 << i % 8);
    }
    packed_.resize(ZSTD_compressBound(bits_.size()));
    return ZSTD_compress(packed_.data(), packed_.size(), bits_.data(), bits_.size(), kMaskLevel);
  }
  [[nodiscard]] bool valid(std::size_t i) const { return bits_[i / 8] >> i % 8 & 1; }

 private:
  std::vector<std::uint8_t> bits_, packed_;
};

class Av1Depth final : public CodecUnderTest {
 public:
  Av1Depth(int width, int height)
      : image_(aom_img_alloc(nullptr, AOM_IMG_FMT_I42016, static_cast<unsigned>(width),
                             static_cast<unsigned>(height), 32)) {
    image_->monochrome = 1;
    image_->bit_depth = kBits;
  }
  ~Av1Depth() override { aom_img_free(image_); }
  [[nodiscard]] bool open(const BenchPicture& picture, int quality) {
    return open_encoder(picture, quality, encoder_) && open_decoder(decoder_);
  }

  Result<FrameCost> run(const BenchFrame& frame, bool want_key, BenchFrame& decoded) override {
    const CpuStopwatch encoding;
    fill_picture(frame.depth_mm);
    const std::size_t mask_bytes = mask_.pack(frame.depth_mm);
    if (!encode(want_key)) return av1_failure("encode a picture");
    const double encode_ms = encoding.ms();
    decoded.depth_mm.resize(frame.depth_mm.width(), frame.depth_mm.height());
    const CpuStopwatch decoding;
    if (!decode(decoded.depth_mm)) return av1_failure("decode a picture");
    return FrameCost{stream_.size() + mask_bytes, 0, encode_ms, decoding.ms()};
  }

 private:
  /// Repeats the last value where there is no reading, which costs few bits.
  void fill_picture(const DepthImage& depth_mm) {
    if (mm_per_step_ == 0) choose_scale(depth_mm);
    for (int y = 0; y < depth_mm.height(); ++y) {
      auto* row = reinterpret_cast<std::uint16_t*>(image_->planes[0] + y * image_->stride[0]);
      for (int x = 0; x < depth_mm.width(); ++x) {
        const int steps = (depth_mm.at(x, y) + mm_per_step_ / 2) / mm_per_step_;
        if (depth_mm.at(x, y)) row[x] = static_cast<std::uint16_t>(std::min(steps, kMaxValue));
      }
    }
  }
  /// One millimetre per step where the depth fits into 12 bits with a fifth to spare, else the
  /// smallest sufficient multiple.
  void choose_scale(const DepthImage& depth_mm) {
    const int farthest =
        *std::max_element(depth_mm.data(), depth_mm.data() + depth_mm.view().pixel_count());
    mm_per_step_ = 1 + farthest * 6 / 5 / (kMaxValue + 1);
  }

  bool encode(bool want_key) {
    if (aom_codec_encode(&encoder_.context, image_, frame_count_++, 1,
                         want_key ? AOM_EFLAG_FORCE_KF : 0) != AOM_CODEC_OK) {
      return false;
    }
    stream_.clear();
    aom_codec_iter_t position = nullptr;
    while (const aom_codec_cx_pkt_t* packet = aom_codec_get_cx_data(&encoder_.context, &position)) {
      if (packet->kind != AOM_CODEC_CX_FRAME_PKT) continue;
      const auto* bytes = static_cast<const std::uint8_t*>(packet->data.frame.buf);
      stream_.insert(stream_.end(), bytes, bytes + packet->data.frame.sz);
    }
    return true;
  }

  bool decode(DepthImage& depth_mm) {
    if (aom_codec_decode(&decoder_.context, stream_.data(), stream_.size(), nullptr) !=
        AOM_CODEC_OK)
      return false;
    aom_codec_iter_t position = nullptr;
    const aom_image_t* picture = aom_codec_get_frame(&decoder_.context, &position);
    if (picture == nullptr || !(picture->fmt & AOM_IMG_FMT_HIGHBITDEPTH)) return false;
    for (int y = 0; y < depth_mm.height(); ++y) {
      const auto* row =
          reinterpret_cast<const std::uint16_t*>(picture->planes[0] + y * picture->stride[0]);
      for (int x = 0; x < depth_mm.width(); ++x) {
        const auto i = static_cast<std::size_t>(y * depth_mm.width() + x);
        depth_mm.at(x, y) =
            mask_.valid(i) ? static_cast<std::uint16_t>(row[x] * mm_per_step_) : std::uint16_t{0};
      }
    }
    return true;
  }

  aom_image_t* image_;
  AomContext encoder_, decoder_;
  MaskPacker mask_;
  std::vector<std::uint8_t> stream_;
  std::int64_t frame_count_ = 0;
  int mm_per_step_ = 0;
};

}  // namespace

PeerResult make_av1_depth(const BenchPicture& picture, int quality) {
  auto codec = std::make_unique<Av1Depth>(picture.width, picture.height);
  if (!codec->open(picture, quality)) return av1_failure("start");
  return std::unique_ptr<CodecUnderTest>(std::move(codec));
}

}  // namespace roomcast::bench
