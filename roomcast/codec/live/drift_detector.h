// SPDX-License-Identifier: Apache-2.0
// Detects surfaces that move slowly: each pixel by less than its noise, but all pixels of a patch
// together. Keeps a running average of each 4x4 patch's offset from the reference. Used by the live
// encoder only.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/codec/live/pixel_history.h"

namespace roomcast::codec {

class DriftDetector {
 public:
  void resize(const BlockGrid& grid);
  /// Adds the newest frame to the averages.
  void update(const FrameChange& change, const PixelHistory& history);
  /// Whether the block, or a patch of it, has drifted away from the reference.
  [[nodiscard]] bool drifts(std::size_t block) const;
  /// Restarts the offsets of a block that was coded.
  void reset(std::size_t block);
  /// The block moved: for a few frames new offsets get more weight.
  void expect_motion(std::size_t block);

 private:
  void add_up_rows(const FrameChange& change, const PixelHistory& history, int y);
  void update_patch(int patch_x, int patch_y);

  BlockGrid grid_;
  std::vector<std::int16_t> column_off_;
  std::vector<std::uint16_t> column_close_, column_deviation_;
  std::vector<std::uint8_t> frames_since_motion_;
  std::vector<float> offset_;  // sigmas of a pixel; four patches for each block
};

}  // namespace roomcast::codec
