// SPDX-License-Identifier: Apache-2.0
#include "bench/real/sensor_condition.h"

#include <array>
#include <cstddef>

#include "roomcast/codec/live/sensor_noise.h"
#include "roomcast/sensor/interference_filter.h"

namespace roomcast::bench {
namespace {

constexpr int kPlayed = 240;       // frames
constexpr int kWatchedFrom = 120;  // until then the filter learns
constexpr double kFps = 30;
constexpr double kMinShare = 0.01;

/// Number i of a recording that is played forward and backward.
std::size_t back_and_forth(int i, std::size_t frames) {
  if (frames < 2) return 0;
  const std::size_t step = static_cast<std::size_t>(i) % (2 * frames - 2);
  return step < frames ? step : 2 * frames - 2 - step;
}

std::vector<NoiseAtDistance> noise_by_distance(const std::vector<DepthImage>& frames) {
  codec::SensorNoise noise;
  std::array<double, codec::kSigmaKnotCount> readings{};
  double all = 0;
  for (const DepthImage& frame : frames) {
    noise.observe(frame);
    for (std::size_t i = 0; i < frame.view().pixel_count(); ++i) {
      if (frame.data()[i] == 0) continue;
      ++readings[static_cast<std::size_t>(codec::sigma_knot_of(frame.data()[i]))];
      ++all;
    }
  }
  const codec::SigmaCodes table = noise.table();
  std::vector<NoiseAtDistance> law;
  for (int knot = 0; knot < codec::kSigmaKnotCount; ++knot) {
    const auto i = static_cast<std::size_t>(knot);
    if (all == 0 || readings[i] < kMinShare * all) continue;
    law.push_back({codec::sigma_knot_mm(knot) / 1000.0, codec::sigma_of_code(table[i]) / 256.0,
                   readings[i] / all});
  }
  return law;
}

struct Differences {
  double readings = 0, held = 0, changed = 0;

  void add(const DepthImage& before, const DepthImage& after) {
    for (std::size_t i = 0; i < before.view().pixel_count(); ++i) {
      readings += after.data()[i] != 0;
      held += before.data()[i] == 0 && after.data()[i] != 0;
      changed += before.data()[i] != 0 && before.data()[i] != after.data()[i];
    }
  }
};

}  // namespace

SensorCondition condition_of(const std::string& sensor, const std::vector<DepthImage>& frames) {
  sensor::InterferenceFilter filter(kFps);
  sensor::InterferenceMeter after(kFps);
  Differences differences;
  DepthImage frame;
  for (int i = 0; i < kPlayed; ++i) {
    const DepthImage& before = frames[back_and_forth(i, frames.size())];
    frame = before;
    filter.filter(frame);
    after.add(frame);
    if (i >= kWatchedFrom) differences.add(before, frame);
  }
  SensorCondition condition;
  condition.sensor = sensor;
  condition.noise = noise_by_distance(frames);
  condition.interference = filter.figures();
  condition.filtered = after.figures();
  if (differences.readings > 0) {
    condition.held = differences.held / differences.readings;
    condition.changed = differences.changed / differences.readings;
  }
  return condition;
}

}  // namespace roomcast::bench
