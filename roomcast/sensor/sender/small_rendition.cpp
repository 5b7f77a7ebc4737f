// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/sender/small_rendition.h"

#include <utility>

namespace roomcast::sensor {
namespace {

/// RateControl asks for key frames earlier.
constexpr double kKeyInterval_s = 3600;

std::uint8_t mean(int a, int b, int c, int d) {
  return static_cast<std::uint8_t>((a + b + c + d + 2) / 4);
}

/// Each pixel is the mean of 2x2.
void halve(ColorView color, ColorImage& out) {
  out.resize(color.width / 2, color.height / 2);
  for (int y = 0; y < out.height(); ++y) {
    const Rgb8* const above = color.row(2 * y);
    const Rgb8* const below = color.row(2 * y + 1);
    for (int x = 0; x < out.width(); ++x) {
      const Rgb8 &a = above[2 * x], &b = above[2 * x + 1], &c = below[2 * x], &d = below[2 * x + 1];
      out.at(x, y) = {mean(a.r, b.r, c.r, d.r), mean(a.g, b.g, c.g, d.g), mean(a.b, b.b, c.b, d.b)};
    }
  }
}

}  // namespace

Result<std::unique_ptr<SmallRendition>> SmallRendition::create(codec::FrameEncoderOptions full,
                                                               double bytes_per_s) {
  const int color_scale = std::exchange(full.color_scale, 1);
  full.key_interval_s = kKeyInterval_s;
  auto encoder = codec::FrameEncoder::create(full);
  if (!encoder) return encoder.error();
  return std::unique_ptr<SmallRendition>(
      new SmallRendition(std::move(*encoder),
                         RateControl({.bytes_per_s = bytes_per_s, .fps = full.fps}), color_scale));
}

Result<std::optional<codec::EncodedFrameInfo>> SmallRendition::encode(
    DepthView depth_mm, ColorView color, MaskView color_seen, HostTime capture_time, bool want_key,
    std::vector<std::uint8_t>& out) {
  wants_key_ = wants_key_ || want_key;
  const auto plan = rate_.next_frame(capture_time, 0);
  if (!plan) return std::optional<codec::EncodedFrameInfo>();
  encoder_->set_target(plan->target);
  if (color_scale_ == 2 && color.pixel_count() > 0) {
    halve(color, color_);
    color = color_;
  }
  const std::size_t before = out.size();
  const auto info =
      encoder_->encode(depth_mm, color, color_seen, wants_key_ || plan->wants_key, out);
  if (!info) return info.error();
  wants_key_ = false;
  rate_.sent(out.size() - before, *info);
  bytes_ += out.size() - before;
  return std::optional(*info);
}

}  // namespace roomcast::sensor
