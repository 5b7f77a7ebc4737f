// SPDX-License-Identifier: Apache-2.0
// Bone lengths, and bone poses from the wanted joint positions (inverse kinematics). A bone's frame
// has its origin at the joint nearer to the pelvis; in the rest pose, standing with hanging arms, x
// points to the body's left, y up and z forward, so limbs run along -y. Metres, radians. Two-bone
// limbs are solved in closed form (law of cosines), so all lengths are exact.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "roomcast/simulator/scene/person.h"

namespace roomcast::simulator {

enum class Side : std::uint8_t { kLeft, kRight };
inline constexpr std::array<Side, 2> kSides = {Side::kLeft, Side::kRight};
[[nodiscard]] constexpr float sign_of(Side side) {
  return side == Side::kLeft ? 1.0F : -1.0F;
}
[[nodiscard]] constexpr std::size_t index_of(Side side) {
  return static_cast<std::size_t>(side);
}

enum class Bone : std::uint8_t {
  kPelvis,
  kChest,
  kHead,
  kLeftUpperArm,
  kRightUpperArm,
  kLeftForearm,
  kRightForearm,
  kLeftHand,
  kRightHand,
  kLeftThigh,
  kRightThigh,
  kLeftShin,
  kRightShin,
  kLeftFoot,
  kRightFoot,
};
inline constexpr std::size_t kBoneCount = 15;
[[nodiscard]] constexpr Bone on_side(Bone left, Side side) {
  return static_cast<Bone>(static_cast<std::uint8_t>(left) + static_cast<std::uint8_t>(side));
}

/// Bone lengths of a person.
struct Measures {
  float scale;  // scale of all lengths not listed here; 1: a person of 1.80 m
  float girth;
  float hip_half, thigh, shin;
  float ankle;     // height of the ankle above the sole
  float waist;     // from the hip line up to the bend of the back
  float shoulder;  // from the bend of the back up to the shoulders
  float shoulder_half;
  float neck;  // from the bend of the back up to the head's pivot
  float upper_arm, forearm;
  float palm;  // from the wrist to the centre of the palm

  [[nodiscard]] float leg() const { return thigh + shin; }
  [[nodiscard]] float hips_standing() const { return leg() + ankle; }
};
[[nodiscard]] Measures measures_of(const Build& build);

struct Pose {
  std::array<Eigen::Isometry3f, kBoneCount> world_from_bone;
  [[nodiscard]] const Eigen::Isometry3f& of(Bone bone) const {
    return world_from_bone[static_cast<std::size_t>(bone)];
  }
  Eigen::Isometry3f& of(Bone bone) { return world_from_bone[static_cast<std::size_t>(bone)]; }
};

/// Target of a hand.
struct HandGoal {
  Eigen::Vector3f wrist_m = Eigen::Vector3f::Zero();
  Eigen::Vector3f elbow_way = -Eigen::Vector3f::UnitZ();       // direction of the elbow
  Eigen::Quaternionf turned = Eigen::Quaternionf::Identity();  // wanted world_from_hand
  float turned_share = 0;  // weight of `turned`; 0: the hand continues the forearm
};

/// Targets of the pelvis, hands and feet in the world. Limbs stretch towards targets out of reach.
struct PoseGoals {
  Eigen::Isometry3f pelvis = Eigen::Isometry3f::Identity();
  Eigen::Quaternionf chest_in_pelvis = Eigen::Quaternionf::Identity();
  Eigen::Quaternionf head_in_chest = Eigen::Quaternionf::Identity();
  std::array<Eigen::Isometry3f, 2> feet;  // frames at the ankles
  std::array<HandGoal, 2> hands;
};

[[nodiscard]] Eigen::Isometry3f chest_on(const Eigen::Isometry3f& pelvis,
                                         const Eigen::Quaternionf& chest_in_pelvis,
                                         const Measures& measures);
[[nodiscard]] Eigen::Vector3f shoulder_of(const Eigen::Isometry3f& chest, Side side,
                                          const Measures& measures);
[[nodiscard]] Eigen::Vector3f hip_of(const Eigen::Isometry3f& pelvis, Side side,
                                     const Measures& measures);
/// Centre of a palm in the hand's frame; the palm faces the body's centre.
[[nodiscard]] Eigen::Vector3f palm_in_hand(Side side, const Measures& measures);

[[nodiscard]] Pose solve_pose(const PoseGoals& goals, const Measures& measures);

/// Legs straight and slightly apart, arms away from the body: the pose in which skins are modelled.
[[nodiscard]] Pose cutting_pose(const Measures& measures);

}  // namespace roomcast::simulator
