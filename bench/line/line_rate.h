// SPDX-License-Identifier: Apache-2.0
// The rate of a line over time: a counter of bytes, read often, and its extremes over windows. A
// window counts as too slow only if its senders had more to send all the time. Pure.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

namespace roomcast::bench {

class LineRate {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// `total_bytes` so far; times ascend. `has_more`: a sender would send more if it were given
  /// more.
  void add(Time time, std::uint64_t total_bytes, bool has_more = true) {
    readings_.push_back({time, total_bytes, has_more});
  }

  /// Mbit/s from the first reading to the last.
  [[nodiscard]] double mean() const;
  struct Extremes {
    std::optional<double> lowest;  // Mbit/s; nothing: no window in which there was more to send
    double highest = 0;
    double without_more = 0;  // share of the windows in which there was not always more to send
    std::optional<double> mean_of_others;  // Mbit/s; nothing: there are no others
  };
  /// Over all windows of this length that begin and end at a reading.
  [[nodiscard]] Extremes over(std::chrono::milliseconds window) const;
  /// From the first reading to the end of the first window of at least this rate; nothing: there is
  /// none.
  [[nodiscard]] std::optional<Time::duration> time_until(double least_mbit_per_s,
                                                         std::chrono::milliseconds window) const;

 private:
  struct Reading {
    Time time;
    std::uint64_t bytes;
    bool has_more;
  };
  /// Calls `use` with the places of the first and the last reading of each window, until it returns
  /// false.
  template <class Use>
  void each_window(std::chrono::milliseconds window, Use use) const;
  [[nodiscard]] static double mbit_per_s(const Reading& from, const Reading& to);

  std::vector<Reading> readings_;
};

}  // namespace roomcast::bench
