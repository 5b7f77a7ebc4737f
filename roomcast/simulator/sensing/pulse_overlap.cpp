// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/pulse_overlap.h"

#include <algorithm>
#include <cmath>

namespace roomcast::simulator {
namespace {

/// Of two frames alone.
double overlap_of_two(double lag_s) {
  double shared_s = 0;
  for (int apart = 1 - kPulsesPerFrame; apart < kPulsesPerFrame; ++apart) {
    const double shared_by_one = kPulse_s - std::abs(lag_s + apart * kPulseSpacing_s);
    shared_s += (kPulsesPerFrame - std::abs(apart)) * std::max(0.0, shared_by_one);
  }
  return shared_s / (kPulsesPerFrame * kPulse_s);
}

}  // namespace

double pulse_overlap(double lag_s, double other_period_s) {
  const double after = lag_s - other_period_s * std::floor(lag_s / other_period_s);
  return std::min(1.0, overlap_of_two(after) + overlap_of_two(after - other_period_s));
}

}  // namespace roomcast::simulator
