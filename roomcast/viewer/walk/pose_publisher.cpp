// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/walk/pose_publisher.h"

#include <utility>

namespace roomcast::viewer {
namespace {

bool is_same(const client::PointerBeam& a, const client::PointerBeam& b) {
  return a.from_m == b.from_m && a.to_m == b.to_m;
}

template <class Part>
bool is_same(const std::optional<Part>& a, const std::optional<Part>& b) {
  return a.has_value() == b.has_value() && (!a || is_same(*a, *b));
}

bool is_same(const client::PersonPose& a, const client::PersonPose& b) {
  return a.world_from_head == b.world_from_head &&
         a.world_from_left_hand == b.world_from_left_hand &&
         a.world_from_right_hand == b.world_from_right_hand && is_same(a.pointer, b.pointer) &&
         a.view == b.view;
}

}  // namespace

void PosePublisher::set(const client::PersonPose& pose) {
  if (pose_ && is_same(*pose_, pose)) return;
  pose_ = pose;
  is_unsent_ = true;
}

std::optional<client::PersonPose> PosePublisher::take(HostTime now) {
  const bool is_soon = sent_ && now - *sent_ < kInterval;
  if (!is_unsent_ || is_soon || !pose_) return std::nullopt;
  is_unsent_ = false;
  sent_ = now;
  return pose_;
}

}  // namespace roomcast::viewer
