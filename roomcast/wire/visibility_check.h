// SPDX-License-Identifier: Apache-2.0
// Checks the messages about what viewers can see, and what sensors send for it: docs/spec/wire.md
// §3 and §4.
#pragma once

#include "roomcast/core/result.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::wire {

[[nodiscard]] Status check_coarse_depth(const pb::CoarseDepth& depth);
[[nodiscard]] Status check_unseen_sensors(const pb::UnseenSensors& unseen);
[[nodiscard]] Status check_frame_demand(const pb::FrameDemand& demand);
/// Of a ViewerPose; 0: unknown.
[[nodiscard]] Status check_view_half_angle(float angle_rad);

}  // namespace roomcast::wire
