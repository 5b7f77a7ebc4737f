// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/lighting.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "roomcast/source/simulator/value_noise.h"

namespace roomcast::sim {
namespace {

using Eigen::Vector3f;

constexpr int kOpennessRays = 24;
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

Vector3f point_of_lamp(const Light& light, std::uint32_t dither) {
  const float height = 2.0F * unit_from_hash(mix_bits(dither)) - 1.0F;
  const float turn = 2.0F * std::numbers::pi_v<float> * unit_from_hash(mix_bits(dither + 1U));
  const float ring = std::sqrt(std::max(0.0F, 1.0F - height * height));
  return light.position_m +
         light.radius_m * Vector3f(ring * std::cos(turn), height, ring * std::sin(turn));
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

Vector3f shadowed_light(const Room& room, const RayScene& scene, const LitPoint& at, std::uint32_t dither) {
  Vector3f sum = Vector3f::Zero();
  const Vector3f lifted = at.position_m + 0.003F * at.normal;
  for (std::size_t i = 0; i < room.lights.size(); ++i) {
    const Vector3f arriving = light_from(room.lights[i], at);
    if (arriving.maxCoeff() < 0.004F) continue;
    const auto lamp_dither = dither + 16U * static_cast<std::uint32_t>(i);
    if (!scene.blocked(lifted, point_of_lamp(room.lights[i], lamp_dither))) sum += arriving;
  }
  return sum;
}

float openness_at(const RayScene& scene, const LitPoint& at) {
  const Tangents tangents = tangents_of(at.normal);
  const Vector3f lifted = at.position_m + 0.004F * at.normal;
  int open = 0;
  for (int i = 0; i < kOpennessRays; ++i) {
    const float squared = (static_cast<float>(i) + 0.5F) / static_cast<float>(kOpennessRays);
    const float angle = kGoldenAngle * static_cast<float>(i);
    const Vector3f direction = std::sqrt(1.0F - squared) * at.normal +
                               std::sqrt(squared) * (std::cos(angle) * tangents.first +
                                                     std::sin(angle) * tangents.second);
    if (!scene.blocked(lifted, lifted + kOpennessReach_m * direction)) ++open;
  }
  return static_cast<float>(open) / static_cast<float>(kOpennessRays);
}

Vector3f light_leaving(const Surface& surface, const Vector3f& albedo, const Vector3f& arriving) {
  return (1.0F - surface.glow) * albedo.cwiseProduct(arriving) + surface.glow * albedo;
}

}  // namespace roomcast::sim
