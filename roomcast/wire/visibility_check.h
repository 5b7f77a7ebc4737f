// SPDX-License-Identifier: Apache-2.0
// Checks the messages about what viewers can see, and what sensors send for it: docs/spec/wire.md
// §3 and §4.
#pragma once

#include <initializer_list>

#include "roomcast/core/result.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::wire {

/// Viewers' cones in a WatchedFrom. More viewers than fit are told as none: somebody gets
/// everything.
inline constexpr int kMaxViewCones = 48;

/// Of CoarseDepth, FrameDemand, UnseenSensors and WatchedFrom; others pass.
[[nodiscard]] Status check_visibility(const pb::Control& control);
/// Half angles of view, radians; 0: unknown.
[[nodiscard]] Status check_view_half_angles(std::initializer_list<float> angles_rad);

}  // namespace roomcast::wire
