// SPDX-License-Identifier: Apache-2.0
#include "roomcast/wire/visibility_check.h"

#include <algorithm>
#include <cmath>

#include "roomcast/wire/limits.h"

namespace roomcast::wire {
namespace {

Error malformed_visibility(const char* sentence) {
  return {ErrorCode::kMalformed, sentence};
}

Status check_coarse_depth(const pb::CoarseDepth& depth) {
  const auto is_side = [](unsigned side) { return side >= 1 && side <= kMaxCoarseSide; };
  if (!is_side(depth.columns()) || !is_side(depth.rows()))
    return malformed_visibility("coarse depth has 1 to 64 columns and rows");
  const auto cells = static_cast<int>(depth.columns() * depth.rows());
  if (depth.near_cm_size() != cells || depth.far_cm_size() != cells)
    return malformed_visibility("coarse depth needs two distances of each cell");
  return {};
}

Status check_unseen_sensors(const pb::UnseenSensors& unseen) {
  if (unseen.base_only_size() > int{kMaxSensors} || unseen.paused_size() > int{kMaxSensors} ||
      unseen.held_back_size() > int{kMaxSensors})
    return Error{ErrorCode::kTooLarge, "there are more unseen sensors than sensors in a room"};
  return {};
}

Status check_frame_demand(const pb::FrameDemand& demand) {
  const bool is_rate = demand.mbit() >= 0 && demand.mbit() <= kMaxTargetMbit;  // false for NaN
  if (!is_rate)
    return malformed_visibility("a sensor's share of an uplink must be 0 to 1000 Mbit/s");
  return {};
}

Status check_cone(const pb::ViewCone& cone) {
  const auto is_near = [](float metres) { return std::abs(metres) <= kMaxPosition_m; };
  const pb::Point &eye = cone.eye(), &forward = cone.forward(), &up = cone.up();
  if (!is_near(eye.x()) || !is_near(eye.y()) || !is_near(eye.z()))  // false for NaN
    return malformed_visibility("a viewer's eye must be within 10 km");
  constexpr float kRounding = 0.01F;
  const auto is_unit = [](const pb::Point& way) {
    return std::abs(std::hypot(way.x(), way.y(), way.z()) - 1) <= kRounding;  // false for NaN
  };
  if (!is_unit(forward)) return malformed_visibility("a direction of view must be a unit vector");
  const float along = forward.x() * up.x() + forward.y() * up.y() + forward.z() * up.z();
  if (cone.has_up() && (!is_unit(up) || std::abs(along) > kRounding))
    return malformed_visibility("what is up in a view must be a unit vector across its direction");
  return check_view_half_angles({cone.half_angle(), cone.half_width(), cone.half_height()});
}

Status check_watched_from(const pb::WatchedFrom& watched) {
  if (watched.cones_size() > kMaxViewCones)
    return Error{ErrorCode::kTooLarge, "there are more cones of view than a message may have"};
  for (const auto& cone : watched.cones()) {
    if (auto s = check_cone(cone); !s) return s;
  }
  return {};
}

}  // namespace

Status check_visibility(const pb::Control& control) {
  switch (control.message_case()) {
    case pb::Control::kCoarseDepth:
      return check_coarse_depth(control.coarse_depth());
    case pb::Control::kFrameDemand:
      return check_frame_demand(control.frame_demand());
    case pb::Control::kUnseenSensors:
      return check_unseen_sensors(control.unseen_sensors());
    case pb::Control::kWatchedFrom:
      return check_watched_from(control.watched_from());
    default:
      return {};
  }
}

Status check_view_half_angles(std::initializer_list<float> angles_rad) {
  const auto is_angle = [](float angle_rad) {
    return angle_rad >= 0 && angle_rad <= kMaxViewHalfAngle_rad;  // false for NaN
  };
  if (!std::ranges::all_of(angles_rad, is_angle))
    return malformed_visibility("half an angle of view must be 0 to pi");
  return {};
}

}  // namespace roomcast::wire
