// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/axial_noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace roomcast::simulator {
namespace {

constexpr float kRightAngle = 0.5F * std::numbers::pi_v<float>;
constexpr float kSlantest = 72.0F / 90.0F * kRightAngle;

/// The additional error at oblique incidence.
float slant_sigma_mm(float z_m, float theta) {
  const float bounded = std::clamp(theta, 0.0F, kSlantest);
  const float slant = bounded / (kRightAngle - bounded);
  return 0.1F * z_m * std::sqrt(z_m) * slant * slant;
}

float kinect2_facing_sigma_mm(float z_m) {
  return 1.5F - 0.5F * z_m + 0.3F * z_m * z_m;
}

}  // namespace

float kinect2_sigma_mm(float z_m, float theta) {
  return kinect2_facing_sigma_mm(z_m) + slant_sigma_mm(z_m, theta);
}

float azure_sigma_mm(float z_m, float theta) {
  constexpr float kAlike_m = 2.5F;
  constexpr float kSlopeThere = -0.5F + 2.0F * 0.3F * kAlike_m;
  const float beyond = std::max(0.0F, z_m - kAlike_m);
  const float facing = kinect2_facing_sigma_mm(std::min(z_m, kAlike_m)) + kSlopeThere * beyond;
  return facing + slant_sigma_mm(z_m, theta);
}

float stereo_sigma_mm(float z_m, float focal_px, float baseline_mm, float subpixel) {
  const float z_mm = 1000.0F * z_m;
  return z_mm * z_mm * subpixel / (focal_px * baseline_mm);
}

}  // namespace roomcast::simulator
