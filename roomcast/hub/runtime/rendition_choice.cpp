// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/rendition_choice.h"

#include <algorithm>
#include <utility>

namespace roomcast::hub {

bool RenditionChoice::offered(std::size_t sensors, bool has_frames) {
  small_sets_ += has_frames ? 1 : 0;
  if (++offered_sets_ < kWindow) return false;
  offered_sets_ = 0;
  const double dropped = std::exchange(dropped_sets_, 0);
  if (small_sensors_ >= sensors) {
    dropped_small_sets_ += dropped;
    if (small_sets_ >= kSmallWindow && hold_back(sensors)) return true;
  }
  if (dropped > kTooMuch * kWindow) return give_way(sensors, dropped > kFarTooMuch * kWindow);
  if (dropped > 0) {
    calm_windows_ = 0;
    return false;
  }
  return ++calm_windows_ >= patience_ && try_more();
}

/// Of all sensors, or of half of those that come whole, at least one, the small rendition is sent
/// from now on.
bool RenditionChoice::give_way(std::size_t sensors, bool is_far_too_much) {
  take_less();
  if (small_sensors_ >= sensors) return false;
  const std::size_t whole = sensors - small_sensors_;
  small_sensors_ += is_far_too_much ? whole : (whole + 1) / 2;
  small_sets_ = 0;
  dropped_small_sets_ = 0;
  return true;
}

/// One sensor more, or half of those that come; at least one comes.
bool RenditionChoice::hold_back(std::size_t sensors) {
  const double share =
      std::exchange(dropped_small_sets_, 0) / static_cast<double>(std::exchange(small_sets_, 0));
  if (share <= kTooMuch || held_back_ + 1 >= sensors) return false;
  take_less();
  held_back_ += share > kFarTooMuch ? (sensors - held_back_) / 2 : 1;
  return true;
}

/// If the last change was to more, that failed, and the next one waits twice as long.
void RenditionChoice::take_less() {
  calm_windows_ = 0;
  if (std::exchange(has_tried_, false)) patience_ = std::min(2 * patience_, kMaxPatience);
}

bool RenditionChoice::try_more() {
  calm_windows_ = 0;
  if (small_sensors_ == 0) {
    patience_ = kPatience;  // the line has long been good
    return false;
  }
  has_tried_ = true;
  --(held_back_ > 0 ? held_back_ : small_sensors_);
  return true;
}

}  // namespace roomcast::hub
