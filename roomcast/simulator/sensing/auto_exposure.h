// SPDX-License-Identifier: Apache-2.0
// The exposure control of a colour camera: it wants the picture as bright as the empty room looks,
// and gets there with a lag. A first-order loop on the logarithm of the gain, as simple controls
// are; time constant and limits are ours. Linear light. Single-threaded: a sensor's frames go
// through it in order.
#pragma once

#include "roomcast/core/clock.h"

namespace roomcast::simulator {

class AutoExposure {
 public:
  /// `wanted`: the mean brightness of the picture that it steers for.
  explicit AutoExposure(float wanted) : wanted_(wanted) {}

  /// The gain of the frame at `scene_time`: answers to what was metered before.
  float next(nanoseconds scene_time);

  /// Whether the light is to be metered at `scene_time`: five times a second is enough for the lag.
  [[nodiscard]] bool is_due(nanoseconds scene_time) const;
  /// The mean linear light of the picture before any gain.
  void meter(nanoseconds scene_time, float brightness);

 private:
  float wanted_;
  float log_gain_ = 0, log_aim_ = 0;
  nanoseconds last_{}, metered_{};
  bool started_ = false, has_metered_ = false;
};

}  // namespace roomcast::simulator
