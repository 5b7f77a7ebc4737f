// SPDX-License-Identifier: Apache-2.0
// RenditionChoice: chooses of how many sensors a viewer gets the small rendition, by what his line
// has taken of the frame sets so far. It gives way at once, and tries again after a while that
// doubles with each failure, so that it does not oscillate. Pure; the time is counted in frame
// sets. docs/spec/wire.md §3 "Renditions".
#pragma once

#include <cstddef>

namespace roomcast::hub {

class RenditionChoice {
 public:
  /// Frame sets between two decisions.
  static constexpr int kWindow = 16;
  /// With so large a share of a window dropped, more sensors come small; all of them.
  static constexpr double kTooMuch = 0.25, kFarTooMuch = 0.6;
  /// Windows without any loss after which one sensor more comes whole: at first, and at most.
  static constexpr int kPatience = 8, kMaxPatience = 128;

  /// So much of what waited for the line was dropped, in frame sets.
  void dropped(double sets) { dropped_sets_ += sets; }
  /// Call for each frame set that is offered. `sensors`: those in the sets. True: small_sensors()
  /// has changed.
  bool offered(std::size_t sensors);

  [[nodiscard]] std::size_t small_sensors() const { return small_sensors_; }

 private:
  bool give_way(std::size_t sensors, bool is_far_too_much);
  bool try_more();

  double dropped_sets_ = 0;  // in this window
  int offered_sets_ = 0;
  int calm_windows_ = 0;
  int patience_ = kPatience;
  bool has_tried_ = false;  // the last change was to more
  std::size_t small_sensors_ = 0;
};

}  // namespace roomcast::hub
