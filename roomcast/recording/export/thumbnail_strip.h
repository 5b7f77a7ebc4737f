// SPDX-License-Identifier: Apache-2.0
// ThumbnailStrip: an overview picture of a recording: a row per sensor, a few instants from
// beginning to end. A sensor without colour shows its depth, near objects bright. Single-threaded;
// memory for twice as many instants as are shown.
#pragma once

#include <cstddef>
#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"

namespace roomcast::recording {

class ThumbnailStrip {
 public:
  static constexpr std::size_t kInstants = 8;
  static constexpr int kWidth = 160;  // pixels; height: aspect ratio of the first sensor
  static constexpr int kGap = 4;

  explicit ThumbnailStrip(const std::vector<SetSensor>& sensors);

  /// Adds a set; all sets of a recording, or some of them, in order.
  void add(const FrameSet& set);

  /// At most kInstants columns, evenly spaced over the added sets; empty if there were none.
  [[nodiscard]] ColorImage picture() const;

 private:
  using Column = std::vector<ColorImage>;  // by sensor; empty picture: no frame

  int height_ = 0;
  std::size_t sensor_count_;
  std::vector<Column> columns_;
  std::size_t every_ = 1, count_ = 0;
};

}  // namespace roomcast::recording
