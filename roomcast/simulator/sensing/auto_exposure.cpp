// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/auto_exposure.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace roomcast::simulator {

float AutoExposure::next(nanoseconds scene_time) {
  constexpr float kLag_s = 0.4F;
  if (started_) {
    const float passed_s = std::chrono::duration<float>(scene_time - last_).count();
    log_gain_ += (log_aim_ - log_gain_) * (1.0F - std::exp(-std::max(0.0F, passed_s) / kLag_s));
  }
  started_ = true;
  last_ = scene_time;
  return std::exp(log_gain_);
}

bool AutoExposure::is_due(nanoseconds scene_time) const {
  constexpr auto kEvery = std::chrono::milliseconds(200);
  return !has_metered_ || scene_time - metered_ >= kEvery;
}

void AutoExposure::meter(nanoseconds scene_time, float brightness) {
  constexpr float kLargest = 0.7F;  // one f-stop
  has_metered_ = true;
  metered_ = scene_time;
  log_aim_ = std::clamp(std::log(wanted_ / std::max(brightness, 1e-4F)), -kLargest, kLargest);
}

}  // namespace roomcast::simulator
