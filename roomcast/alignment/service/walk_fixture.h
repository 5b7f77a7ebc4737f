// SPDX-License-Identifier: Apache-2.0
// For tests: a person's head on a walk of 20 s around the middle of a room, as sensors see it.
#pragma once

#include <cmath>
#include <cstdint>

#include <Eigen/Core>

#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::alignment {

inline Eigen::Vector3d strolling_head(double time_s) {
  const double angle = 0.5 * time_s + 0.8 * std::sin(0.45 * time_s);
  return {1.1 * std::cos(angle), 1.7, 0.8 * std::sin(angle) + 0.2 * std::sin(2.2 * angle)};
}

/// Each sighting is `inside_m` in front of the head's centre.
inline wire::pb::Sightings stroll_seen_from(const RigidTransform& world_from_depth,
                                            double inside_m) {
  wire::pb::Sightings seen;
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d head = world_from_depth.inverse() * strolling_head(0.1 * i);
    const Eigen::Vector3d surface = head - inside_m * head.normalized();
    auto& sighting = *seen.add_heads();
    sighting.set_room_ns(1'000'000'000'000ULL + 100'000'000ULL * static_cast<std::uint64_t>(i));
    sighting.set_x(static_cast<float>(surface.x()));
    sighting.set_y(static_cast<float>(surface.y()));
    sighting.set_z(static_cast<float>(surface.z()));
  }
  return seen;
}

}  // namespace roomcast::alignment
