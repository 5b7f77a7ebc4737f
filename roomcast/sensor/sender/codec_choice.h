// SPDX-License-Identifier: Apache-2.0
// The codec settings of a sensor.
#pragma once

#include <algorithm>

#include "roomcast/codec/frame_codec.h"
#include "roomcast/core/result.h"

namespace roomcast::sensor {

/// Legal range of a stream's target rate, Mbit/s.
inline constexpr double kMinTargetMbit = 0.1, kMaxTargetMbit = 100;

struct CodecChoice {
  codec::DepthMode depth_mode = codec::DepthMode::kLive;
  int depth_bound_mm = 2;
  int layers = 2;
  int color_scale = 1;
  int color_kbit_per_s = 0;      // 0: the default bit rate
  double target_mbit_per_s = 0;  // of the whole stream on its line, with headers of TCP and IP; 0:
                                 // none, the quality is fixed. Live mode only
  /// Of the small rendition, which is sent while some viewer's line takes no more; 0: there is
  /// none. Live mode only. With a target rate it is at most a quarter of that.
  double small_mbit_per_s = 0.3;
  bool fits_line = false;  // the target is what the line carries, estimated all the time. Live
                           // mode only

  /// kInvalidArgument: the target is out of its range, or not for this mode.
  [[nodiscard]] Status check() const {
    const bool has_small = small_mbit_per_s != 0;
    if (has_small && !(small_mbit_per_s >= kMinTargetMbit && small_mbit_per_s <= kMaxTargetMbit))
      return invalid_argument("the small rendition's rate is 0, or from 0.1 to 100 Mbit/s");
    if (fits_line && target_mbit_per_s != 0)
      return invalid_argument("a target rate is a number or what the line carries, not both");
    if (target_mbit_per_s == 0 && !fits_line) return {};
    if (depth_mode != codec::DepthMode::kLive) {
      return invalid_argument("a target rate needs live depth: exact depth takes what it takes");
    }
    if (fits_line) return {};
    if (target_mbit_per_s >= kMinTargetMbit && target_mbit_per_s <= kMaxTargetMbit) return {};
    return invalid_argument("a target rate is from 0.1 to 100 Mbit/s");
  }

  [[nodiscard]] bool has_target() const { return fits_line || target_mbit_per_s > 0; }
  /// 0: none.
  [[nodiscard]] double small_mbit() const {
    if (depth_mode != codec::DepthMode::kLive || small_mbit_per_s <= 0) return 0;
    if (target_mbit_per_s <= 0) return small_mbit_per_s;
    return std::min(small_mbit_per_s, std::max(kMinTargetMbit, target_mbit_per_s / 4));
  }
  [[nodiscard]] int color_kbit() const {
    if (color_kbit_per_s > 0) return color_kbit_per_s;
    return color_scale == 1 ? codec::kUsualColorKbit : codec::kUsualFineColorKbit;
  }
};

}  // namespace roomcast::sensor
