// SPDX-License-Identifier: Apache-2.0
// Options of the encoder of a sensor's stream.
#pragma once

#include "roomcast/core/result.h"

namespace roomcast::codec {

/// How depth is coded. docs/spec/codec.md.
enum class DepthMode {
  kLive,  // noise is not sent: few bytes, less error than the sensor's own. While the sensor itself
          // moves, every reading is within 5 mm, for many more bytes
  kNearLossless,  // every reading within depth_bound_mm, each frame by itself
  kLossless,      // every reading exact, each frame by itself
};

/// Colour rate of a stream, in kbit/s: enough for two people who exercise in front of the sensor.
inline constexpr int kUsualColorKbit = 790;
/// The same for colour of twice the resolution of depth.
inline constexpr int kUsualFineColorKbit = 1000;

/// Legal range of a colour stream's rate, kbit/s.
inline constexpr int kMinKbit = 50, kMaxKbit = 100000;

struct FrameEncoderOptions {
  int width = 0, height = 0;               // of the depth grid; both 16..4096
  double fps = 30;                         // nominal, for rate control
  int color_kbit_per_s = kUsualColorKbit;  // target of the colour stream
  int color_scale = 1;  // colour pixels for each depth pixel, per direction: 1, or 2 up to a colour
                        // picture of 4096
  int temporal_layers = 2;    // 1..3; frames of layer 1 and up can be dropped without harm
  double key_interval_s = 4;  // maximum time between key frames
  DepthMode depth_mode = DepthMode::kLive;
  int depth_bound_mm = 2;  // near-lossless: largest error of a reading; 1..63
  /// Returns kInvalidArgument and names the invalid field.
  [[nodiscard]] Status check() const;
};

}  // namespace roomcast::codec
