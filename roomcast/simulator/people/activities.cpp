// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/people/activities.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "roomcast/simulator/scene/angles.h"

namespace roomcast::simulator {
namespace {

using Eigen::AngleAxisf;
using Eigen::Isometry3f;
using Eigen::Quaternionf;
using Eigen::Vector3f;

constexpr float kSitDown_s = 1.5F, kReach_s = 1.0F;
constexpr double kExercise_rad_s = 2.6, kStretch_rad_s = 0.6;

float wave(double time_s, double per_second, double shift) {
  return static_cast<float>(std::sin(time_s * per_second + shift));
}

/// Intensity of talking gestures, which come in bursts: 0..1.
float burst(double time_s, double shift) {
  const float slow = wave(time_s, 0.9, shift) + 0.6F * wave(time_s, 0.41, 2.0 * shift);
  return std::clamp(0.45F + 0.9F * slow, 0.0F, 1.0F);
}

bool sits(Activity activity) {
  return activity == Activity::kSit || activity == Activity::kSitTalk ||
         activity == Activity::kType;
}

Lean seated_lean(Activity activity, float depth) {
  Lean lean;
  lean.seated = depth;
  const float moving = std::sin(kPi * depth);  // the trunk leans forward on the way down and up
  const float resting = activity == Activity::kType ? 0.10F : -0.13F;
  lean.pelvis_pitch = 0.28F * moving + 0.6F * resting * depth;
  lean.chest_pitch = 0.40F * moving + (resting + 0.12F) * depth;
  return lean;
}

/// Offset of a gesturing hand from its base position in front of the chest, in the body frame.
Vector3f gesture(Side side, double time_s) {
  const double own = side == Side::kLeft ? 0.0 : 1.9;
  return {0.07F * wave(time_s, 3.1, own) + 0.04F * wave(time_s, 5.3, own),
          0.06F * wave(time_s, 4.3, 1.0 + own) + 0.03F * wave(time_s, 7.1, own),
          0.06F * wave(time_s, 2.7, 2.0 + own)};
}

HandTarget gesturing(Side side, double time_s, const Isometry3f& body, const Measures& m,
                     float depth, float forward_m) {
  HandTarget wish;
  const float up = m.waist + 0.22F * m.scale;
  const Vector3f base(sign_of(side) * 0.17F, up, forward_m);
  wish.palm_m = body * Vector3f(base + gesture(side, time_s));
  wish.turned = palms_inward(body, 0.5F + 0.4F * wave(time_s, 2.3, sign_of(side)));
  wish.share = depth * burst(time_s, side == Side::kLeft ? 0.3 : 1.1);
  return wish;
}

/// A hand that rests on the thigh of a seated person.
HandTarget on_thigh(Side side, const Isometry3f& body, const Measures& m, float depth) {
  HandTarget wish;
  wish.palm_m = body * Vector3f(sign_of(side) * 0.12F * m.scale, 0.10F * m.scale, 0.27F * m.scale);
  wish.turned = palm_down(body, side, -0.1F);
  wish.share = depth;
  return wish;
}

/// Straight arms, rotated about the shoulders: 0 hanging, a quarter turn forward, half a turn up.
HandTarget swung(Side side, const Isometry3f& body, const Measures& m, float raised_rad,
                 float out_m) {
  const float arm = 0.85F * (m.upper_arm + m.forearm + m.palm);
  HandTarget wish;
  wish.palm_m = body * Vector3f(sign_of(side) * (m.shoulder_half + out_m),
                                m.waist + m.shoulder - arm * std::cos(raised_rad),
                                arm * std::sin(raised_rad) + 0.04F);
  wish.turned = palms_inward(body, raised_rad - 0.5F * kPi);
  return wish;
}

/// Depth of the exercise movement: 0..1 and back.
float dip(double time_s) {
  return 0.5F - 0.5F * wave(time_s, kExercise_rad_s, 0.5 * std::numbers::pi);
}
float slow_dip(double time_s) {
  return 0.5F - 0.5F * wave(time_s, kStretch_rad_s, 0.0);
}

Lean exercising_lean(double time_s, float depth) {
  const float down = depth * dip(time_s);
  Lean lean;
  lean.sink_m = 0.20F * down;
  lean.hips_back_m = 0.12F * down;
  lean.pelvis_pitch = 0.15F * down;
  lean.chest_pitch = 0.30F * down;
  lean.chest_yaw = depth * 0.35F * wave(time_s, 0.5 * kExercise_rad_s, 0.0);
  return lean;
}

Lean stretching_lean(double time_s, float depth) {
  const float down = depth * slow_dip(time_s);
  Lean lean;
  lean.hips_back_m = 0.06F * down;
  lean.pelvis_pitch = 0.35F * down;
  lean.chest_pitch = 0.45F * down;
  return lean;
}

HandTarget mixed(const HandTarget& under, const HandTarget& over) {
  if (under.share <= 0.0F) return over;
  HandTarget wish;
  wish.palm_m = under.palm_m + over.share * (over.palm_m - under.palm_m);
  wish.turned = under.turned.slerp(over.share, over.turned);
  wish.share = std::max(under.share, over.share);
  return wish;
}

HandTarget at_target(const Vector3f& palm_m, const Quaternionf& turned, float share) {
  return {palm_m, turned, share};
}

/// Writing motion: fast strokes on a slow path across and down.
Vector3f pen(const Isometry3f& body, double time_s) {
  const float across = 0.14F * wave(time_s, 0.8, 0.0);
  const float down = 0.06F * wave(time_s, 0.23, 1.0);
  return body.linear() * Vector3f(-across + 0.012F * wave(time_s, 11.0, 0.0),
                                  down + 0.018F * wave(time_s, 9.0, 1.0), 0);
}

}  // namespace

float depth_of(const Itinerary::Stay& stay, float ramp_s) {
  const float whole = stay.since_s + stay.left_s;
  const float ramp = std::min(ramp_s, 0.45F * whole);
  const float t = std::clamp(std::min(stay.since_s, stay.left_s) / ramp, 0.0F, 1.0F);
  return t * t * t * (10.0F - 15.0F * t + 6.0F * t * t);
}

Lean lean_towards(const Waypoint& stop, float share) {
  Lean lean;
  const float low = std::clamp((1.02F - stop.target_m.y()) / 0.9F, 0.0F, 1.0F);
  const float far =
      std::clamp((Eigen::Vector2f(stop.target_m.x(), stop.target_m.z()) - stop.at_m).norm() - 0.35F,
                 0.0F, 0.35F);
  lean.sink_m = share * 0.44F * low;
  lean.hips_back_m = share * 0.16F * low;
  lean.pelvis_pitch = share * (0.30F * low + 0.35F * far);
  lean.chest_pitch = share * (0.50F * low + 1.0F * far);
  lean.looks = share;
  return lean;
}

Lean lean_of(const Waypoint& stop, const Itinerary::Stay& stay, double time_s) {
  if (sits(stop.activity)) {
    Lean lean = seated_lean(stop.activity, depth_of(stay, kSitDown_s));
    lean.looks = lean.seated * (stop.activity == Activity::kSit ? 0.0F : 0.85F);
    if (stop.activity == Activity::kSitTalk)
      lean.chest_yaw = lean.seated * 0.10F * wave(time_s, 0.7, 0.0);
    return lean;
  }
  const float depth = depth_of(stay, kReach_s);
  if (stop.activity == Activity::kReach || stop.activity == Activity::kPlug)
    return lean_towards(stop, depth);
  if (stop.activity == Activity::kExercise) return exercising_lean(time_s, depth);
  if (stop.activity == Activity::kStretch) return stretching_lean(time_s, depth);
  Lean lean;
  if (stop.activity == Activity::kWrite) lean.looks = depth;
  if (stop.activity == Activity::kTalk) {
    lean.looks = 0.9F * depth;
    lean.chest_yaw = depth * 0.12F * wave(time_s, 0.8, 0.5);
  }
  return lean;
}

HandTarget hand_target(const Waypoint& stop, const Itinerary::Stay& stay, Side side, double time_s,
                       const Isometry3f& body, const Measures& m) {
  const bool right = side == Side::kRight;
  const float depth = depth_of(stay, kReach_s);
  switch (stop.activity) {
    case Activity::kSit:
      return on_thigh(side, body, m, depth_of(stay, kSitDown_s));
    case Activity::kSitTalk: {
      const float seated = depth_of(stay, kSitDown_s);
      return mixed(on_thigh(side, body, m, seated),
                   gesturing(side, time_s, body, m, seated, 0.34F));
    }
    case Activity::kType: {
      const Vector3f apart = body.linear() * Vector3f(sign_of(side) * 0.09F, 0, 0);
      const Vector3f taps(0.012F * wave(time_s, 5.0, sign_of(side)),
                          0.006F * wave(time_s, 17.0, sign_of(side)), 0.0F);
      return at_target(stop.target_m + apart + taps, palm_down(body, side, -0.15F),
                       depth_of(stay, kSitDown_s));
    }
    case Activity::kTalk:
      return gesturing(side, time_s, body, m, depth, 0.30F);
    case Activity::kReach:
      if (!right) return {};
      return at_target(stop.target_m, palms_inward(body, 0.2F), depth);
    case Activity::kWrite:
      if (!right) return {};
      return at_target(stop.target_m + pen(body, time_s), palms_inward(body, 0.9F), depth);
    case Activity::kPlug: {
      const Vector3f apart =
          right ? Vector3f::Zero() : Vector3f(body.linear() * Vector3f(0.12F, 0.02F, -0.02F));
      const Vector3f fiddling(0.012F * wave(time_s, 6.1, sign_of(side)),
                              0.010F * wave(time_s, 4.7, sign_of(side)),
                              0.012F * wave(time_s, 3.3, 0.0));
      return at_target(stop.target_m + apart + fiddling, palms_inward(body, 0.1F), depth);
    }
    case Activity::kExercise: {
      HandTarget wish = swung(side, body, m, 0.5F + 2.1F * (1.0F - dip(time_s)), 0.18F);
      wish.share = depth;
      return wish;
    }
    case Activity::kStretch: {
      HandTarget wish = swung(side, body, m, 0.8F + 0.9F * (1.0F - slow_dip(time_s)), 0.06F);
      wish.share = depth;
      return wish;
    }
    case Activity::kStand:
    case Activity::kTakeUp:
    case Activity::kPutDown:
      return {};
  }
  return {};
}

Quaternionf palms_inward(const Isometry3f& body, float up_rad) {
  Eigen::Matrix3f axes;  // fingers along -y of the hand, thumb along z
  axes << Vector3f::UnitX(), -Vector3f::UnitZ(), Vector3f::UnitY();
  const AngleAxisf raised(-up_rad, Vector3f::UnitX());
  return Quaternionf(Eigen::Matrix3f(body.linear() * raised.toRotationMatrix() * axes));
}

Quaternionf palm_down(const Isometry3f& body, Side side, float up_rad) {
  const AngleAxisf about_fingers(-sign_of(side) * 0.45F * kPi, Vector3f::UnitY());
  return palms_inward(body, up_rad) * Quaternionf(about_fingers);
}

}  // namespace roomcast::simulator
