// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "roomcast/codec/color/color_validity.h"
#include "roomcast/codec/color/vp9_color_encoder.h"
#include "roomcast/codec/frame_codec.h"
#include "roomcast/codec/live/live_depth_encoder.h"
#include "roomcast/codec/lossless/lossless_depth_encoder.h"
#include "roomcast/codec/lossless/residual.h"
#include "roomcast/codec/mask/color_mask.h"
#include "roomcast/codec/mask/steady_mask.h"
#include "roomcast/codec/payload/layer_schedule.h"
#include "roomcast/codec/payload/payload_sections.h"
#include "roomcast/codec/sensor_motion.h"

namespace roomcast::codec {
namespace {

constexpr int kMovingSensorBound_mm =
    5;  // near-lossless bound of live depth while the sensor moves

/// Step of the background in key frames, relative to that of moving surfaces: LiveDepthOptions.
constexpr double kKeyStepShare = 0.6;

/// Frames from one key frame to the next.
int key_interval(double seconds, double fps) {
  return std::max(1, static_cast<int>(std::lround(seconds * fps)));
}

class SectionFrameEncoder final : public FrameEncoder {
 public:
  explicit SectionFrameEncoder(const FrameEncoderOptions& options)
      : options_(options),
        mode_(options.depth_mode),
        schedule_(options.temporal_layers, key_interval(options.key_interval_s, options.fps)) {
    if (options.depth_mode == DepthMode::kLive) {
      live_ = std::make_unique<LiveDepthEncoder>(LiveDepthOptions{options.width, options.height});
    }
  }

  Result<EncodedFrameInfo> encode(DepthView depth_mm, ColorView color, MaskView color_seen,
                                  bool want_key, std::vector<std::uint8_t>& out) override {
    if (Status status = check_sizes(depth_mm, color, color_seen); !status.ok())
      return status.error();
    const bool has_color = color.data != nullptr;
    const bool anew = options_.depth_mode == DepthMode::kLive && follow_sensor(depth_mm);
    const FrameRole role = schedule_.next(want_key || anew || (has_color && !color_started_));
    if (role.key) color_started_ = has_color;
    const std::size_t begin = out.size();
    choose_quality(role, color.pixel_count());
    append_depth(depth_mm, role, out);
    const std::size_t depth_bytes = out.size() - begin;
    if (!has_color) {
      quality_.coded(depth_bytes, 0);
      return without_color(role);
    }
    const Status status = append_color(depth_mm, color, color_seen, role, out);
    if (status.ok()) {
      quality_.coded(depth_bytes, out.size() - begin - depth_bytes);
      return EncodedFrameInfo{role.key, role.layer, chosen_quantizer()};
    }
    out.resize(begin);
    color_started_ = false;
    return status.error();
  }

  void set_color_rate(int kbit_per_s) override {
    options_.color_kbit_per_s = std::clamp(kbit_per_s, kMinKbit, kMaxKbit);
    // If libvpx refuses, the stream continues at its current rate.
    if (color_) (void)color_->set_rate(options_.color_kbit_per_s);
  }

  void set_target(const FrameTarget& target) override {
    quality_.set_target(target);
    const LiveDepthOptions usual;
    if (live_ && !quality_.has_target()) live_->set_steps(usual.step, usual.key_step);
  }

  void set_base_only(bool base_only) override {
    schedule_.set_layers(base_only ? 1 : options_.temporal_layers);
  }

  void set_key_interval(double seconds) override {
    schedule_.set_key_interval(key_interval(seconds, options_.fps));
  }

  [[nodiscard]] Status set_needs(BlockNeedsView needs) override {
    const int wide = need_blocks(options_.width), high = need_blocks(options_.height);
    if (needs.data == nullptr) {
      needs_.resize(0, 0);
      return {};
    }
    if (needs.width != wide || needs.height != high)
      return invalid_argument("The needs must be those of each block of the depth picture.");
    if (needs_.empty()) needs_.resize(wide, high);
    for (int y = 0; y < high; ++y) std::copy_n(needs.row(y), wide, needs_.view().row(y));
    return {};
  }

  [[nodiscard]] DepthView decoded_depth() const override {
    switch (mode_) {
      case DepthMode::kLive:
        return live_->shown_mm();
      case DepthMode::kNearLossless:
        return intra_.decoded_mm();
      case DepthMode::kLossless:
        break;
    }
    return input_depth_;
  }

 private:
  [[nodiscard]] Status check_sizes(DepthView depth, ColorView color, MaskView seen) const {
    if (depth.data == nullptr || depth.width != options_.width || depth.height != options_.height) {
      return invalid_argument(
          "The depth picture is not of the size that the encoder was made for.");
    }
    if ((color.data == nullptr) != (seen.data == nullptr)) {
      return invalid_argument("A frame needs both colour and its mask, or neither.");
    }
    if (color.data == nullptr) return {};
    const int scale = options_.color_scale;
    if (color.width != scale * depth.width || color.height != scale * depth.height) {
      return invalid_argument(
          "The colour picture is not of the size that the encoder was made for.");
    }
    if (!same_size(seen, depth)) {
      return invalid_argument("The colour's mask must have the size of the depth picture.");
    }
    return {};
  }

  /// Live depth is inefficient while the sensor moves: until it is at rest again, readings are
  /// coded near-losslessly. Returns true when live depth restarts.
  bool follow_sensor(DepthView depth_mm) {
    const bool stood = mode_ == DepthMode::kLive;
    mode_ = motion_.update(depth_mm) ? DepthMode::kNearLossless : DepthMode::kLive;
    if (stood || mode_ != DepthMode::kLive) return false;
    live_ = std::make_unique<LiveDepthEncoder>(LiveDepthOptions{options_.width, options_.height});
    steady_ = {};
    return true;
  }

  void choose_quality(FrameRole role, std::size_t color_pixels) {
    quality_.choose(role, color_pixels);
    if (live_ && quality_.has_target()) {
      const double step = quality_.depth_step() * kLevelsPerSigma;
      live_->set_steps(static_cast<int>(std::lround(step)),
                       static_cast<int>(std::lround(kKeyStepShare * step)));
    }
  }
  [[nodiscard]] int chosen_quantizer() const {
    return quality_.has_target() ? quality_.quantizer() : 0;
  }

  void append_depth(DepthView depth_mm, FrameRole role, std::vector<std::uint8_t>& out) {
    input_depth_ = depth_mm;
    const std::size_t section = begin_section(SectionKind::kDepth, depth_codec(), out);
    switch (mode_) {
      case DepthMode::kLive:
        live_->encode(depth_mm, role, out, needs());
        break;
      case DepthMode::kNearLossless:
        intra_.encode_near_lossless(depth_mm, bound_mm(), out);
        break;
      case DepthMode::kLossless:
        intra_.encode(depth_mm, out);
        break;
    }
    end_section(section, out);
  }
  [[nodiscard]] BlockNeedsView needs() const {
    if (needs_.empty() || mode_ != DepthMode::kLive) return {};
    return needs_;
  }
  [[nodiscard]] int bound_mm() const {
    return options_.depth_mode == DepthMode::kLive ? kMovingSensorBound_mm
                                                   : options_.depth_bound_mm;
  }
  [[nodiscard]] std::uint8_t depth_codec() const {
    switch (mode_) {
      case DepthMode::kLive:
        return kLiveDepth;
      case DepthMode::kNearLossless:
        return kNearLosslessDepth;
      case DepthMode::kLossless:
        break;
    }
    return kLosslessDepth;
  }

  /// Intra depth can be decoded alone and changes no state. The frame is a key frame only if the
  /// stream has had no colour since the last key frame: later colour may still depend on earlier
  /// frames.
  [[nodiscard]] EncodedFrameInfo without_color(FrameRole role) const {
    if (live_) return {role.key, role.layer, chosen_quantizer()};
    if (!color_started_) return {true, 0};
    return {false, 1};
  }

  [[nodiscard]] Status append_color(DepthView depth_mm, ColorView color, MaskView seen,
                                    FrameRole role, std::vector<std::uint8_t>& out) {
    if (color_ == nullptr) {
      auto created = Vp9ColorEncoder::create(options_);
      if (!created.ok()) return created.error();
      color_ = std::move(*created);
    }
    color_->fix_quantizer(quality_.has_target() ? std::optional(quality_.quantizer())
                                                : std::nullopt);
    std::size_t section = begin_section(SectionKind::kColor, kVp9Color, out);
    const DepthView shown_mm = mode_ == DepthMode::kLive ? live_->shown_mm() : depth_mm;
    color_validity_.update(depth_mm, shown_mm, seen);
    Status status = color_->encode(color, color_validity_.colored(), role, out, needs());
    if (!status.ok()) return status;
    end_section(section, out);
    section = begin_section(SectionKind::kColorMask, role.key ? kIntraMask : kMaskChange, out);
    append_mask(color_validity_.seen(), role, out);
    end_section(section, out);
    return {};
  }

  // A frame of layer 1 or up would spend bits on a change that the next reference must code again;
  // a delay of one frame is not visible.
  void append_mask(MaskView seen, FrameRole role, std::vector<std::uint8_t>& out) {
    const bool live = mode_ == DepthMode::kLive;
    if (live) seen = steady_.update(seen, color_validity_.depth_mm());
    if (live && role.layer > 0) {
      ColorMaskEncoder::repeat(out);
    } else {
      mask_.encode(seen, decoded_depth(), role, out);
    }
  }

  FrameEncoderOptions options_;
  DepthMode mode_;       // of the newest frame
  SensorMotion motion_;  // in live mode
  LayerSchedule schedule_;
  FrameQuality quality_;
  LosslessDepthEncoder intra_;
  std::unique_ptr<LiveDepthEncoder> live_;  // in live mode
  std::unique_ptr<Vp9ColorEncoder> color_;  // created with the first colour picture
  ColorValidity color_validity_;
  SteadyMask steady_;  // in live mode
  ColorMaskEncoder mask_;
  BlockNeeds needs_;            // empty: all of everything
  DepthView input_depth_;       // of the newest frame; not owned
  bool color_started_ = false;  // since the last key frame
};

}  // namespace

Result<std::unique_ptr<FrameEncoder>> FrameEncoder::create(const FrameEncoderOptions& options) {
  if (Status status = options.check(); !status.ok()) return status.error();
  return std::unique_ptr<FrameEncoder>(std::make_unique<SectionFrameEncoder>(options));
}

}  // namespace roomcast::codec
