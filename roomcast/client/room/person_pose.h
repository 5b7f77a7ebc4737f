// SPDX-License-Identifier: Apache-2.0
// The pose of a person's head and hands and their pointer, as geometry and as a message of the wire
// (docs/spec/wire.md section 3). World frame, metres; part frames x right, y up, -z forward.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/geometry/view_cone.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::client {

/// The beam of a laser pointer.
struct PointerBeam {
  Eigen::Vector3d from_m, to_m;
};

struct PersonPose {
  RigidTransform world_from_head;
  std::optional<RigidTransform> world_from_left_hand, world_from_right_hand;  // while tracked
  std::optional<PointerBeam> pointer;                                         // while pointing
  /// One's own only: how far one sees from the head's -z axis. By it the hub leaves out frames of
  /// sensors whose surfaces are not seen. All 0: send all.
  ViewAngles view = {};
};

/// Without the viewer's ID, which the hub adds.
[[nodiscard]] wire::pb::ViewerPose message_from_pose(const PersonPose& pose);

/// `message` has passed wire::decode_control.
[[nodiscard]] PersonPose pose_from_message(const wire::pb::ViewerPose& message);

}  // namespace roomcast::client
