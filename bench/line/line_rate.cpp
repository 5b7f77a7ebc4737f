// SPDX-License-Identifier: Apache-2.0
#include "bench/line/line_rate.h"

#include <algorithm>
#include <limits>

namespace roomcast::bench {

double LineRate::mbit_per_s(const Reading& from, const Reading& to) {
  const double seconds = std::chrono::duration<double>(to.time - from.time).count();
  return seconds > 0 ? static_cast<double>(to.bytes - from.bytes) * 8e-6 / seconds : 0;
}

double LineRate::mean() const {
  return readings_.size() < 2 ? 0 : mbit_per_s(readings_.front(), readings_.back());
}

LineRate::Extremes LineRate::over(std::chrono::milliseconds window) const {
  Extremes extremes{std::numeric_limits<double>::infinity(), 0};
  std::size_t from = 0;
  for (std::size_t to = 0; to < readings_.size(); ++to) {
    if (readings_[to].time - readings_.front().time < window) continue;
    while (from + 1 < to && readings_[to].time - readings_[from + 1].time >= window) ++from;
    const double rate = mbit_per_s(readings_[from], readings_[to]);
    extremes.lowest = std::min(extremes.lowest, rate);
    extremes.highest = std::max(extremes.highest, rate);
  }
  if (extremes.highest == 0) extremes.lowest = 0;
  return extremes;
}

}  // namespace roomcast::bench
