// SPDX-License-Identifier: Apache-2.0
// PoseChange: what a new pose of a sensor says of the view gathered so far. Pure.
#pragma once

#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::recording {

enum class PoseChange {
  kNone,
  kRefined,  // the sensor stands; its pose is known better, if the view stays the same
  kMoved,
};

[[nodiscard]] inline PoseChange pose_change(const RigidTransform& before,
                                            const RigidTransform& now) {
  constexpr double kRefined_m = 0.3, kRefinedTurn = 0.2;  // more is a move
  if (before == now) return PoseChange::kNone;
  const bool is_near = (before.translation_m - now.translation_m).norm() < kRefined_m &&
                       (before.rotation - now.rotation).norm() < kRefinedTurn;
  return is_near ? PoseChange::kRefined : PoseChange::kMoved;
}

}  // namespace roomcast::recording
