// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/room/person_pose.h"

#include <Eigen/Geometry>

namespace roomcast::client {
namespace {

void write_part(const RigidTransform& world_from_part, wire::pb::Pose& part) {
  const Eigen::Quaternionf turn =
      Eigen::Quaterniond(world_from_part.rotation).normalized().cast<float>();
  const Eigen::Vector3f place_m = world_from_part.translation_m.cast<float>();
  part.set_x(place_m.x());
  part.set_y(place_m.y());
  part.set_z(place_m.z());
  part.set_qx(turn.x());
  part.set_qy(turn.y());
  part.set_qz(turn.z());
  part.set_qw(turn.w());
}

RigidTransform read_part(const wire::pb::Pose& part) {
  const Eigen::Quaterniond turn(part.qw(), part.qx(), part.qy(), part.qz());
  return {turn.normalized().toRotationMatrix(), {part.x(), part.y(), part.z()}};
}

void write_point(const Eigen::Vector3d& place_m, wire::pb::Point& point) {
  point.set_x(static_cast<float>(place_m.x()));
  point.set_y(static_cast<float>(place_m.y()));
  point.set_z(static_cast<float>(place_m.z()));
}

Eigen::Vector3d read_point(const wire::pb::Point& point) {
  return {point.x(), point.y(), point.z()};
}

}  // namespace

wire::pb::ViewerPose message_from_pose(const PersonPose& pose) {
  wire::pb::ViewerPose message;
  write_part(pose.world_from_head, *message.mutable_head());
  if (pose.world_from_left_hand)
    write_part(*pose.world_from_left_hand, *message.mutable_left_hand());
  if (pose.world_from_right_hand)
    write_part(*pose.world_from_right_hand, *message.mutable_right_hand());
  if (pose.pointer) {
    write_point(pose.pointer->from_m, *message.mutable_pointer()->mutable_from());
    write_point(pose.pointer->to_m, *message.mutable_pointer()->mutable_to());
  }
  message.set_view_half_angle(static_cast<float>(pose.view.half_angle_rad));
  message.set_view_half_width(static_cast<float>(pose.view.half_width_rad));
  message.set_view_half_height(static_cast<float>(pose.view.half_height_rad));
  return message;
}

PersonPose pose_from_message(const wire::pb::ViewerPose& message) {
  PersonPose pose;
  pose.world_from_head = read_part(message.head());
  if (message.has_left_hand()) pose.world_from_left_hand = read_part(message.left_hand());
  if (message.has_right_hand()) pose.world_from_right_hand = read_part(message.right_hand());
  if (message.has_pointer()) {
    pose.pointer =
        PointerBeam{read_point(message.pointer().from()), read_point(message.pointer().to())};
  }
  return pose;
}

}  // namespace roomcast::client
