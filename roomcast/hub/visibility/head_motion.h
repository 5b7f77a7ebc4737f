// SPDX-License-Identifier: Apache-2.0
// HeadMotion: where a viewer's head is, and where it will be if it goes on moving like that. Pure.
#pragma once

#include <Eigen/Core>

#include "roomcast/core/clock.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

class HeadMotion {
 public:
  struct Head {
    Eigen::Vector3f at_m = Eigen::Vector3f::Zero();  // world frame
    Eigen::Vector3f forward = -Eigen::Vector3f::UnitZ();
    Eigen::Vector3f up = Eigen::Vector3f::UnitY();
  };

  /// `head` has passed wire::decode_control.
  void moved(const wire::pb::Pose& head, RoomTime now);

  [[nodiscard]] const Head& now() const { return head_; }
  /// At this time, at constant velocity and without rolling. Velocities are bounded by what people
  /// do; a head that has not moved for a while is at rest.
  [[nodiscard]] Head at(RoomTime time, RoomTime now) const;

 private:
  Head head_;
  RoomTime moved_{};
  Eigen::Vector3f velocity_m_s_ = Eigen::Vector3f::Zero();
  Eigen::Vector3f turn_rad_s_ = Eigen::Vector3f::Zero();  // of `forward`: axis times rate
};

}  // namespace roomcast::hub
