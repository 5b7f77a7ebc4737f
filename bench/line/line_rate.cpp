// SPDX-License-Identifier: Apache-2.0
#include "bench/line/line_rate.h"

#include <algorithm>

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
    if (!use(from, to)) return;
  }
}

std::optional<LineRate::Time::duration> LineRate::time_until(
    double least_mbit_per_s, std::chrono::milliseconds window) const {
  std::optional<Time::duration> time;
  each_window(window, [&](std::size_t from, std::size_t to) {
    if (mbit_per_s(readings_[from], readings_[to]) >= least_mbit_per_s)
      time = readings_[to].time - readings_.front().time;
    return !time;
  });
  return time;
}

LineRate::Extremes LineRate::over(std::chrono::milliseconds window) const {
  Extremes extremes;
  double windows = 0, without_more = 0, sum_of_others = 0;
  std::size_t last_without = 0;  // the place behind the newest reading without more to send
  std::size_t looked_at = 0;
  each_window(window, [&](std::size_t from, std::size_t to) {
    for (; looked_at <= to; ++looked_at)
      if (!readings_[looked_at].has_more) last_without = looked_at + 1;
    const double rate = mbit_per_s(readings_[from], readings_[to]);
    const bool had_more = last_without <= from;
    ++windows;
    without_more += had_more ? 0 : 1;
    sum_of_others += had_more ? rate : 0;
    if (had_more) extremes.lowest = std::min(extremes.lowest.value_or(rate), rate);
    extremes.highest = std::max(extremes.highest, rate);
    return true;
  });
  if (windows > 0) extremes.without_more = without_more / windows;
  if (windows > without_more) extremes.mean_of_others = sum_of_others / (windows - without_more);
  return extremes;
}

}  // namespace roomcast::bench
