// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/frame_clock.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "roomcast/simulator/random/value_noise.h"

namespace roomcast::simulator {
namespace {

constexpr std::uint32_t kPhase = 41, kOffset = 42, kRate = 43, kJitter = 44, kSingle = 45,
                        kBurst = 46;
constexpr std::uint64_t kShortestBurst = 2, kLongestBurst = 6;
constexpr double kMeanBurst = 0.5 * static_cast<double>(kShortestBurst + kLongestBurst);

double unit(std::uint32_t key, std::uint32_t trait) {
  return static_cast<double>(nth_unit(key, trait));
}
double clock_unit(std::uint32_t key, std::uint32_t trait) {
  return 2.0 * unit(key, trait) - 1.0;
}

nanoseconds rounded(double seconds) {
  return nanoseconds(std::llround(seconds * 1e9));
}

/// Box and Muller 1958, truncated at two standard deviations.
double bounded_gaussian(std::uint32_t hash) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - unit(hash, 0)));
  return std::clamp(radius * std::cos(2.0 * std::numbers::pi * unit(hash, 1)), -2.0, 2.0);
}

}  // namespace

FrameClock::FrameClock(const TimingOptions& options, double fps, std::uint32_t unit_key)
    : offset_s_(options.clock_offset_s * clock_unit(unit_key, kOffset)),
      rate_ppm_(options.rate_ppm * clock_unit(unit_key, kRate)),
      jitter_s_(options.jitter_s),
      lost_share_(options.lost_share),
      key_(unit_key) {
  period_s_ = 1.0 / (fps * (1.0 + 1e-6 * rate_ppm_));
  phase_s_ = options.same_instants ? 0.0 : period_s_ * unit(unit_key, kPhase);
}

nanoseconds FrameClock::true_time(std::uint64_t frame) const {
  return rounded(phase_s_ + static_cast<double>(frame) * period_s_);
}

nanoseconds FrameClock::stamp(std::uint64_t frame) const {
  const auto hash = hash_of(hash_of(key_, kJitter), static_cast<std::uint32_t>(frame));
  const double jitter_s = std::min(jitter_s_, 0.2 * period_s_) * bounded_gaussian(hash);
  return true_time(frame) + rounded(offset_s_ + jitter_s);
}

bool FrameClock::burst_covers(std::uint64_t first, std::uint64_t frame) const {
  const auto hash = hash_of(hash_of(key_, kBurst), static_cast<std::uint32_t>(first));
  if (unit(hash, 0) >= 0.5 * lost_share_ / kMeanBurst) return false;
  const auto lengths = static_cast<double>(kLongestBurst - kShortestBurst + 1);
  const auto length = kShortestBurst + static_cast<std::uint64_t>(unit(hash, 1) * lengths);
  return frame < first + length;
}

bool FrameClock::is_lost(std::uint64_t frame) const {
  if (frame == 0) return false;
  const auto hash = hash_of(hash_of(key_, kSingle), static_cast<std::uint32_t>(frame));
  if (unit(hash, 0) < 0.5 * lost_share_) return true;
  const std::uint64_t earliest = frame >= kLongestBurst ? frame - kLongestBurst + 1 : 1;
  for (std::uint64_t first = std::max<std::uint64_t>(earliest, 1); first <= frame; ++first) {
    if (burst_covers(first, frame)) return true;
  }
  return false;
}

}  // namespace roomcast::simulator
