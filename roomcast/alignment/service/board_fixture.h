// SPDX-License-Identifier: Apache-2.0
// For tests: a printed tag that is held at several places around the middle of a room, as sensors
// see it.
#pragma once

#include <Eigen/Geometry>

#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::alignment {

/// A tag held for a second at each of six places.
inline wire::pb::Sightings held_tag(const RigidTransform& world_from_sensor) {
  wire::pb::Sightings seen;
  for (unsigned i = 0; i < 60; ++i) {
    const unsigned place = i / 10;
    RigidTransform world_from_board;
    world_from_board.rotation =
        Eigen::AngleAxisd(0.4 * place, Eigen::Vector3d::UnitY()).toRotationMatrix();
    world_from_board.translation_m = {0.5 * (place % 3) - 0.5, 1 + 0.3 * (place % 2),
                                      0.4 * (place / 3)};
    auto& tag = *seen.add_tags();
    tag.set_room_ns(1'000'000'000'000ULL + 100'000'000ULL * i);
    for (int corner = 0; corner < 4; ++corner) {
      const Eigen::Vector3d printed(corner == 0 || corner == 3 ? -0.08 : 0.08,
                                    corner < 2 ? -0.08 : 0.08, 0);
      const Eigen::Vector3d at = world_from_sensor.inverse() * (world_from_board * printed);
      for (const double metres : at) tag.add_corners(static_cast<float>(metres));
    }
  }
  return seen;
}

}  // namespace roomcast::alignment
