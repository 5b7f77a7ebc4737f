// SPDX-License-Identifier: Apache-2.0
#include "roomcast/wire/pose_message.h"

#include <span>

#include "roomcast/core/assert.h"
#include "roomcast/wire/limits.h"

namespace roomcast::wire {
namespace {

constexpr std::size_t kTransformNumbers = 16;

PoseSource source_from(pb::Placement placement, bool is_unverified) {
  if (placement == pb::PLACEMENT_GIVEN) return PoseSource::kGiven;
  if (placement != pb::PLACEMENT_ALIGNED) return PoseSource::kNone;
  return is_unverified ? PoseSource::kStored : PoseSource::kEstimated;
}

pb::Placement placement_from(PoseSource source) {
  if (source == PoseSource::kNone) return pb::PLACEMENT_UNPLACED;
  return source == PoseSource::kGiven ? pb::PLACEMENT_GIVEN : pb::PLACEMENT_ALIGNED;
}

/// The state of the pose of a sensor that was not moved.
PoseState state_of(PoseSource source) {
  if (source == PoseSource::kNone) return PoseState::kNone;
  return source == PoseSource::kStored ? PoseState::kUnverified : PoseState::kValid;
}

}  // namespace

void write_transform(const RigidTransform& transform,
                     google::protobuf::RepeatedField<double>& row_major) {
  const auto numbers = row_major_from_transform(transform);
  row_major.Assign(numbers.begin(), numbers.end());
}

Result<RigidTransform> read_transform(const google::protobuf::RepeatedField<double>& row_major) {
  return transform_from_row_major(
      std::span(row_major.data(), static_cast<std::size_t>(row_major.size())));
}

RigidTransform exact_transform(const google::protobuf::RepeatedField<double>& row_major) {
  ROOMCAST_ASSERT(row_major.size() == int{kTransformNumbers});
  return exact_transform_from_row_major(
      std::span<const double, kTransformNumbers>(row_major.data(), kTransformNumbers));
}

Result<SensorPose> read_pose(const pb::SensorEntry& entry) {
  const auto world_from_depth = read_transform(entry.world_from_depth());
  if (!world_from_depth) return world_from_depth.error();
  SensorPose pose;
  pose.world_from_depth = *world_from_depth;
  pose.source = source_from(entry.placement(), entry.unverified());
  pose.state = entry.moved() ? PoseState::kMoved : state_of(pose.source);
  if (pose.is_estimated()) pose.expected_error_mm = entry.expected_error_mm();
  if (entry.depth_scale() != 0) pose.depth_scale = entry.depth_scale();
  pose.note = entry.placement_note();
  return pose;
}

void write_pose(const SensorPose& pose, pb::SensorEntry& entry) {
  write_transform(pose.world_from_depth, *entry.mutable_world_from_depth());
  entry.set_placement(placement_from(pose.source));
  entry.set_expected_error_mm(static_cast<float>(pose.expected_error_mm));
  if (pose.depth_scale != 1) entry.set_depth_scale(pose.depth_scale);
  entry.set_placement_note(pose.note);
  entry.set_moved(pose.is_moved());
  entry.set_unverified(pose.source == PoseSource::kStored);
}

SensorPose read_pose(const pb::SensorPlacement& placement) {
  SensorPose pose;
  pose.note = placement.note();
  if (placement.world_from_depth().empty()) return pose;
  pose.world_from_depth = exact_transform(placement.world_from_depth());
  pose.source = placement.unverified() ? PoseSource::kStored : PoseSource::kEstimated;
  pose.state = state_of(pose.source);
  pose.expected_error_mm = placement.expected_error_mm();
  if (placement.depth_scale() != 0) pose.depth_scale = placement.depth_scale();
  return pose;
}

void write_pose(const SensorPose& pose, pb::SensorPlacement& placement) {
  if (pose.is_placed())
    write_transform(pose.world_from_depth, *placement.mutable_world_from_depth());
  placement.set_expected_error_mm(static_cast<float>(pose.expected_error_mm));
  placement.set_depth_scale(pose.depth_scale);
  placement.set_note(pose.note.substr(0, kMaxNoteBytes));
  placement.set_unverified(pose.source == PoseSource::kStored);
}

}  // namespace roomcast::wire
