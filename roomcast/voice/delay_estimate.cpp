// SPDX-License-Identifier: Apache-2.0
#include "roomcast/voice/delay_estimate.h"

#include <algorithm>
#include <vector>

namespace roomcast::voice {
namespace {

constexpr double kMargin_ms = 10;
constexpr double kInTime = 0.98;         // of the packets
constexpr double kLowered_ms = 2;        // at a time
constexpr std::size_t kAdaptEvery = 10;  // packets
constexpr double kBaseline_ms = 10'000;  // the shortest delay of this time and the one before it

double in_ms(nanoseconds time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

}  // namespace

double DelayEstimate::shortest_ms() const {
  return std::min(least_, least_before_);
}

/// A single late packet raises the target half of the way: it may remain the only one.
void DelayEstimate::arrived(nanoseconds capture, nanoseconds now) {
  const double now_ms = in_ms(now), way_ms = in_ms(now - capture);
  if (now_ms - begun_ms_ > kBaseline_ms) {
    least_before_ = least_;
    least_ = kUnknown;
    begun_ms_ = now_ms;
  }
  least_ = std::min(least_, way_ms);
  const double late_ms = way_ms - shortest_ms();
  lateness_[count_++ % kWindow] = static_cast<float>(late_ms);
  if (late_ms + kMargin_ms > target_ms_) {
    target_ms_ = std::min(kMax_ms, (target_ms_ + late_ms + kMargin_ms) / 2);
  } else if (count_ % kAdaptEvery == 0) {
    lower();
  }
}

void DelayEstimate::lower() {
  const auto size = std::min(count_, kWindow);
  std::vector<float> known(lateness_.begin(),
                           lateness_.begin() + static_cast<std::ptrdiff_t>(size));
  const auto place =
      std::min(size - 1, static_cast<std::size_t>(kInTime * static_cast<double>(size)));
  std::ranges::nth_element(known, known.begin() + static_cast<std::ptrdiff_t>(place));
  const double goal_ms = std::max(kMin_ms, known[place] + kMargin_ms);
  if (goal_ms < target_ms_) target_ms_ = std::max(goal_ms, target_ms_ - kLowered_ms);
}

}  // namespace roomcast::voice
