// SPDX-License-Identifier: Apache-2.0
// The start pose of a viewer in the room (the paper's "render position per client"): next to a
// sensor, at eye height, facing the point that the sensors look at. A place next to a sensor is
// known to be inside the room and to have something to see.
#pragma once

#include <cstddef>
#include <span>

#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::hub {

/// world_from_viewer of the `index`-th viewer; viewer frame x right, y up, -z forward; metres.
/// `world_from_depth`: the poses of all placed sensors (optical frames). Viewers are distributed
/// over the sensors; several at one sensor start side by side.
[[nodiscard]] RigidTransform start_pose(std::span<const RigidTransform> world_from_depth,
                                        std::size_t index);

}  // namespace roomcast::hub
