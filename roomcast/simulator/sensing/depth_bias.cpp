// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/depth_bias.h"

#include <cmath>
#include <numbers>

#include "roomcast/simulator/random/value_noise.h"

namespace roomcast::simulator {
namespace {

constexpr float kTurn = 2.0F * std::numbers::pi_v<float>;
/// A quarter of half the modulation wavelength at 80 MHz, one of the Kinect v2's frequencies.
constexpr float kWiggleLength_m = 0.468F;

float signed_unit(std::uint32_t key, std::uint32_t trait) {
  return 2.0F * nth_unit(key, trait) - 1.0F;
}

/// Smooth error over the picture, about two waves across.
Image<float> wave_over_picture(int width, int height, float amplitude, std::uint32_t key) {
  Image<float> wave(width, height);
  const float scale = 2.0F / static_cast<float>(width);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Eigen::Vector2f at(static_cast<float>(x) * scale, static_cast<float>(y) * scale);
      wave.at(x, y) = amplitude * value_noise(at, key);
    }
  }
  return wave;
}

}  // namespace

DepthBias::DepthBias(const SensorProfile& profile, std::uint32_t unit_key) {
  const bool stereo = measures_disparity(profile.principle);
  const CameraIntrinsics& lens = profile.nominal.depth;
  wave_ = wave_over_picture(lens.width, lens.height,
                            stereo ? profile.bias_disparity_px : profile.bias_wave_mm,
                            hash_of(unit_key, 1));
  if (stereo) {
    stereo_mm_ = 1e6F / (static_cast<float>(lens.fx) * profile.baseline_mm);
    return;
  }
  offset_mm_ = profile.bias_offset_mm * signed_unit(unit_key, 2);
  wiggle_mm_ = profile.bias_wiggle_mm;
  wiggle_phase_ = kTurn * nth_unit(unit_key, 3);
}

float DepthBias::wiggle_mm(float z_m) const {
  return wiggle_mm_ * std::sin(kTurn / kWiggleLength_m * z_m + wiggle_phase_);
}

}  // namespace roomcast::simulator
