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
  person.pose.clear_view_half_angle();  // what the viewer sees is the hub's business only
  person.pose.clear_view_half_width();
  person.pose.clear_view_half_height();
  person.has_changed = has_changed_ = true;
}

const wire::pb::Pose* PoseRelay::head_of(ViewerId viewer) const {
  const auto person = people_.find(viewer);
  return person == people_.end() ? nullptr : &person->second.pose.head();
}

void PoseRelay::resend_all() {
  for (auto& [viewer, person] : people_) person.has_changed = has_changed_ = true;
}

std::optional<wire::pb::Control> PoseRelay::take(RoomTime now) {
  if (!has_changed_ || now < next_) return std::nullopt;
  has_changed_ = false;
  wire::pb::Control control;
  auto& poses = *control.mutable_viewer_poses();
  auto person = people_.upper_bound(last_sent_);
  for (std::size_t seen = 0; seen < people_.size(); ++seen, ++person) {
    if (person == people_.end()) person = people_.begin();
    if (!person->second.has_changed) continue;
    if (poses.poses_size() == wire::kMaxPosesPerMessage) {
      has_changed_ = true;
      break;
    }
    person->second.has_changed = false;
    *poses.add_poses() = person->second.pose;
    last_sent_ = person->first;
  }
  const auto count = poses.poses_size();
  if (count == 0) return std::nullopt;  // the viewers that had moved have left
  next_ = now + std::max<nanoseconds>(wire::kPoseInterval, count * wire::kIntervalPerPose);
  return control;
}

std::optional<RoomTime> PoseRelay::next() const {
  if (!has_changed_) return std::nullopt;
  return next_;
}

}  // namespace roomcast::hub
