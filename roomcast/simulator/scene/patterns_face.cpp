// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "roomcast/simulator/random/value_noise.h"
#include "roomcast/simulator/scene/patterns.h"

namespace roomcast::simulator {
namespace {

using Eigen::Array2f;
using Eigen::Vector2f;
using Eigen::Vector3f;

/// 1 inside an ellipse, 0 outside, blurred over a share of its size.
float oval(const Vector2f& at, const Vector2f& middle, const Array2f& half_size, float blur) {
  const float away = ((at - middle).array() / half_size).matrix().norm();
  return std::clamp((1.0F - away) / blur + 0.5F, 0.0F, 1.0F);
}

}  // namespace

/// u: metres around the head from the nose, v: metres above the neck's joint. Base colour: skin,
/// accent: lips, trim: brows and eyes.
Vector3f face(const Surface& s, const Vector2f& at_m, float footprint_m) {
  const Vector2f mirrored(std::abs(at_m.x()), at_m.y());
  const float blur = 0.25F + footprint_m / 0.008F;
  Vector3f color = s.base * (1.0F + 0.08F * fractal_noise(at_m, 0.05F, 3, footprint_m, s.seed));
  color = mix(color, s.accent, 0.25F * oval(mirrored, {0.045F, 0.062F}, {0.024F, 0.018F}, 1.0F));
  color =
      mix(color, 0.55F * s.base, 0.5F * oval(mirrored, {0.031F, 0.100F}, {0.018F, 0.012F}, 0.8F));
  const float eye = oval(mirrored, {0.031F, 0.098F}, {0.0125F, 0.0062F}, blur);
  color = mix(color, Vector3f::Constant(0.62F), eye);
  color = mix(color, s.trim, eye * oval(mirrored, {0.0305F, 0.098F}, {0.0062F, 0.0066F}, blur));
  color = mix(color, 0.6F * s.trim, oval(mirrored, {0.031F, 0.1042F}, {0.0140F, 0.0022F}, blur));
  color = mix(color, s.trim, 0.9F * oval(mirrored, {0.032F, 0.1185F}, {0.0180F, 0.0038F}, blur));
  color =
      mix(color, 0.3F * s.base, 0.6F * oval(mirrored, {0.008F, 0.0545F}, {0.004F, 0.003F}, 0.7F));
  const float lips = oval(at_m, {0.0F, 0.0330F}, {0.0240F, 0.0075F}, blur);
  color = mix(color, s.accent, 0.85F * lips);
  return mix(color, 0.35F * s.accent, lips * oval(at_m, {0.0F, 0.0335F}, {0.022F, 0.0014F}, 0.8F));
}

}  // namespace roomcast::simulator
