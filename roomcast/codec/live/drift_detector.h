// SPDX-License-Identifier: Apache-2.0
// Detects surfaces that move slowly: each pixel by less than its noise, but all pixels of a patch
// together. Keeps a running average of each 4x4 patch's offset from the reference.
//
// Neighbouring pixels of a structured-light sensor share their noise, so that patches jump
// together although nothing moves. What counts as drift is therefore learnt for each patch and
// each block while it is not coded, from second differences of the offset over three frames: noise
// changes it back and forth, drift steadily. Used by the live encoder only.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/codec/live/pixel_history.h"

namespace roomcast::codec {

struct BlockDrift {
  bool drifts = false;        // the block, or a patch of it, has drifted away from the reference
  bool shares_noise = false;  // so much that an offset of a few neighbours says nothing
};

class DriftDetector {
 public:
  void resize(const BlockGrid& grid);
  /// Adds the newest frame to the averages.
  void update(const FrameChange& change, const PixelHistory& history);
  [[nodiscard]] BlockDrift of(std::size_t block) const;
  /// Restarts the offsets of a block that was coded.
  void reset(std::size_t block);
  /// The block moved: for a few frames new offsets get more weight.
  void expect_motion(std::size_t block);

 private:
  void add_up_rows(const FrameChange& change, const PixelHistory& history, int y);
  void update_patch(int patch_x, int patch_y);
  void learn_noise(std::size_t block);

  BlockGrid grid_;
  std::vector<std::int16_t> column_off_;
  std::vector<std::uint16_t> column_close_, column_deviation_;
  std::vector<std::uint8_t> frames_since_motion_;
  // In sigmas of a pixel; four patches for each block.
  std::vector<float> offset_;  // running average
  std::vector<float> newest_;  // offset in the newest frame; NaN: unknown, or coded since
  std::vector<float> before_, long_before_;  // the same, one and two frames earlier
  // Means of the changes of the offset from frame to frame, of patches and of blocks.
  std::vector<float> patch_change_, block_change_;
  float newest_weight_ = 1;  // of the newest change
  int frames_ = 0;
};

}  // namespace roomcast::codec
