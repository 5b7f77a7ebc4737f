// SPDX-License-Identifier: Apache-2.0
// InterferenceFilter: removes from a sensor's depth what foreign infrared light does to still
// surfaces: a missing reading is held, a reading of one or two frames that is off is replaced, and
// noise beyond the sensor's own is reduced to it. What moves is left alone: nothing is held near
// readings that changed together, nor where a large part of a surface is missing, because a thing
// that returns no light may have come before it. Frames of a sensor that nothing disturbs pass
// unchanged. Single-threaded.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/sensor/interference_meter.h"

namespace roomcast::sensor {

class InterferenceFilter {
 public:
  /// `fps`: of the frames, above 0.
  explicit InterferenceFilter(double fps) : meter_(fps) {}

  /// Takes the next frame and replaces its readings where they are disturbed.
  void filter(DepthImage& depth_mm);

  /// Takes the next frame and leaves it as it is.
  void measure(DepthView depth_mm) { meter_.add(depth_mm); }

  /// Of the frames as they came.
  [[nodiscard]] InterferenceFigures figures() const { return meter_.figures(); }
  /// Whether frames are being changed.
  [[nodiscard]] bool is_active() const { return is_active_; }

 private:
  struct Block {
    int moving = 0, missing = 0, still = 0;
    float usual_moving = 0;  // mean over time: outlines flicker all the time
  };
  void decide();
  void count_blocks();
  [[nodiscard]] bool may_hold(int x, int y) const;
  [[nodiscard]] bool changed_together(DepthView depth_mm, int x, int y) const;
  [[nodiscard]] std::uint16_t filtered(DepthView depth_mm, int x, int y) const;

  InterferenceMeter meter_;
  bool is_active_ = false;
  int blocks_wide_ = 0, blocks_high_ = 0;
  std::vector<Block> blocks_;
  DepthImage before_;  // the frame as it came
};

}  // namespace roomcast::sensor
