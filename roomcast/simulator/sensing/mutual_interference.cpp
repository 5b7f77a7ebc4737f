// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/mutual_interference.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "roomcast/simulator/random/value_noise.h"
#include "roomcast/simulator/sensing/pulse_overlap.h"

namespace roomcast::simulator {
namespace {

constexpr std::uint32_t kPatches = 91, kFlicker = 92, kDisturbance = 93, kLoss = 94;

// Structured light. Windows are lost up to this quantile of their quality where foreign light
// prevails; from frame to frame the quality varies by kFlickerRange.
constexpr float kPatternPatch_px = 7.0F;
constexpr float kLostQuality = 0.42F, kFlickerRange = 0.22F;
constexpr float kPatternNoise = 1.0F;  // times the sensor's own, where foreign light prevails

// Time of flight, for foreign light as strong as the own during the whole exposure.
constexpr float kPhaseNoise = 5.0F;  // times the sensor's own
constexpr float kContradictionBegins = 0.15F, kContradictionRange = 1.5F;

double seconds_of(nanoseconds time) {
  return std::chrono::duration<double>(time).count();
}

std::uint16_t disturbed(std::uint16_t reading_mm, float error_mm) {
  return static_cast<std::uint16_t>(
      std::clamp(static_cast<float>(reading_mm) + error_mm + 0.5F, 1.0F, 65535.0F));
}

/// 0 to 1.
float unit_noise_at(float x, float y, std::uint32_t key) {
  return 0.5F + 0.5F * value_noise({x / kPatternPatch_px, y / kPatternPatch_px}, key);
}

}  // namespace

bool disturbs(DepthPrinciple emitting, DepthPrinciple sensing) {
  return emitting == sensing && sensing != DepthPrinciple::kStereo;
}

MutualInterference::MutualInterference(const SensorProfile& profile, std::uint32_t unit_key,
                                       std::vector<Other> others)
    : profile_(profile), key_(unit_key), others_(std::move(others)) {}

std::vector<MutualInterference::Active> MutualInterference::active_at(
    nanoseconds scene_time) const {
  std::vector<Active> active;
  for (const Other& other : others_) {
    const double first_s = seconds_of(other.clock.true_time(0));
    const double period_s = seconds_of(other.clock.true_time(1)) - first_s;
    const double share = profile_.principle == DepthPrinciple::kTimeOfFlight
                             ? pulse_overlap(seconds_of(scene_time) - first_s, period_s)
                             : 1.0;
    if (share > 0) active.push_back({&other.light, static_cast<float>(share)});
  }
  return active;
}

/// The probability that a pixel has no reading; of structured light 0 or 1, patch by patch.
float MutualInterference::lost_share(float light, float x, float y, std::uint32_t frame_key) const {
  if (profile_.principle == DepthPrinciple::kTimeOfFlight)
    return std::clamp((light - kContradictionBegins) / kContradictionRange, 0.0F, 0.9F);
  const float flicker = unit_noise_at(x, y, hash_of(frame_key, kFlicker)) - 0.5F;
  const float quality = unit_noise_at(x, y, hash_of(key_, kPatches)) + kFlickerRange * flicker;
  return quality < kLostQuality * light / (1.0F + light) ? 1.0F : 0.0F;
}

void MutualInterference::disturb(std::uint32_t frame_key, nanoseconds scene_time,
                                 const GaussianTable& gaussians,
                                 ImageView<std::uint16_t> depth_mm) const {
  const std::vector<Active> active = active_at(scene_time);
  if (active.empty()) return;
  const bool is_flight = profile_.principle == DepthPrinciple::kTimeOfFlight;
  for (int y = 0; y < depth_mm.height; ++y) {
    std::uint16_t* row = depth_mm.row(y);
    for (int x = 0; x < depth_mm.width; ++x) {
      if (row[x] == 0) continue;
      float light = 0;
      for (const Active& other : active) light += other.share * other.light->at(x, y);
      if (light <= 0.0F) continue;
      const auto pixel = static_cast<std::uint32_t>(y * depth_mm.width + x);
      const std::uint32_t hash = hash_of(hash_of(frame_key, kDisturbance), pixel);
      const float lost = lost_share(light, static_cast<float>(x), static_cast<float>(y), frame_key);
      if (lost > nth_unit(hash, kLoss)) {
        row[x] = 0;
        continue;
      }
      const float factor = is_flight ? kPhaseNoise * light : kPatternNoise * light / (1.0F + light);
      const float sigma_mm = profile_.axial_sigma_mm(0.001F * static_cast<float>(row[x]), 0.0F);
      row[x] = disturbed(row[x], factor * sigma_mm * gaussians.of_hash(hash));
    }
  }
}

}  // namespace roomcast::simulator
