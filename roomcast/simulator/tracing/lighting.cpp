// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/tracing/lighting.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "roomcast/simulator/random/value_noise.h"

namespace roomcast::simulator {
namespace {

using Eigen::Vector3f;

constexpr int kOpennessRays = 20;
constexpr float kOpennessReach_m = 1.0F;
constexpr float kGoldenAngle = 2.39996323F;

/// Two unit vectors that make a right-handed frame with `normal`.
struct Tangents {
  Vector3f first, second;
};

Tangents tangents_of(const Vector3f& normal) {
  const Vector3f helper = std::abs(normal.y()) < 0.9F ? Vector3f::UnitY() : Vector3f::UnitX();
  const Vector3f first = normal.cross(helper).normalized();
  return {first, normal.cross(first)};
}

/// Golden-angle spiral on the unit disc; every prefix of it covers the disc.
Eigen::Vector2f spiral_point(int number, float turn) {
  const float radius = std::sqrt(std::fmod(0.1F + 0.618034F * static_cast<float>(number), 1.0F));
  const float angle = kGoldenAngle * static_cast<float>(number) + turn;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace

Vector3f light_from(const Light& light, const LitPoint& at) {
  constexpr float kSoftening_m2 = 0.15F;
  const Vector3f way = light.position_m - at.position_m;
  const float squared = way.squaredNorm();
  const Vector3f towards = way / std::sqrt(squared);
  const float cosine = at.normal.dot(towards);
  if (cosine <= 0.0F) return Vector3f::Zero();
  const bool one_sided = !light.facing.isZero();
  const float sent = one_sided ? std::max(0.0F, -light.facing.dot(towards)) : 1.0F;
  return light.power * (cosine * sent / (squared + kSoftening_m2));
}

Vector3f ambient_light(const Room& room, const LitPoint& at, float openness) {
  const float from_above = 0.80F + 0.20F * at.normal.y();
  return room.ambient * (from_above * (0.18F + 0.82F * openness));
}

float share_of_lamp_seen(const RayScene& scene, const Light& light, const LitPoint& at,
                         int ray_count, std::uint32_t dither) {
  constexpr int kFirstRays = 4;
  const Vector3f lifted = at.position_m + 0.003F * at.normal;
  // A window's area is in its own plane; a bulb appears as a disc from every direction.
  const Vector3f axis = light.facing.isZero() ? Vector3f(light.position_m - lifted) : light.facing;
  const Tangents disc = tangents_of(axis.normalized());
  const float turn = 2.0F * std::numbers::pi_v<float> * unit_from_hash(mix_bits(dither));
  int seen = 0;
  for (int i = 0; i < ray_count; ++i) {
    if (i == kFirstRays && (seen == 0 || seen == kFirstRays)) return seen == 0 ? 0.0F : 1.0F;
    const Eigen::Vector2f place = light.radius_m * spiral_point(i, turn);
    const Vector3f target = light.position_m + place.x() * disc.first + place.y() * disc.second;
    if (!scene.blocked(lifted, target)) ++seen;
  }
  return static_cast<float>(seen) / static_cast<float>(ray_count);
}

Vector3f cosine_direction(const Vector3f& normal, int number, int count) {
  const Tangents tangents = tangents_of(normal);
  const float squared = (static_cast<float>(number) + 0.5F) / static_cast<float>(count);
  const float angle = kGoldenAngle * static_cast<float>(number);
  return std::sqrt(1.0F - squared) * normal +
         std::sqrt(squared) *
             (std::cos(angle) * tangents.first + std::sin(angle) * tangents.second);
}

float openness_at(const RayScene& scene, const LitPoint& at) {
  const Vector3f lifted = at.position_m + 0.004F * at.normal;
  int open = 0;
  for (int i = 0; i < kOpennessRays; ++i) {
    const Vector3f direction = cosine_direction(at.normal, i, kOpennessRays);
    if (!scene.blocked(lifted, lifted + kOpennessReach_m * direction)) ++open;
  }
  return static_cast<float>(open) / static_cast<float>(kOpennessRays);
}

Vector3f light_leaving(const Surface& surface, const Vector3f& albedo, const Vector3f& arriving) {
  return (1.0F - surface.glow) * albedo.cwiseProduct(arriving) + surface.glow * albedo;
}

}  // namespace roomcast::simulator
