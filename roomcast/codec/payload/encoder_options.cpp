// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/payload/encoder_options.h"

#include <cmath>

#include "roomcast/codec/lossless/residual.h"
#include "roomcast/codec/payload/payload_sections.h"

namespace roomcast::codec {
namespace {

constexpr double kMaxFps = 240;
constexpr int kMaxLayers = 3;
constexpr double kMaxKeyInterval_s = 3600;

}  // namespace

Status FrameEncoderOptions::check() const {
  if (!is_grid_side(width)) return invalid_argument("The encoder's width must be 16..4096.");
  if (!is_grid_side(height)) return invalid_argument("The encoder's height must be 16..4096.");
  if (!std::isfinite(fps) || fps <= 0 || fps > kMaxFps) {
    return invalid_argument("The encoder's fps must be above 0 and at most 240.");
  }
  if (color_kbit_per_s < kMinKbit || color_kbit_per_s > kMaxKbit) {
    return invalid_argument("The encoder's color_kbit_per_s must be 50..100000.");
  }
  if (color_scale < 1 || color_scale > kMaxColorScale) {
    return invalid_argument("The encoder's color_scale must be 1 or 2.");
  }
  if (color_scale > 1 && !is_color_size(color_scale * width, color_scale * height)) {
    return invalid_argument("A depth grid this large leaves no room for finer colour.");
  }
  if (temporal_layers < 1 || temporal_layers > kMaxLayers) {
    return invalid_argument("The encoder's temporal_layers must be 1, 2 or 3.");
  }
  if (!(key_interval_s > 0 && key_interval_s <= kMaxKeyInterval_s)) {
    return invalid_argument("The encoder's key_interval_s must be above 0 and at most 3600.");
  }
  if (depth_bound_mm < 1 || depth_bound_mm > kMaxBound_mm) {
    return invalid_argument("The encoder's depth_bound_mm must be 1..63.");
  }
  return {};
}

}  // namespace roomcast::codec
