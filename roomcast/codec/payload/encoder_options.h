// SPDX-License-Identifier: Apache-2.0
// How a sensor's stream is coded.
#pragma once

#include "roomcast/core/result.h"

namespace roomcast::codec {

/// How depth is coded. docs/spec/codec.md.
enum class DepthMode {
  kLive,  // noise is not sent: few bytes, less error than the sensor's own; within 5 mm of each
          // reading, for many more bytes, as long as the sensor itself is carried about
  kNearLossless,  // every reading within depth_bound_mm, each frame by itself
  kLossless,      // every reading as it was, each frame by itself
};

/// Of a stream: what two people who exercise before the sensor need to look well.
inline constexpr int kUsualColorKbit = 790;
/// The same for colour twice as fine.
inline constexpr int kUsualFineColorKbit = 1000;

/// What a colour stream may be asked for, kbit/s.
inline constexpr int kMinKbit = 50, kMaxKbit = 100000;

struct FrameEncoderOptions {
  int width = 0, height = 0;               // of the depth grid; both 16..4096
  double fps = 30;                         // nominal, for rate control
  int color_kbit_per_s = kUsualColorKbit;  // target of the colour stream
  int color_scale = 1;      // colour pixels for each pixel of depth and direction: 1, or 2 up to a
                            // colour picture of 4096
  int temporal_layers = 2;  // 1..3; frames of layer 1 and up can be dropped without harm
  double key_interval_s = 4;  // from one key frame to the next, at most
  DepthMode depth_mode = DepthMode::kLive;
  int depth_bound_mm = 2;  // near-lossless: no reading is off by more; 1..63
  /// kInvalidArgument with the field that is wrong.
  [[nodiscard]] Status check() const;
};

}  // namespace roomcast::codec
