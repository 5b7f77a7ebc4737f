// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/color_drift.h"

#include <chrono>

#include "roomcast/simulator/random/value_noise.h"

namespace roomcast::simulator {

std::array<float, 3> ColorDrift::gains(nanoseconds scene_time) const {
  if (exposure == 0.0F && balance == 0.0F) return {1, 1, 1};
  const float at = std::chrono::duration<float>(scene_time).count() / period_s;
  const auto wander = [&](std::uint32_t trait) {
    return value_noise({at, 0.5F}, hash_of(key, trait));
  };
  const float brightness = 1.0F + exposure * wander(1);
  return {brightness * (1.0F + balance * wander(2)), brightness,
          brightness * (1.0F + balance * wander(3))};
}

}  // namespace roomcast::simulator
