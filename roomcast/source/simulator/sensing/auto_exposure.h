// SPDX-License-Identifier: Apache-2.0
// The exposure control of a colour camera: it wants the picture as bright as the empty room looks,
// and gets there with a lag. A first-order loop on the logarithm of the gain, as simple controls
// are; time constant and limits are ours. Linear light. Single-threaded: a sensor's frames go
// through it in order.
#pragma once

#include "roomcast/core/clock.h"

namespace roomcast::sim {

class AutoExposure {
 public:
  /// `wanted`: the mean brightness of the picture that it steers for.
  explicit AutoExposure(float wanted) : wanted_(wanted) {}

  /// The gain of the frame at `scene_time` whose light, before any gain, has the mean `brightness`.
  /// It answers to the frames before this one only.
  float next(nanoseconds scene_time, float brightness);

 private:
  float wanted_;
  float log_gain_ = 0, log_aim_ = 0;
  nanoseconds last_{};
  bool started_ = false;
};

}  // namespace roomcast::sim
