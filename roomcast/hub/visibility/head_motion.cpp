// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/visibility/head_motion.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <Eigen/Geometry>

namespace roomcast::hub {
namespace {

constexpr std::chrono::milliseconds kShortestStep{4};  // the velocity of shorter ones is noise
constexpr std::chrono::milliseconds kAtRestAfter{300};
constexpr float kMaxSpeed_m_s = 3, kMaxTurn_rad_s = 8;

float seconds(nanoseconds time) {
  return std::chrono::duration<float>(time).count();
}

Eigen::Vector3f bounded(const Eigen::Vector3f& vector, float longest) {
  const float length = vector.norm();
  return length > longest ? Eigen::Vector3f(vector * (longest / length)) : vector;
}

/// The turn from one direction to another: axis times angle.
Eigen::Vector3f turn_between(const Eigen::Vector3f& from, const Eigen::Vector3f& to) {
  const Eigen::Vector3f axis = from.cross(to);
  const float sine = axis.norm();
  if (sine < 1e-6F) return Eigen::Vector3f::Zero();
  return axis * (std::atan2(sine, from.dot(to)) / sine);
}

}  // namespace

void HeadMotion::moved(const wire::pb::Pose& head, RoomTime now) {
  const auto world_from_head =
      Eigen::Quaternionf(head.qw(), head.qx(), head.qy(), head.qz()).normalized();
  const Head next{{head.x(), head.y(), head.z()},
                  (world_from_head * -Eigen::Vector3f::UnitZ()).normalized(),
                  (world_from_head * Eigen::Vector3f::UnitY()).normalized()};
  const nanoseconds step = now - moved_;
  if (step > kAtRestAfter) {
    velocity_m_s_.setZero();
    turn_rad_s_.setZero();
  } else if (step >= kShortestStep) {
    velocity_m_s_ = bounded((next.at_m - head_.at_m) / seconds(step), kMaxSpeed_m_s);
    turn_rad_s_ =
        bounded(turn_between(head_.forward, next.forward) / seconds(step), kMaxTurn_rad_s);
  }
  head_ = next;
  moved_ = now;
}

HeadMotion::Head HeadMotion::at(RoomTime time, RoomTime now) const {
  if (now - moved_ > kAtRestAfter) return head_;
  const float ahead_s = seconds(time - moved_);
  const Eigen::Vector3f turn = turn_rad_s_ * ahead_s;
  const float angle = turn.norm();
  Head head{head_.at_m + velocity_m_s_ * ahead_s, head_.forward, head_.up};
  if (angle > 1e-6F) {
    const Eigen::AngleAxisf turned(angle, turn / angle);
    head.forward = turned * head_.forward;
    head.up = turned * head_.up;
  }
  return head;
}

}  // namespace roomcast::hub
