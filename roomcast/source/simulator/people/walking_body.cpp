// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/people/walking_body.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "roomcast/core/assert.h"

namespace roomcast::sim {

using Eigen::Affine3f;
using Eigen::AngleAxisf;
using Eigen::Vector2f;
using Eigen::Vector3f;

namespace {

constexpr float kTurn = 2.0F * std::numbers::pi_v<float>;
constexpr float kThigh_m = 0.43F, kShin_m = 0.42F, kAnkle_m = 0.07F;
constexpr float kUpperArm_m = 0.28F, kForearm_m = 0.25F;
constexpr float kHipHalf_m = 0.085F, kShoulderHalf_m = 0.19F, kShoulderHeight_m = 0.475F;

float share_of(nanoseconds time, nanoseconds period) {
  const auto rest = ((time.count() % period.count()) + period.count()) % period.count();
  return static_cast<float>(static_cast<double>(rest) / static_cast<double>(period.count()));
}

/// Angles of one leg, radians, forward positive; `phase` 0: thigh upright and swinging forward.
struct Leg {
  float hip, knee, foot;  // foot: pitch in the world, toes down positive

  explicit Leg(float phase) {
    const float swinging = std::max(0.0F, std::cos(phase + 0.35F));
    const float pushing = std::max(0.0F, -std::sin(phase - 0.35F));
    hip = 0.10F + 0.40F * std::sin(phase);
    knee = 0.14F + 0.90F * swinging * swinging + 0.18F * pushing;
    foot = 0.55F * swinging * swinging + 0.60F * pushing * pushing * pushing -
           0.18F * std::max(0.0F, std::sin(phase));
  }
  [[nodiscard]] Vector2f ankle_below_hip() const {  // forward, up
    const float shin = hip - knee;
    return {kThigh_m * std::sin(hip) + kShin_m * std::sin(shin),
            -kThigh_m * std::cos(hip) - kShin_m * std::cos(shin)};
  }
  [[nodiscard]] float lowest_below_hip() const {
    const float toes = 0.17F * std::sin(std::max(0.0F, foot));
    const float heel = 0.07F * std::sin(std::max(0.0F, -foot));
    return ankle_below_hip().y() - kAnkle_m - toes - heel;
  }
};

AngleAxisf pitch(float forward_rad) {
  return {-forward_rad, Vector3f::UnitX()};
}

}  // namespace

/// Adds limbs to a body in frames hung on each other. Body frame: x to its left, y up, z ahead.
class BodyBuilder {
 public:
  explicit BodyBuilder(WalkingBody& body) : body_(body) {}

  /// From `from` to `to` in `frame`; the cross-section is stretched by `flat` along the frame's x
  /// and z.
  void limb(const Affine3f& frame, Garment garment, const Vector3f& from, const Vector3f& to,
            const Vector2f& radii_m, const Vector2f& flat = {1.0F, 1.0F}) {
    const Vector3f along = to - from;
    const Vector3f up = along.normalized();
    const Vector3f ahead_hint = std::abs(up.z()) < 0.9F ? Vector3f::UnitZ() : Vector3f::UnitY();
    const Vector3f side = up.cross(ahead_hint).normalized();
    Eigen::Matrix3f axes;
    axes << side * flat.x(), up, side.cross(up) * flat.y();
    ROOMCAST_ASSERT(body_.count_ < WalkingBody::kMaxParts);
    BodyPart& part = body_.parts_[static_cast<std::size_t>(body_.count_++)];
    part.shape = RoundCone(radii_m.x(), radii_m.y(), along.norm());
    Affine3f local = Affine3f::Identity();
    local.linear() = axes;
    local.translation() = from;
    part.world_from_local = frame * local;
    part.local_from_world = part.world_from_local.inverse();
    part.garment = garment;
  }

  void leg(const Affine3f& pelvis, float side, const Leg& leg) {
    const Affine3f hip = pelvis * Eigen::Translation3f(side * kHipHalf_m, 0, 0) * pitch(leg.hip);
    limb(hip, Garment::kTrousers, {0, 0.01F, 0}, {0, -kThigh_m, 0}, {0.088F, 0.060F});
    const Affine3f knee = hip * Eigen::Translation3f(0, -kThigh_m, 0) * pitch(-leg.knee);
    limb(knee, Garment::kTrousers, Vector3f::Zero(), {0, -0.17F, -0.012F}, {0.060F, 0.058F});
    limb(knee, Garment::kTrousers, {0, -0.17F, -0.012F}, {0, -kShin_m + 0.02F, 0},
         {0.058F, 0.047F});
    const Affine3f ankle =
        knee * Eigen::Translation3f(0, -kShin_m, 0) * pitch(-(leg.hip - leg.knee) - leg.foot);
    limb(ankle, Garment::kShoes, {0, -0.030F, -0.045F}, {0, -0.036F, 0.15F}, {0.040F, 0.034F},
         {1.05F, 1.0F});
    limb(ankle, Garment::kShoes, {0, 0.0F, -0.02F}, {0, -0.03F, 0.05F}, {0.042F, 0.038F});
  }

  void arm(const Affine3f& chest, float side, float swing) {
    const Affine3f shoulder = chest *
                              Eigen::Translation3f(side * kShoulderHalf_m, kShoulderHeight_m, 0) *
                              AngleAxisf(side * 0.10F, Vector3f::UnitZ()) * pitch(swing);
    limb(shoulder, Garment::kShirt, Vector3f::Zero(), {0, -kUpperArm_m, 0}, {0.060F, 0.046F});
    const float bend = 0.38F + 0.35F * std::max(0.0F, swing);
    const Affine3f elbow = shoulder * Eigen::Translation3f(0, -kUpperArm_m, 0) * pitch(bend);
    limb(elbow, Garment::kShirt, Vector3f::Zero(), {0, -0.20F, 0}, {0.046F, 0.038F});
    limb(elbow, Garment::kSkin, {0, -0.18F, 0}, {0, -kForearm_m, 0}, {0.031F, 0.028F});
    limb(elbow, Garment::kSkin, {0, -kForearm_m - 0.02F, 0}, {0, -kForearm_m - 0.10F, 0.012F},
         {0.038F, 0.027F}, {0.55F, 1.0F});
    limb(elbow, Garment::kSkin, {0, -kForearm_m - 0.02F, 0.02F}, {0, -kForearm_m - 0.065F, 0.05F},
         {0.016F, 0.012F});
  }

  void trunk(const Affine3f& pelvis, const Affine3f& chest) {
    limb(pelvis, Garment::kTrousers, {0, -0.02F, 0}, {0, 0.09F, 0}, {0.150F, 0.140F},
         {1.10F, 0.80F});
    limb(chest, Garment::kShirt, {0, 0.03F, 0}, {0, 0.14F, 0}, {0.152F, 0.145F}, {1.08F, 0.80F});
    limb(chest, Garment::kShirt, {0, 0.12F, 0}, {0, 0.36F, 0.01F}, {0.143F, 0.155F},
         {1.08F, 0.74F});
    for (const float side : {-1.0F, 1.0F}) {
      limb(chest, Garment::kShirt, {side * 0.05F, 0.49F, -0.01F},
           {side * kShoulderHalf_m, kShoulderHeight_m, 0}, {0.072F, 0.064F});
    }
    limb(chest, Garment::kShirt, {0, 0.50F, -0.01F}, {0, 0.54F, 0}, {0.070F, 0.060F});
    limb(chest, Garment::kSkin, {0, 0.52F, 0}, {0, 0.62F, 0.02F}, {0.052F, 0.050F});
  }

  void head(const Affine3f& neck) {
    limb(neck, Garment::kFace, {0, 0.035F, 0.030F}, {0, 0.125F, 0.012F}, {0.066F, 0.090F},
         {0.94F, 1.05F});
    limb(neck, Garment::kSkin, {0, 0.075F, 0.100F}, {0, 0.045F, 0.115F}, {0.009F, 0.014F});  // nose
    limb(neck, Garment::kHair, {0, 0.090F, -0.030F}, {0, 0.145F, -0.006F}, {0.078F, 0.094F},
         {1.0F, 1.05F});
    for (const float side : {-1.0F, 1.0F}) {
      limb(neck, Garment::kSkin, {side * 0.084F, 0.060F, 0.005F}, {side * 0.088F, 0.085F, 0.0F},
           {0.012F, 0.016F}, {0.6F, 1.0F});
    }
  }

 private:
  WalkingBody& body_;
};

WalkingBody WalkingBody::at(const Walk& walk, nanoseconds scene_time) {
  const float lap = kTurn * share_of(scene_time, walk.lap);
  const float phase = kTurn * share_of(scene_time * walk.strides_per_lap, walk.lap);
  WalkingBody body;
  body.floor_point_m_ = {walk.centre_m.x() + walk.radii_m.x() * std::cos(lap), 0,
                         walk.centre_m.y() + walk.radii_m.y() * std::sin(lap)};
  const float heading =
      std::atan2(-walk.radii_m.x() * std::sin(lap), walk.radii_m.y() * std::cos(lap));

  const Leg left(phase);
  const Leg right(phase + 0.5F * kTurn);
  const float height = -std::min(left.lowest_below_hip(), right.lowest_below_hip());
  const Affine3f pelvis = Eigen::Translation3f(body.floor_point_m_ + Vector3f(0, height, 0)) *
                          AngleAxisf(heading, Vector3f::UnitY()) *
                          Affine3f(AngleAxisf(0.10F * std::sin(phase), Vector3f::UnitY()));
  const Affine3f chest = pelvis * Eigen::Translation3f(0, 0.06F, 0) *
                         AngleAxisf(-0.22F * std::sin(phase), Vector3f::UnitY()) * pitch(-0.05F);
  const Affine3f neck =
      chest * Eigen::Translation3f(0, 0.60F, 0.015F) *
      AngleAxisf(0.10F * std::sin(phase) - 0.3F * std::sin(2.0F * lap), Vector3f::UnitY());
  BodyBuilder builder(body);
  builder.trunk(pelvis, chest);
  builder.head(neck);
  builder.leg(pelvis, 1.0F, left);
  builder.leg(pelvis, -1.0F, right);
  builder.arm(chest, 1.0F, -0.42F * std::sin(phase));
  builder.arm(chest, -1.0F, 0.42F * std::sin(phase));
  return body;
}

const Surface& worn(const Clothes& clothes, Garment garment) {
  switch (garment) {
    case Garment::kShirt:
      return clothes.shirt;
    case Garment::kTrousers:
      return clothes.trousers;
    case Garment::kShoes:
      return clothes.shoes;
    case Garment::kSkin:
      return clothes.skin;
    case Garment::kHair:
      return clothes.hair;
    case Garment::kFace:
      return clothes.face;
  }
  return clothes.skin;
}

Vector2f cloth_point(const BodyPart& part, const Vector3f& local) {
  const float radius = 0.5F * (part.shape.first_radius() + part.shape.second_radius());
  return {radius * std::atan2(local.x(), local.z()), local.y()};
}

}  // namespace roomcast::sim
