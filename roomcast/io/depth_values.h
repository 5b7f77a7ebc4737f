// SPDX-License-Identifier: Apache-2.0
// Converts the values of a depth picture as camera.json defines them: millimetres = value * scale +
// bias, and a list of values without a reading. Thread-safe after construction.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/io/camera_json.h"

namespace roomcast::io {

class DepthValues {
 public:
  explicit DepthValues(const RecordedCamera& camera);

  /// Converts values to millimetres; 0 for invalid values and for distances outside 1 to 65535 mm.
  void to_mm(DepthImage& depth) const;

 private:
  std::vector<std::uint16_t> mm_from_value_;  // empty if values are millimetres already
};

}  // namespace roomcast::io
