// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "roomcast/codec/frame_codec.h"
#include "roomcast/codec/lossless/lossless_depth_encoder.h"
#include "roomcast/codec/mask_codec.h"
#include "roomcast/codec/payload_sections.h"
#include "roomcast/codec/vp9_color_encoder.h"

namespace roomcast::codec {
namespace {

constexpr double kMostFps = 240;
constexpr int kLeastKbit = 50, kMostKbit = 100000;

Status invalid(const char* message) {
  return Error{ErrorCode::kInvalidArgument, message};
}

bool is_side(int side) {
  return side >= kLeastGridSide && side <= kMostGridSide;
}

class SectionFrameEncoder final : public FrameEncoder {
 public:
  explicit SectionFrameEncoder(const FrameEncoderOptions& options) : options_(options) {}

  Result<EncodedFrameInfo> encode(DepthView depth_mm, ColorView color, MaskView color_seen,
                                  bool want_key, std::vector<std::uint8_t>& out) override {
    if (Status status = check_sizes(depth_mm, color, color_seen); !status.ok())
      return status.error();
    const std::size_t begin = out.size();
    const std::size_t section = begin_section(SectionKind::kDepth, kLosslessDepth, out);
    depth_.encode(depth_mm, out);
    end_section(section, out);
    if (color.data == nullptr) return without_color(want_key);
    auto info = append_color(depth_mm, color, color_seen, want_key, out);
    if (!info.ok()) out.resize(begin);
    return info;
  }

 private:
  [[nodiscard]] Status check_sizes(DepthView depth, ColorView color, MaskView seen) const {
    if (depth.data == nullptr || depth.width != options_.width || depth.height != options_.height) {
      return invalid("The depth picture is not of the size that the encoder was made for.");
    }
    if ((color.data == nullptr) != (seen.data == nullptr)) {
      return invalid("A frame needs both colour and its mask, or neither.");
    }
    if (color.data != nullptr && (!same_size(color, depth) || !same_size(seen, depth))) {
      return invalid("Colour and its mask must have the size of the depth picture.");
    }
    return {};
  }

  /// Depth alone can be decoded alone, but only ends the need for earlier frames if colour starts
  /// anew after it.
  EncodedFrameInfo without_color(bool want_key) {
    if (want_key) next_color_is_key_ = true;
    if (next_color_is_key_) return {true, 0};
    return {false, 1};
  }

  Result<EncodedFrameInfo> append_color(DepthView depth_mm, ColorView color, MaskView seen,
                                        bool want_key, std::vector<std::uint8_t>& out) {
    if (color_ == nullptr) {
      auto created = Vp9ColorEncoder::create(options_);
      if (!created.ok()) return created.error();
      color_ = std::move(*created);
    }
    std::size_t section = begin_section(SectionKind::kColor, kVp9Color, out);
    auto info = color_->encode(color, seen, want_key || next_color_is_key_, out);
    if (!info.ok()) return info;
    end_section(section, out);
    next_color_is_key_ = false;
    section = begin_section(SectionKind::kColorMask, kAdaptiveMask, out);
    encode_mask(seen, depth_mm, out);
    end_section(section, out);
    return info;
  }

  const FrameEncoderOptions options_;
  LosslessDepthEncoder depth_;
  std::unique_ptr<Vp9ColorEncoder> color_;  // made when the first colour comes
  bool next_color_is_key_ = true;
};

}  // namespace

Status FrameEncoderOptions::check() const {
  if (!is_side(width)) return invalid("FrameEncoderOptions.width must be 16..4096.");
  if (!is_side(height)) return invalid("FrameEncoderOptions.height must be 16..4096.");
  if (!std::isfinite(fps) || fps <= 0 || fps > kMostFps) {
    return invalid("FrameEncoderOptions.fps must be above 0 and at most 240.");
  }
  if (color_kbit_per_s < kLeastKbit || color_kbit_per_s > kMostKbit) {
    return invalid("FrameEncoderOptions.color_kbit_per_s must be 50..100000.");
  }
  if (temporal_layers != 1 && temporal_layers != 2) {
    return invalid("FrameEncoderOptions.temporal_layers must be 1 or 2.");
  }
  if (depth_mode != DepthMode::kLossless) {
    return Error{ErrorCode::kUnsupported, "This version codes depth without loss only."};
  }
  return {};
}

Result<std::unique_ptr<FrameEncoder>> FrameEncoder::create(const FrameEncoderOptions& options) {
  if (Status status = options.check(); !status.ok()) return status.error();
  return std::unique_ptr<FrameEncoder>(std::make_unique<SectionFrameEncoder>(options));
}

}  // namespace roomcast::codec
