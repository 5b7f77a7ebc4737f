// SPDX-License-Identifier: Apache-2.0
// Encodes a frame set as a glTF 2.0 binary file (GLB; Khronos glTF 2.0 specification): per sensor,
// an unlit textured mesh of its surface in a node with the sensor's pose. Metres, y up, as glTF
// requires. Single-threaded; reuses its memory.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/io/jpeg_codec.h"
#include "roomcast/recording/export/depth_points.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"

namespace roomcast::recording {

inline constexpr int kTextureQuality = 90;  // JPEG quality

class GltfScene {
 public:
  explicit GltfScene(const std::vector<SetSensor>& sensors);

  /// Appends the file to `out`. Unplaced sensors are left out, unless there is only one sensor.
  /// `captured`: since 1970-01-01 UTC, kept as "captured" in the scene's `extras`; 0: unknown.
  /// kMalformed if a texture cannot be encoded.
  [[nodiscard]] Status append(const FrameSet& set, nanoseconds captured,
                              std::vector<std::uint8_t>& out);

 private:
  std::vector<SetSensor> sensors_;
  std::vector<DepthPoints> points_;  // by sensor
  io::JpegCodec jpeg_;
};

}  // namespace roomcast::recording
