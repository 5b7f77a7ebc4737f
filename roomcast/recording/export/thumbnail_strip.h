// SPDX-License-Identifier: Apache-2.0
// A recording at a glance: a row for each sensor, a few instants from its beginning to its end. A
// sensor without colour shows its depth, near things bright. Single-threaded; memory for twice as
// many instants as are shown.
#pragma once

#include <cstddef>
#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"

namespace roomcast::recording {

class ThumbnailStrip {
 public:
  static constexpr std::size_t kInstants = 8;
  static constexpr int kWidth = 160;  // of a thumbnail; as high as the first sensor's is wide
  static constexpr int kGap = 4;

  explicit ThumbnailStrip(const std::vector<SetSensor>& sensors);

  /// The sets of a recording, all of them or some, in order.
  void add(const FrameSet& set);

  /// At most kInstants columns, evenly spread over what was added; empty when nothing was.
  [[nodiscard]] ColorImage picture() const;

 private:
  using Column = std::vector<ColorImage>;  // by sensor; empty: it had no frame

  int height_ = 0;
  std::size_t sensor_count_;
  std::vector<Column> columns_;
  std::size_t every_ = 1, count_ = 0;
};

}  // namespace roomcast::recording
