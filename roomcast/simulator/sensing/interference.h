// SPDX-License-Identifier: Apache-2.0
// Interference: bursts in which another sensor's infrared light disturbs this sensor's depth.
// Kinect v2 units disturb each other irregularly and mostly not at all (Brogli, "Multiple Kinect v2
// interference", ETH Zurich 2016), so this is off by default. The model is ours: in every second of
// scene time a burst starts with probability rate / 60 and lasts 0.2 to 0.7 s; it raises the noise
// up to threefold and adds a ripple of up to 8 mm to the picture. Immutable; a function of time
// alone.
#pragma once

#include <cstdint>
#include <optional>

#include "roomcast/core/clock.h"

namespace roomcast::simulator {

struct InterferenceBurst {
  nanoseconds begin{}, end{};
  float strength = 0;  // above 0, up to 1
  std::uint32_t key = 0;

  [[nodiscard]] float sigma_factor() const { return 1.0F + 2.0F * strength; }
  /// The ripple at a pixel, in millimetres.
  [[nodiscard]] float ripple_mm(int x, int y) const;
};

class Interference {
 public:
  Interference(double bursts_per_minute, std::uint32_t unit_key)
      : per_second_(bursts_per_minute / 60.0), key_(unit_key) {}

  /// The burst that is active at an instant.
  [[nodiscard]] std::optional<InterferenceBurst> at(nanoseconds scene_time) const;

 private:
  [[nodiscard]] std::optional<InterferenceBurst> starting_in(std::int64_t second) const;

  double per_second_;
  std::uint32_t key_;
};

}  // namespace roomcast::simulator
