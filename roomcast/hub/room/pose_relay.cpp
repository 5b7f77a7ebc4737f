// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/pose_relay.h"

#include <algorithm>
#include <utility>

#include "roomcast/wire/limits.h"

namespace roomcast::hub {

void PoseRelay::set(ViewerId viewer, const wire::pb::ViewerPose& pose, RoomTime now) {
  Person& person = people_[viewer];
  if (now - person.window_begin >= std::chrono::seconds(1)) {
    person.window_begin = now;
    person.poses_in_window = 0;
  }
  if (++person.poses_in_window > wire::kMaxPosesPerSecond) return;
  person.pose = pose;
  person.pose.set_viewer_id(viewer.value);
  person.has_changed = has_changed_ = true;
}

void PoseRelay::resend_all() {
  for (auto& [viewer, person] : people_) person.has_changed = has_changed_ = true;
}

std::optional<wire::pb::Control> PoseRelay::take(RoomTime now) {
  if (!has_changed_ || now < next_) return std::nullopt;
  has_changed_ = false;
  wire::pb::Control control;
  for (auto& [viewer, person] : people_) {
    if (std::exchange(person.has_changed, false)) {
      *control.mutable_viewer_poses()->add_poses() = person.pose;
    }
  }
  const auto count = control.viewer_poses().poses_size();
  if (count == 0) return std::nullopt;  // the viewers that had moved have left
  next_ = now + std::max<nanoseconds>(wire::kPoseInterval, count * wire::kIntervalPerPose);
  return control;
}

std::optional<RoomTime> PoseRelay::next() const {
  if (!has_changed_) return std::nullopt;
  return next_;
}

}  // namespace roomcast::hub
