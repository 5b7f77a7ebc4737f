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

template <class Use>
void LineRate::each_window(std::chrono::milliseconds window, Use use) const {
  std::size_t from = 0;
  for (std::size_t to = 0; to < readings_.size(); ++to) {
    if (readings_[to].time - readings_.front().time < window) continue;
    while (from + 1 < to && readings_[to].time - readings_[from + 1].time >= window) ++from;
    if (!use(mbit_per_s(readings_[from], readings_[to]), readings_[to])) return;
  }
}

std::optional<LineRate::Time::duration> LineRate::time_until(
    double least_mbit_per_s, std::chrono::milliseconds window) const {
  std::optional<Time::duration> time;
  each_window(window, [&](double rate, const Reading& last) {
    if (rate >= least_mbit_per_s) time = last.time - readings_.front().time;
    return !time;
  });
  return time;
}

LineRate::Extremes LineRate::over(std::chrono::milliseconds window) const {
  Extremes extremes{std::numeric_limits<double>::infinity(), 0};
  each_window(window, [&](double rate, const Reading&) {
    extremes.lowest = std::min(extremes.lowest, rate);
    extremes.highest = std::max(extremes.highest, rate);
    return true;
  });
  if (extremes.highest == 0) extremes.lowest = 0;
  return extremes;
}

}  // namespace roomcast::bench
