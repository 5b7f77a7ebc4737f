// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/people/skeleton.h"

#include <algorithm>
#include <cmath>

namespace roomcast::simulator {
namespace {

using Eigen::AngleAxisf;
using Eigen::Isometry3f;
using Eigen::Matrix3f;
using Eigen::Quaternionf;
using Eigen::Vector3f;

Isometry3f framed(const Vector3f& origin, const Matrix3f& axes) {
  Isometry3f frame = Isometry3f::Identity();
  frame.linear() = axes;
  frame.translation() = origin;
  return frame;
}

struct Limb {
  Isometry3f upper, lower;
  Vector3f end;
};

/// The unit vector of the part of `way` that is orthogonal to the unit vector `along`.
Vector3f across(const Vector3f& way, const Vector3f& along) {
  const Vector3f part = way - way.dot(along) * along;
  return part.norm() > 1e-4F ? Vector3f(part.normalized()) : along.unitOrthogonal();
}

/// Axes of a bone from `from` to `to` whose z axis is in the plane of bending.
Matrix3f bone_axes(const Vector3f& from, const Vector3f& to, const Vector3f& ahead) {
  const Vector3f up = (from - to).normalized();
  const Vector3f z = across(ahead, up);
  Matrix3f axes;
  axes << up.cross(z), up, z;
  return axes;
}

/// Bends two bones from `root` to `target`; their joint points along `joint_way`. `z_sign`: knees
/// point ahead of the leg, elbows behind the arm.
Limb bent(const Vector3f& root, const Vector3f& target, float upper, float lower,
          const Vector3f& joint_way, float z_sign) {
  const Vector3f way = target - root;
  const float reach =
      std::clamp(way.norm(), std::abs(upper - lower) + 1e-3F, (upper + lower) * 0.9999F);
  const Vector3f along = way.normalized();
  const Vector3f out = across(joint_way, along);
  const float foot = (upper * upper - lower * lower + reach * reach) / (2.0F * reach);
  const float height = std::sqrt(std::max(0.0F, upper * upper - foot * foot));
  const Vector3f joint = root + foot * along + height * out;
  const Vector3f end = root + reach * along;
  const Vector3f ahead = z_sign * out;
  return {framed(root, bone_axes(root, joint, ahead)), framed(joint, bone_axes(joint, end, ahead)),
          end};
}

void solve_leg(Pose& pose, Side side, const PoseGoals& goals, const Measures& m) {
  const Isometry3f& foot = goals.feet[index_of(side)];
  const Vector3f hip = hip_of(goals.pelvis, side, m);
  const Vector3f knee_way = goals.pelvis.linear().col(2) + 0.8F * foot.linear().col(2) +
                            0.12F * sign_of(side) * goals.pelvis.linear().col(0);
  const Limb leg = bent(hip, foot.translation(), m.thigh, m.shin, knee_way, 1.0F);
  pose.of(on_side(Bone::kLeftThigh, side)) = leg.upper;
  pose.of(on_side(Bone::kLeftShin, side)) = leg.lower;
  pose.of(on_side(Bone::kLeftFoot, side)) = framed(leg.end, foot.linear());
}

void solve_arm(Pose& pose, Side side, const PoseGoals& goals, const Measures& m) {
  const HandGoal& goal = goals.hands[index_of(side)];
  const Vector3f shoulder = shoulder_of(pose.of(Bone::kChest), side, m);
  const Limb arm = bent(shoulder, goal.wrist_m, m.upper_arm, m.forearm, goal.elbow_way, -1.0F);
  pose.of(on_side(Bone::kLeftUpperArm, side)) = arm.upper;
  pose.of(on_side(Bone::kLeftForearm, side)) = arm.lower;
  const Quaternionf straight(Matrix3f(arm.lower.linear()));
  const Quaternionf turned = straight.slerp(goal.turned_share, goal.turned);
  pose.of(on_side(Bone::kLeftHand, side)) = framed(arm.end, turned.toRotationMatrix());
}

}  // namespace

Measures measures_of(const Build& build) {
  const float s = build.height_m / 1.80F;
  Measures m{};
  m.scale = s;
  m.girth = build.girth;
  m.hip_half = 0.088F * s * std::sqrt(build.girth);
  m.thigh = 0.43F * s;
  m.shin = 0.41F * s;
  m.ankle = 0.085F * s;
  m.waist = 0.10F * s;
  m.shoulder = 0.415F * s;
  m.shoulder_half = 0.178F * s * (0.6F + 0.4F * build.girth);
  m.neck = 0.535F * s;
  m.upper_arm = 0.29F * s;
  m.forearm = 0.255F * s;
  m.palm = 0.085F * s;
  return m;
}

Isometry3f chest_on(const Isometry3f& pelvis, const Quaternionf& chest_in_pelvis,
                    const Measures& m) {
  return pelvis * Eigen::Translation3f(0, m.waist, 0) * chest_in_pelvis;
}

Vector3f shoulder_of(const Isometry3f& chest, Side side, const Measures& m) {
  return chest * Vector3f(sign_of(side) * m.shoulder_half, m.shoulder, -0.01F * m.scale);
}

Vector3f hip_of(const Isometry3f& pelvis, Side side, const Measures& m) {
  return pelvis * Vector3f(sign_of(side) * m.hip_half, 0, 0);
}

Vector3f palm_in_hand(Side side, const Measures& m) {
  return {-sign_of(side) * 0.018F * m.scale, -m.palm, 0.005F * m.scale};
}

Pose solve_pose(const PoseGoals& goals, const Measures& m) {
  Pose pose;
  pose.of(Bone::kPelvis) = goals.pelvis;
  pose.of(Bone::kChest) = chest_on(goals.pelvis, goals.chest_in_pelvis, m);
  pose.of(Bone::kHead) = pose.of(Bone::kChest) * Eigen::Translation3f(0, m.neck, 0.012F * m.scale) *
                         goals.head_in_chest;
  for (const Side side : kSides) {
    solve_leg(pose, side, goals, m);
    solve_arm(pose, side, goals, m);
  }
  return pose;
}

Pose cutting_pose(const Measures& m) {
  constexpr float kArmsOut_rad = 0.75F;
  PoseGoals goals;
  goals.pelvis.translation() = Vector3f(0, m.hips_standing(), 0);
  for (const Side side : kSides) {
    const Vector3f hip = hip_of(goals.pelvis, side, m);
    goals.feet[index_of(side)] = Isometry3f::Identity();
    goals.feet[index_of(side)].translation() =
        hip - Vector3f(0, m.leg() * 0.9999F, 0) + Vector3f(sign_of(side) * 0.03F, 0, 0);
    const Isometry3f chest = chest_on(goals.pelvis, goals.chest_in_pelvis, m);
    const float out = sign_of(side) * std::sin(kArmsOut_rad);
    HandGoal& hand = goals.hands[index_of(side)];
    hand.wrist_m = shoulder_of(chest, side, m) +
                   0.9999F * (m.upper_arm + m.forearm) * Vector3f(out, -std::cos(kArmsOut_rad), 0);
  }
  return solve_pose(goals, m);
}

}  // namespace roomcast::simulator
