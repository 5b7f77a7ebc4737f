// SPDX-License-Identifier: Apache-2.0
// Body posture during an activity (lean, hip height, gaze and hand targets), as a function of the
// progress of the stay. Everything eases in from standing and back to it. Metres, seconds, radians.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "roomcast/simulator/people/itinerary.h"
#include "roomcast/simulator/people/skeleton.h"

namespace roomcast::simulator {

/// Eased 0..1: how far a person has entered the activity at a waypoint.
[[nodiscard]] float depth_of(const Itinerary::Stay& stay, float ramp_s);

/// Deviation of the trunk from standing upright. Pitches are forward.
struct Lean {
  float seated = 0;  // 0: on the feet, 1: on the seat
  float sink_m = 0;  // lowering of the hips
  float hips_back_m = 0;
  float pelvis_pitch = 0, chest_pitch = 0, chest_yaw = 0;
  float looks = 0;  // share of the gaze directed at the target
};
[[nodiscard]] Lean lean_of(const Waypoint& stop, const Itinerary::Stay& stay, double time_s);

/// Bends towards an object at `target_m` in front of a person who stands at the waypoint.
[[nodiscard]] Lean lean_towards(const Waypoint& stop, float share);

/// Target of a palm; share 0: the hand hangs.
struct HandTarget {
  Eigen::Vector3f palm_m = Eigen::Vector3f::Zero();
  Eigen::Quaternionf turned = Eigen::Quaternionf::Identity();
  float share = 0;
};
/// `body`: heading frame at the hips (y up, z ahead); `chest`: the chest's frame.
[[nodiscard]] HandTarget hand_target(const Waypoint& stop, const Itinerary::Stay& stay, Side side,
                                     double time_s, const Eigen::Isometry3f& body,
                                     const Measures& measures);

/// Palms facing each other, fingers ahead and `up_rad` above the horizon.
[[nodiscard]] Eigen::Quaternionf palms_inward(const Eigen::Isometry3f& body, float up_rad);
/// Palm down or forward, fingers forward.
[[nodiscard]] Eigen::Quaternionf palm_down(const Eigen::Isometry3f& body, Side side, float up_rad);

}  // namespace roomcast::simulator
