// SPDX-License-Identifier: Apache-2.0
// What the values of a depth picture mean, as camera.json tells: millimetres = value * scale +
// bias, and which values mean no reading. Thread-safe once made.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/io/camera_json.h"

namespace roomcast::io {

class DepthValues {
 public:
  explicit DepthValues(const RecordedCamera& camera);

  /// Values to millimetres; 0 for invalid ones, and for what is not within 1 to 65535 mm.
  void to_mm(DepthImage& depth) const;

 private:
  std::vector<std::uint16_t> mm_from_value_;  // empty where values are millimetres already
};

}  // namespace roomcast::io
