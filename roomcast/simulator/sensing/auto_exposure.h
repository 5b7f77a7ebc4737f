// SPDX-License-Identifier: Apache-2.0
// AutoExposure: exposure control of a colour camera: approaches the brightness of the empty room
// with a lag. A first-order loop on the logarithm of the gain, as in simple controls; time constant
// and limits are ours. Linear light. Single-threaded: a sensor's frames must be passed in order.
#pragma once

#include "roomcast/core/clock.h"

namespace roomcast::simulator {

class AutoExposure {
 public:
  /// `wanted`: target mean brightness of the picture.
  explicit AutoExposure(float wanted) : wanted_(wanted) {}

  /// The gain of the frame at `scene_time`, from earlier metering.
  float next(nanoseconds scene_time);

  /// True if the light has to be metered at `scene_time`: five times per second is enough for the
  /// lag.
  [[nodiscard]] bool is_due(nanoseconds scene_time) const;
  /// `brightness`: mean linear light of the picture before any gain.
  void meter(nanoseconds scene_time, float brightness);

 private:
  float wanted_;
  float log_gain_ = 0, log_aim_ = 0;
  nanoseconds last_{}, metered_{};
  bool started_ = false, has_metered_ = false;
};

}  // namespace roomcast::simulator
