// SPDX-License-Identifier: Apache-2.0
// Verifies stored poses: those of sensors that were offline, and those that a hub stored before it
// was restarted. A pose is confirmed if it fits the view of a sensor whose pose is known; it then
// confirms others. Two stored poses also confirm each other, because two sensors are unlikely
// to be moved alike. No I/O. Deterministic.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "roomcast/alignment/prior/stored_pose_check.h"
#include "roomcast/alignment/service/placement.h"

namespace roomcast::alignment {

struct NamedPose {
  std::string sensor;
  RigidTransform world_from_depth;
};

/// Compares the views of two sensors at these poses.
using PosePairCheck =
    std::function<alignment::StoredPoseCheck(const NamedPose& a, const NamedPose& b)>;

struct StoredPoseChecks {
  std::map<std::string, Placement> confirmed;
  std::map<std::string, Placement> contradicted;  // withdrawn, with the reason
  KnownPoses inconclusive;                        // nothing confirms or contradicts them
};

/// `known`: valid poses.
[[nodiscard]] StoredPoseChecks verify_stored_poses(const KnownPoses& stored,
                                                   const KnownPoses& known,
                                                   const PosePairCheck& check_pair);

}  // namespace roomcast::alignment
