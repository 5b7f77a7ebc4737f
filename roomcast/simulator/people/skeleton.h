// SPDX-License-Identifier: Apache-2.0
// Bones: how long they are, and where each lies when a body's joints are told where to be. A bone's
// frame has its origin in the joint nearer to the pelvis; x to the body's left, y up, z ahead as
// the bone is while standing at attention, arms hanging: limbs run along -y. Metres, radians.
// Two-bone limbs are bent in closed form (law of cosines), so every length is kept exactly.
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

/// Lengths of somebody's bones.
struct Measures {
  float scale;  // of everything that is not named here; 1: a person of 1.80 m
  float girth;
  float hip_half, thigh, shin;
  float ankle;     // height of the ankle above the sole
  float waist;     // from the line of the hips up to where the back bends
  float shoulder;  // from there up to the shoulders
  float shoulder_half;
  float neck;  // from where the back bends up to where the head turns
  float upper_arm, forearm;
  float palm;  // from the wrist to the middle of the palm

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

/// Where a hand is wanted.
struct HandGoal {
  Eigen::Vector3f wrist_m = Eigen::Vector3f::Zero();
  Eigen::Vector3f elbow_way = -Eigen::Vector3f::UnitZ();       // which way the elbow points
  Eigen::Quaternionf turned = Eigen::Quaternionf::Identity();  // world_from_hand wanted ...
  float turned_share = 0;  // ... by this share; 0: straight on from the forearm
};

/// Where a body's ends are wanted, in the world. What is out of reach is reached for.
struct PoseGoals {
  Eigen::Isometry3f pelvis = Eigen::Isometry3f::Identity();
  Eigen::Quaternionf chest_in_pelvis = Eigen::Quaternionf::Identity();
  Eigen::Quaternionf head_in_chest = Eigen::Quaternionf::Identity();
  std::array<Eigen::Isometry3f, 2> feet;  // frames of the ankles
  std::array<HandGoal, 2> hands;
};

[[nodiscard]] Eigen::Isometry3f chest_on(const Eigen::Isometry3f& pelvis,
                                         const Eigen::Quaternionf& chest_in_pelvis,
                                         const Measures& measures);
[[nodiscard]] Eigen::Vector3f shoulder_of(const Eigen::Isometry3f& chest, Side side,
                                          const Measures& measures);
[[nodiscard]] Eigen::Vector3f hip_of(const Eigen::Isometry3f& pelvis, Side side,
                                     const Measures& measures);
/// The middle of a palm in the hand's frame; the palm faces the body's middle.
[[nodiscard]] Eigen::Vector3f palm_in_hand(Side side, const Measures& measures);

[[nodiscard]] Pose solve_pose(const PoseGoals& goals, const Measures& measures);

/// Legs straight and a little apart, arms hanging away from the body: where skins are cut.
[[nodiscard]] Pose cutting_pose(const Measures& measures);

}  // namespace roomcast::simulator
