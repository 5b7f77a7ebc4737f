// SPDX-License-Identifier: Apache-2.0
// How loud a person is in each ear of a listener: by distance as in the page (inverse distance,
// full within 1 m), and by direction with constant power. World frame, metres. No state.
#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::sound {

/// Loudness of a sound in each channel: left and right. One channel uses the first.
using Gains = std::array<float, 2>;

/// The axes of `world_from_listener` are x right, y up, -z ahead. Somebody without
/// a head is heard in the middle.
[[nodiscard]] Gains listener_gains(const RigidTransform& world_from_listener,
                                   const std::optional<Eigen::Vector3d>& head_m);

}  // namespace roomcast::sound
