// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sound/listener_gains.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace roomcast::sound {

Gains listener_gains(const RigidTransform& world_from_listener,
                     const std::optional<Eigen::Vector3d>& head_m) {
  constexpr double kNearest_m = 1, kRolloff = 0.8;  // as in web/src/voice/speakers.ts
  double loudness = 1, toward_right = 0;
  if (head_m) {
    const Eigen::Vector3d seen = world_from_listener.inverse() * *head_m;
    const double distance_m = seen.norm();
    loudness = kNearest_m / (kNearest_m + kRolloff * std::max(0.0, distance_m - kNearest_m));
    // What is at one's own head comes from everywhere.
    toward_right = seen.x() / std::max(distance_m, kNearest_m / 4);
  }
  const double angle = (1 + toward_right) * std::numbers::pi / 4;
  return {static_cast<float>(loudness * std::cos(angle)),
          static_cast<float>(loudness * std::sin(angle))};
}

}  // namespace roomcast::sound
