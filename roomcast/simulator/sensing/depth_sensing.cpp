// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/depth_sensing.h"

#include <algorithm>
#include <cmath>

#include "roomcast/simulator/random/value_noise.h"

namespace roomcast::simulator {
namespace {

constexpr float kGrazing = 0.1219F;  // cos 83 degrees
constexpr float kMaxAmplitudeNoise_mm = 80.0F;
constexpr std::uint32_t kFate = 0x5bd1e995U;

std::uint16_t to_mm(float value_mm) {
  return static_cast<std::uint16_t>(std::clamp(value_mm + 0.5F, 0.0F, 65535.0F));
}

/// Approximately Gaussian, -2..2, standard deviation 1 (Irwin-Hall of three).
float gaussian(std::uint32_t hash) {
  return 2.0F * (nth_unit(hash, 1) + nth_unit(hash, 2) + nth_unit(hash, 3) - 1.5F);
}

}  // namespace

std::uint16_t ExpectedReading::rounded_mm() const {
  return mean_mm > 0.0F ? to_mm(mean_mm) : std::uint16_t{0};
}

float DepthSensing::sigma_mm(const DepthReading& reading) const {
  const float theta = std::acos(std::clamp(reading.facing, 0.0F, 1.0F));
  const float axial = profile_.axial_sigma_mm(reading.z_m, theta);
  if (measures_disparity(profile_.principle)) return axial;
  const float darkness = kReferenceReflectance / std::max(reading.infrared, 1e-3F);
  const float shot = axial * std::clamp(std::sqrt(darkness), 0.7F, 4.0F);
  if (profile_.amplitude_noise_mm == 0.0F) return shot;
  const float strength = signal_strength(reading.infrared, reading.facing, reading.z_m);
  return std::hypot(shot, std::min(profile_.amplitude_noise_mm / std::max(strength, 1e-6F),
                                   kMaxAmplitudeNoise_mm));
}

float DepthSensing::dropout_probability(const DepthReading& reading) const {
  const bool in_range = reading.z_m >= profile_.nearest_m && reading.z_m <= profile_.farthest_m;
  if (!in_range || reading.facing < kGrazing) return 1.0F;
  const float strength = signal_strength(reading.infrared, reading.facing, reading.z_m);
  if (profile_.saturating_signal > 0.0F && strength > profile_.saturating_signal) return 1.0F;
  const float lacking =
      (profile_.safe_signal - strength) / (profile_.safe_signal - profile_.lost_signal);
  return std::clamp(lacking, 0.0F, 1.0F);
}

ExpectedReading DepthSensing::expect(const DepthReading& reading, int x, int y) const {
  ExpectedReading expected;
  expected.dropout = dropout_probability(reading);
  if (expected.dropout >= 1.0F) return expected;
  expected.mean_mm = 1000.0F * (reading.z_m + reading.detour_m) + bias_.at(x, y, reading.z_m);
  expected.sigma_mm = sigma_mm(reading);
  expected.other = reading.other;
  const float pixel_mm = 1000.0F * reading.z_m / static_cast<float>(profile_.nominal.depth.fx);
  expected.lateral_px = profile_.lateral_sigma_mm / pixel_mm;
  return expected;
}

std::optional<float> DepthSensing::seen_at_edge(const ExpectedReading& expected,
                                                std::uint32_t hash) const {
  const OtherSurface& other = expected.other;
  const float other_mm = 1000.0F * other.z_m;
  const float share = other.share + expected.lateral_px * gaussian(hash);
  if (share <= 0.0F) return expected.mean_mm;
  if (share >= 1.0F) return other_mm;
  if (nth_unit(hash, 4) < profile_.lost_at_edge) return std::nullopt;
  if (measures_disparity(profile_.principle)) {
    return share < 0.5F ? expected.mean_mm : other_mm;
  }
  const float light = share * other.strength;
  return (light * other_mm + (1.0F - share) * expected.mean_mm) / (light + 1.0F - share);
}

std::uint16_t DepthSensing::read(const ExpectedReading& expected, int x, int y,
                                 const FrameNoise& noise) const {
  if (expected.mean_mm <= 0.0F) return 0;
  const float unit = noise.unit.at(x, y);
  const float factor = noise.burst ? noise.burst->sigma_factor() : 1.0F;
  const float ripple_mm = noise.burst ? noise.burst->ripple_mm(x, y) : 0.0F;
  float seen_mm = expected.mean_mm;
  if (!expected.is_plain()) {
    const auto pixel = static_cast<std::uint32_t>(y * noise.unit.width() + x);
    const auto hash = hash_of(noise.key ^ kFate, pixel);
    if (unit_from_hash(hash) < expected.dropout) return 0;
    if (expected.other.share > 0.0F) {
      const auto seen = seen_at_edge(expected, hash);
      if (!seen) return 0;
      seen_mm = *seen;
    }
  }
  return to_mm(seen_mm + factor * expected.sigma_mm * unit + ripple_mm);
}

StillDepth::StillDepth(ImageView<const ExpectedReading> expected)
    : mean_mm_(expected.width, expected.height), sigma_mm_(expected.width, expected.height) {
  for (int y = 0; y < expected.height; ++y) {
    for (int x = 0; x < expected.width; ++x) {
      const ExpectedReading& at = expected.at(x, y);
      mean_mm_.at(x, y) = at.mean_mm;
      sigma_mm_.at(x, y) = at.sigma_mm;
      if (at.mean_mm > 0.0F && !at.is_plain()) uncertain_.push_back({x, y, at});
    }
  }
}

void StillDepth::expect(ImageView<std::uint16_t> out) const {
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      const float mean = mean_mm_.at(x, y);
      out.at(x, y) = mean > 0.0F ? to_mm(mean) : std::uint16_t{0};
    }
  }
}

void StillDepth::read(const DepthSensing& sensing, const FrameNoise& noise,
                      ImageView<std::uint16_t> out) const {
  const float factor = noise.burst ? noise.burst->sigma_factor() : 1.0F;
  for (int y = 0; y < out.height; ++y) {
    const float* mean = mean_mm_.view().row(y);
    const float* sigma = sigma_mm_.view().row(y);
    const float* unit = noise.unit.view().row(y);
    std::uint16_t* row = out.row(y);
    for (int x = 0; x < out.width; ++x) {
      const float ripple_mm = noise.burst ? noise.burst->ripple_mm(x, y) : 0.0F;
      const float value = mean[x] + factor * sigma[x] * unit[x] + ripple_mm;
      row[x] = mean[x] > 0.0F ? to_mm(value) : std::uint16_t{0};
    }
  }
  for (const Uncertain& at : uncertain_) {
    out.at(at.x, at.y) = sensing.read(at.expected, at.x, at.y, noise);
  }
}

}  // namespace roomcast::simulator
