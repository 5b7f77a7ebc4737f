// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/harsh_unit.h"

#include "roomcast/simulator/random/random.h"
#include "roomcast/simulator/sensing/depth_scale.h"
#include "roomcast/simulator/sensing/lens_error.h"
#include "roomcast/simulator/sensing/noise_law.h"

namespace roomcast::simulator {
namespace {

// Traits, each with random numbers of its own, so that a new one changes no other.
constexpr std::uint32_t kModel = 71, kNoise = 72, kLenses = 73, kScale = 74, kColor = 75,
                        kTiming = 76, kRegistered = 77, kRecording = 78;
constexpr float kRegisteredShare = 1.0F / 3.0F;

CameraModel draw_model(Harshness harshness, Random random) {
  const bool structured = harshness == Harshness::kMixed ? random.chance(0.5F)
                                                         : harshness == Harshness::kStructuredLight;
  if (structured) return CameraModel::kKinect1;
  return random.chance(0.5F) ? CameraModel::kKinect2 : CameraModel::kAzure;
}

SensorCalibration draw_true_lenses(const SensorCalibration& nominal, Random random) {
  SensorCalibration exact = nominal;
  exact.depth = with_error(nominal.depth, draw_lens_error(random));
  exact.color = with_error(nominal.color, draw_lens_error(random));
  exact.color_from_depth = with_drawn_error(nominal.color_from_depth, random);
  return exact;
}

void draw_color(SensorUnit& unit, Random random) {
  const float brightness = random.between(0.7F, 1.3F);
  const float red = random.between(0.85F, 1.15F), blue = random.between(0.85F, 1.15F);
  unit.color_gain = {brightness * red, brightness, brightness * blue};
  unit.drift.exposure = random.between(0.0F, 0.15F);
  unit.drift.balance = random.between(0.0F, 0.08F);
  unit.drift.period_s = random.between(0.5F, 5.0F);
  unit.drift.key = random.seed();
}

Shutter draw_shutter(Random random) {
  const float readout_s = random.between(0.010F, 0.033F);
  return {readout_s, random.between(0.005F, 0.033F)};
}

/// What the device declares about colour that it has registered: depth's own grid.
SensorCalibration registered(SensorCalibration calibration) {
  calibration.color = calibration.depth;
  calibration.color_from_depth = {};
  calibration.color_is_registered = true;
  return calibration;
}

}  // namespace

SensorUnit make_harsh_unit(const SensingOptions& options, std::uint32_t key) {
  const auto of = [key](std::uint32_t trait) { return Random(hash_of(key, trait)); };
  SensorUnit unit;
  unit.key = key;
  unit.profile = profile_of(draw_model(options.harsh, of(kModel)), options.half_color);
  Random noise = of(kNoise);
  unit.profile = with_drawn_noise(unit.profile, noise);
  unit.exact = draw_true_lenses(unit.profile.nominal, of(kLenses));
  unit.reported = unit.profile.nominal;
  unit.depth_scale =
      1.0 + kMaxDepthScaleError * static_cast<double>(of(kScale).between(-1.0F, 1.0F));
  draw_color(unit, of(kColor));
  unit.shutter = draw_shutter(of(kTiming));
  unit.jpeg_quality = kHarshJpegQuality;
  if (of(kRegistered).chance(kRegisteredShare)) {
    unit.registered_by = unit.reported;
    unit.reported = registered(unit.reported);
  }
  return unit;
}

HarshRecording draw_harsh_recording(std::uint64_t seed) {
  const auto folded =
      hash_of(static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32));
  Random random(hash_of(folded, kRecording));
  HarshRecording recording;
  recording.frames = kMinHarshFrames + random.below(kMaxHarshFrames - kMinHarshFrames + 1);
  recording.fps = static_cast<double>(
      random.between(static_cast<float>(kMinHarshFps), static_cast<float>(kMaxHarshFps)));
  return recording;
}

}  // namespace roomcast::simulator
