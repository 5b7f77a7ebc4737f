// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/sensing/sensor_noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "roomcast/source/simulator/scene/value_noise.h"

namespace roomcast::sim {
namespace {

constexpr float kNearest_m = 0.5F, kFarthest_m = 8.0F;
constexpr float kGrazing = 0.1219F;                          // cos 83 degrees
constexpr float kSlantest = 0.3090F;                         // cos 72 degrees
constexpr float kNoSignal = 0.0020F, kSafeSignal = 0.0060F;  // amplitudes
constexpr float kLostAtStep = 0.25F, kMixedAtStep = 0.25F;   // shares of readings
constexpr float kColorSigma = 1.1F;                          // grey levels

float amplitude(const PerfectReading& reading) {
  return reading.infrared * reading.facing / std::max(reading.z_m * reading.z_m, 1e-6F);
}

/// The neighbour of pixel (x, y) that is farthest away from it in depth, across a step; its own
/// depth without one.
float depth_beside(const Image<float>& z_m, int x, int y) {
  const float here = z_m.at(x, y);
  float beside = here;
  const auto consider = [&](int nx, int ny) {
    if (nx < 0 || ny < 0 || nx >= z_m.width() || ny >= z_m.height()) return;
    const float there = z_m.at(nx, ny);
    if (is_depth_step(here, there) && std::abs(there - here) > std::abs(beside - here))
      beside = there;
  };
  consider(x - 1, y);
  consider(x + 1, y);
  consider(x, y - 1);
  consider(x, y + 1);
  return beside;
}

}  // namespace

float axial_sigma_mm(const PerfectReading& reading) {
  const float z = reading.z_m;
  const float theta = std::acos(std::clamp(reading.facing, kSlantest, 1.0F));
  const float slant = theta / (0.5F * std::numbers::pi_v<float> - theta);
  const float fankhauser = 1.5F - 0.5F * z + 0.3F * z * z + 0.1F * z * std::sqrt(z) * slant * slant;
  const float weak = std::clamp(0.05F / std::max(amplitude(reading), 1e-6F), 0.0F, 50.0F);
  return fankhauser * (0.75F + 0.25F * std::sqrt(weak));
}

float dropout_probability(const PerfectReading& reading) {
  if (reading.z_m < kNearest_m || reading.z_m > kFarthest_m || reading.facing < kGrazing)
    return 1.0F;
  const float lacking = (kSafeSignal - amplitude(reading)) / (kSafeSignal - kNoSignal);
  return std::clamp(lacking, 0.0F, 1.0F);
}

bool is_depth_step(float a_m, float b_m) {
  return std::abs(a_m - b_m) > 0.02F + 0.03F * std::min(a_m, b_m);
}

GaussianTable::GaussianTable(std::uint32_t seed) : values_(kSize + kLongestRun) {
  for (std::size_t i = 0; i < values_.size(); ++i) {  // Box and Muller 1958
    const auto hash = hash_of(seed, static_cast<std::uint32_t>(i));
    const float radius = std::sqrt(-2.0F * std::log(1.0F - unit_from_hash(hash)));
    values_[i] = radius * std::cos(2.0F * std::numbers::pi_v<float> * nth_unit(hash, 1U));
  }
}

DepthNoise::DepthNoise(const DepthPlate& plate, const GaussianTable& gaussians)
    : gaussians_(gaussians),
      mean_mm_(plate.z_m.width(), plate.z_m.height()),
      sigma_mm_(plate.z_m.width(), plate.z_m.height()) {
  for (int y = 0; y < mean_mm_.height(); ++y) {
    for (int x = 0; x < mean_mm_.width(); ++x) {
      const PerfectReading reading{plate.z_m.at(x, y), plate.facing.at(x, y),
                                   plate.infrared.at(x, y), depth_beside(plate.z_m, x, y)};
      const float dropout = dropout_probability(reading);
      if (dropout >= 1.0F) continue;
      mean_mm_.at(x, y) = 1000.0F * reading.z_m;
      sigma_mm_.at(x, y) = axial_sigma_mm(reading);
      const float beside_mm = 1000.0F * (reading.beside_m - reading.z_m);
      if (dropout == 0.0F && beside_mm == 0.0F) continue;
      uncertain_.push_back(
          {static_cast<std::uint32_t>(y * mean_mm_.width() + x), dropout, beside_mm});
    }
  }
}

void DepthNoise::read_plate(std::uint32_t key, ImageView<std::uint16_t> out) const {
  const int width = out.width;
  for (int y = 0; y < out.height; ++y) {
    const float* noise = gaussians_.run(hash_of(key, static_cast<std::uint32_t>(y)));
    const float* mean = mean_mm_.view().row(y);
    const float* sigma = sigma_mm_.view().row(y);
    std::uint16_t* row = out.row(y);
    for (int x = 0; x < width; ++x) {
      const float half = mean[x] > 0.0F ? 0.5F : 0.0F;
      row[x] = static_cast<std::uint16_t>(static_cast<int>(mean[x] + sigma[x] * noise[x] + half));
    }
  }
  for (const Uncertain& at : uncertain_) {
    std::uint16_t& value = out.data[at.pixel];
    value = disturbed(value, at, key);
  }
}

std::uint16_t DepthNoise::disturbed(std::uint16_t value_mm, const Uncertain& at,
                                    std::uint32_t key) const {
  const auto hash = hash_of(key ^ 0x5bd1e995U, at.pixel);
  if (unit_from_hash(hash) < at.dropout) return 0;
  if (at.beside_mm == 0.0F) return value_mm;
  const float fate = nth_unit(hash, 1U);
  if (fate < kLostAtStep) return 0;
  if (fate >= kLostAtStep + kMixedAtStep) return value_mm;
  const float share = nth_unit(hash, 2U);
  return static_cast<std::uint16_t>(static_cast<float>(value_mm) + share * at.beside_mm);
}

std::uint16_t DepthNoise::read(const PerfectReading& reading, std::uint32_t key,
                               std::uint32_t pixel) const {
  const Uncertain at{pixel, dropout_probability(reading),
                     1000.0F * (reading.beside_m - reading.z_m)};
  if (at.dropout >= 1.0F) return 0;
  const float gaussian = gaussians_.one(hash_of(key + 1U, pixel));
  const float value = 1000.0F * reading.z_m + axial_sigma_mm(reading) * gaussian + 0.5F;
  return disturbed(static_cast<std::uint16_t>(value), at, key);
}

void add_color_noise(std::uint32_t key, const GaussianTable& gaussians, ImageView<Rgb8> picture) {
  static_assert(sizeof(Rgb8) == 3);
  for (int y = 0; y < picture.height; ++y) {
    const float* noise = gaussians.run(hash_of(key ^ 0xc2b2ae35U, static_cast<std::uint32_t>(y)));
    auto* channel = reinterpret_cast<std::uint8_t*>(picture.row(y));
    const int count = 3 * picture.width;
    for (int i = 0; i < count; ++i) {
      const int noisy =
          static_cast<int>(static_cast<float>(channel[i]) + kColorSigma * noise[i] + 0.5F);
      channel[i] = static_cast<std::uint8_t>(std::clamp(noisy, 0, 255));
    }
  }
}

}  // namespace roomcast::sim
