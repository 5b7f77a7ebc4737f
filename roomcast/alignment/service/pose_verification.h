// SPDX-License-Identifier: Apache-2.0
// Which remembered poses still hold: those of sensors that were away, or that a hub knows from
// before it was started. Who sees what it should beside a sensor whose pose is known is confirmed,
// and confirms others; so do two remembered ones each other, for hardly anybody moves two sensors
// alike. Pure. Deterministic.
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

/// What two sensors say of where they are thought to stand.
using PosePairCheck = std::function<alignment::StoredPoseCheck(const NamedPose& a, const NamedPose& b)>;

struct StoredPoseChecks {
  std::map<std::string, Placement> confirmed;
  std::map<std::string, Placement> contradicted;  // withdrawn, with the reason
  KnownPoses untold;                              // nothing to compare them with
};

/// `known`: poses that hold.
[[nodiscard]] StoredPoseChecks verify_stored_poses(const KnownPoses& remembered,
                                                   const KnownPoses& known,
                                                   const PosePairCheck& witness);

}  // namespace roomcast::alignment
