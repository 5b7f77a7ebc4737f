// SPDX-License-Identifier: Apache-2.0
// A frame set as a glTF 2.0 binary file (GLB; Khronos glTF 2.0 specification): for each sensor a
// textured mesh of its surface, unlit, with a node that puts it where the sensor stood. Metres,
// y up, as glTF asks for. Single-threaded; keeps its memory from set to set.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/io/jpeg_codec.h"
#include "roomcast/recording/export/depth_points.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"

namespace roomcast::recording {

inline constexpr int kTextureQuality = 90;  // of JPEG

class GltfScene {
 public:
  explicit GltfScene(const std::vector<SetSensor>& sensors);

  /// Appends the file to `out`. Sensors that nobody has placed are left out, unless there is but
  /// one. kMalformed when a texture cannot be made.
  [[nodiscard]] Status append(const FrameSet& set, std::vector<std::uint8_t>& out);

 private:
  std::vector<SetSensor> sensors_;
  std::vector<DepthPoints> points_;  // by sensor
  io::JpegCodec jpeg_;
};

}  // namespace roomcast::recording
