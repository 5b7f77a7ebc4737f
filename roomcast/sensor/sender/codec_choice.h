// SPDX-License-Identifier: Apache-2.0
// The codec settings of a sensor.
#pragma once

#include "roomcast/codec/frame_codec.h"

namespace roomcast::sensor {

struct CodecChoice {
  codec::DepthMode depth_mode = codec::DepthMode::kLive;
  int depth_bound_mm = 2;
  int layers = 2;
  int color_scale = 1;
  int color_kbit_per_s = 0;  // 0: the default bit rate

  [[nodiscard]] int color_kbit() const {
    if (color_kbit_per_s > 0) return color_kbit_per_s;
    return color_scale == 1 ? codec::kUsualColorKbit : codec::kUsualFineColorKbit;
  }
};

}  // namespace roomcast::sensor
