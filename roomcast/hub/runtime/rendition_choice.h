// SPDX-License-Identifier: Apache-2.0
// RenditionChoice: chooses of how many sensors a viewer gets the small rendition, by what his line
// has taken of the frame sets so far; and, where it does not take even all small renditions, how
// many sensors are held back, so that the others come in time. It gives way at once, and tries
// again after a while that doubles with each failure, so that it does not oscillate. Pure; the time
// is counted in frame sets. docs/spec/wire.md §3 "Renditions".
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
  /// So many sets that had something for the viewer, all of it small, are waited for before sensors
  /// are held back: the queue empties meanwhile.
  static constexpr int kSmallWindow = 16;

  /// So much of what waited for the line was dropped, in frame sets.
  void dropped(double sets) { dropped_sets_ += sets; }
  /// Call for each frame set that is offered. `sensors`: those in the sets. `has_frames`: the
  /// viewer would get some of this one. True: the choice has changed.
  bool offered(std::size_t sensors, bool has_frames = true);

  [[nodiscard]] std::size_t small_sensors() const { return small_sensors_; }
  /// Of the small ones; never all sensors.
  [[nodiscard]] std::size_t held_back() const { return held_back_; }

 private:
  bool give_way(std::size_t sensors, bool is_far_too_much);
  bool hold_back(std::size_t sensors);
  void take_less();
  bool try_more();

  double dropped_sets_ = 0;  // in this window
  int offered_sets_ = 0;
  int calm_windows_ = 0;
  int patience_ = kPatience;
  bool has_tried_ = false;  // the last change was to more
  std::size_t small_sensors_ = 0;
  /// Since all sensors came small, or one more was held back: sets with frames for the viewer.
  int small_sets_ = 0;
  double dropped_small_sets_ = 0;
  std::size_t held_back_ = 0;
};

}  // namespace roomcast::hub
