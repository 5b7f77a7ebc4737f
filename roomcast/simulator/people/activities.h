// SPDX-License-Identifier: Apache-2.0
// What a activity asks of a body: how it leans, sinks and looks, and where its hands go, as a
// function of how much of the stay is over. Everything eases in from standing and back to it.
// Metres, seconds, radians.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "roomcast/simulator/people/itinerary.h"
#include "roomcast/simulator/people/skeleton.h"

namespace roomcast::simulator {

/// Eased 0..1: how deep somebody is in what they do at a stop.
[[nodiscard]] float depth_of(const Itinerary::Stay& stay, float ramp_s);

/// How the trunk differs from standing upright. Pitches are forward.
struct Lean {
  float seated = 0;  // 0: on their feet, 1: on the seat
  float sink_m = 0;  // of the hips
  float hips_back_m = 0;
  float pelvis_pitch = 0, chest_pitch = 0, chest_yaw = 0;
  float looks = 0;  // share of the gaze that goes to the target
};
[[nodiscard]] Lean lean_of(const Waypoint& stop, const Itinerary::Stay& stay, double time_s);

/// Bending down to something at `target_m` before a person standing at the stop.
[[nodiscard]] Lean lean_towards(const Waypoint& stop, float share);

/// Where a palm is wanted; share 0: the hand hangs.
struct HandTarget {
  Eigen::Vector3f palm_m = Eigen::Vector3f::Zero();
  Eigen::Quaternionf turned = Eigen::Quaternionf::Identity();
  float share = 0;
};
/// `body`: heading frame at the hips (y up, z ahead); `chest`: the chest's frame.
[[nodiscard]] HandTarget palm_wish(const Waypoint& stop, const Itinerary::Stay& stay, Side side,
                                   double time_s, const Eigen::Isometry3f& body,
                                   const Measures& measures);

/// Palms facing each other, fingers ahead and `up_rad` above the horizon.
[[nodiscard]] Eigen::Quaternionf palms_inward(const Eigen::Isometry3f& body, float up_rad);
/// Palm down or towards what is ahead, fingers ahead.
[[nodiscard]] Eigen::Quaternionf palm_down(const Eigen::Isometry3f& body, Side side, float up_rad);

}  // namespace roomcast::simulator
