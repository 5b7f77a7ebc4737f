// SPDX-License-Identifier: Apache-2.0
// RateMeter: growth of a count per second, over the last two seconds. Pure.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>

#include "roomcast/core/clock.h"

namespace roomcast::viewer {

class RateMeter {
 public:
  static constexpr std::chrono::seconds kWindow{2};
  static constexpr std::chrono::milliseconds kSpacing{50};  // between samples, to bound the memory

  /// A `total` below the last one starts a new count.
  void count(HostTime now, std::uint64_t total) {
    if (!samples_.empty() && total < samples_.back().total) samples_.clear();
    const bool is_dense = samples_.size() > 1 && now - samples_[samples_.size() - 2].at < kSpacing;
    if (is_dense) samples_.pop_back();
    samples_.push_back({now, total});
    while (now - samples_.front().at > kWindow) samples_.pop_front();
  }
  [[nodiscard]] double per_second() const {
    if (samples_.size() < 2) return 0;
    const std::chrono::duration<double> time = samples_.back().at - samples_.front().at;
    const auto grown = static_cast<double>(samples_.back().total - samples_.front().total);
    return time.count() > 0 ? grown / time.count() : 0;
  }

 private:
  struct Sample {
    HostTime at{};
    std::uint64_t total = 0;
  };
  std::deque<Sample> samples_;
};

}  // namespace roomcast::viewer
