// SPDX-License-Identifier: Apache-2.0
// Decides for each block of a frame what to code: nothing, a correction of noise that has averaged
// out, or labels and the target values of its surfaces. Used by the live encoder only.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "roomcast/codec/live/block_code.h"
#include "roomcast/codec/live/drift_detector.h"
#include "roomcast/codec/live/live_state.h"
#include "roomcast/codec/live/pixel_history.h"

namespace roomcast::codec {

/// Target levels of a block; 0 = unknown.
using BlockTarget = std::array<float, kBlockPixels>;

class BlockPlanner {
 public:
  BlockPlanner(const LiveState& state, PixelHistory& history, const FrameChange& change)
      : state_(state), history_(history), change_(change) {}

  void resize();
  /// Call before the blocks of a frame. In frames that are no reference only motion is coded.
  void begin_frame(bool reference);
  /// Sets code.mode; with kLabels code.labels (surfaces as kFirst) and
  /// `target`; with kRefine code.refinement.
  void plan(const BlockView& here, BlockDrift drift, BlockCode& code, BlockTarget& target);
  /// Call after coding a block of a reference frame; `before` contains its previous levels. Returns
  /// whether a large part of the block moved.
  bool coded(const BlockView& here, const BlockCode& code,
             const std::array<std::uint16_t, kBlockPixels>& before);

 private:
  [[nodiscard]] int min_urgency() const;
  [[nodiscard]] int urgency(const BlockView& here, BlockDrift drift) const;
  [[nodiscard]] bool plan_labels(const BlockView& here, BlockDrift drift, BlockCode& code,
                                 BlockTarget& target);
  [[nodiscard]] PixelLabel label_of(const BlockPixel& pixel, bool biased) const;
  [[nodiscard]] PixelLabel label_of_missing(const BlockPixel& pixel) const;
  /// Returns whether any label changed.
  bool smooth_labels(const BlockView& here, BlockCode& code, const BlockTarget& target) const;
  [[nodiscard]] bool plan_refinement(const BlockView& here, BlockCode& code) const;
  /// The pixel got a new level; `moved`: that of a moving surface.
  void restart_history(std::size_t pixel, bool moved);

  const LiveState& state_;
  PixelHistory& history_;
  const FrameChange& change_;
  std::vector<std::uint8_t> refined_;  // per block: was refined since its surfaces were coded
  unsigned frame_ = 0;
  int refinements_left_ = 0;
  bool reference_ = false;
  std::size_t labelled_blocks_ = 0;  // in this frame
  bool sensor_moves_ = false;        // most blocks of the previous frame had labels
};

}  // namespace roomcast::codec
