// SPDX-License-Identifier: Apache-2.0
// Built where Cyclone DDS is not installed.
#include "roomcast/ros2/dds/participant.h"

namespace roomcast::ros2 {

Result<std::unique_ptr<Participant>> Participant::open(const ParticipantOptions&) {
  return Error{ErrorCode::kUnsupported,
               "this roomcast was built without Cyclone DDS, which is needed for ROS 2; install "
               "cyclonedds-dev and build again"};
}

}  // namespace roomcast::ros2
