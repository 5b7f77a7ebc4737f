// SPDX-License-Identifier: Apache-2.0
#include "roomcast/wire/visibility_check.h"

#include "roomcast/wire/limits.h"

namespace roomcast::wire {
namespace {

Error malformed_visibility(const char* sentence) {
  return {ErrorCode::kMalformed, sentence};
}

}  // namespace

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
  if (unseen.base_only_size() > int{kMaxSensors} || unseen.paused_size() > int{kMaxSensors})
    return Error{ErrorCode::kTooLarge, "there are more unseen sensors than sensors in a room"};
  return {};
}

Status check_frame_demand(const pb::FrameDemand& demand) {
  const bool is_rate = demand.mbit() >= 0 && demand.mbit() <= kMaxTargetMbit;  // false for NaN
  if (!is_rate)
    return malformed_visibility("a sensor's share of an uplink must be 0 to 1000 Mbit/s");
  return {};
}

Status check_view_half_angle(float angle_rad) {
  const bool is_angle = angle_rad >= 0 && angle_rad <= kMaxViewHalfAngle_rad;  // false for NaN
  if (!is_angle) return malformed_visibility("half an angle of view must be 0 to pi");
  return {};
}

}  // namespace roomcast::wire
