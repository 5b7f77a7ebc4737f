// SPDX-License-Identifier: Apache-2.0
// A person walking round an ellipse: where every limb is at an instant. Hips, knees, ankles,
// shoulders and elbows follow sines of the gait's phase; the pelvis is as high as lets the lower
// foot touch the floor. The gait repeats with the lap, so the body is a function of the scene time
// alone. World frame of room.h.
#pragma once

#include <array>
#include <span>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "roomcast/core/clock.h"
#include "roomcast/source/simulator/people/round_cone.h"
#include "roomcast/source/simulator/scene/room.h"

namespace roomcast::sim {

enum class Garment : std::uint8_t { kShirt, kTrousers, kShoes, kSkin, kHair, kFace };
inline constexpr int kGarmentCount = 6;

struct BodyPart {
  RoundCone shape;
  Eigen::Affine3f world_from_local;  // may flatten, never mirror
  Eigen::Affine3f local_from_world;
  Garment garment = Garment::kSkin;
};

class WalkingBody {
 public:
  static constexpr int kMaxParts = 32;

  [[nodiscard]] std::span<const BodyPart> parts() const {
    return {parts_.data(), static_cast<std::size_t>(count_)};
  }
  /// The point of the floor under the pelvis.
  [[nodiscard]] const Eigen::Vector3f& floor_point_m() const { return floor_point_m_; }

  /// The body at a scene time (any sign).
  static WalkingBody at(const Walk& walk, nanoseconds scene_time);

 private:
  friend class BodyBuilder;
  std::array<BodyPart, kMaxParts> parts_;
  int count_ = 0;
  Eigen::Vector3f floor_point_m_ = Eigen::Vector3f::Zero();
};

[[nodiscard]] const Surface& worn(const Clothes& clothes, Garment garment);

/// Where a point of a part (in its local frame) lies on the cloth, in metres: round the limb from
/// the front, along it.
[[nodiscard]] Eigen::Vector2f cloth_point(const BodyPart& part, const Eigen::Vector3f& local);

}  // namespace roomcast::sim
