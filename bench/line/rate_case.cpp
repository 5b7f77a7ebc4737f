// SPDX-License-Identifier: Apache-2.0
// Measures how well sensors with a target rate keep to it, and those that share their room's
// uplink: simulated sensors at the near end of an emulated link that carries more than they send,
// hub and viewer at its far end.
#include <thread>

#include <fmt/format.h>

#include "bench/latency/latency_cases.h"
#include "bench/line/line_bench.h"
#include "bench/line/rate_room.h"

namespace roomcast::bench {
namespace {

using namespace std::chrono_literals;

void add_line_figures(const std::string& name, const RateOutcome& outcome, double mbit,
                      LineReport& report) {
  const auto percent = [mbit](double rate) { return 100 * (rate / mbit - 1); };
  const auto seconds = outcome.line.over(1s), bursts = outcome.line.over(200ms);
  report.figures.push_back({name + "mean", "Mbit/s", outcome.line.mean()});
  if (seconds.lowest)
    report.figures.push_back({name + "lowest second", "% off", percent(*seconds.lowest)});
  report.figures.push_back(
      {name + "seconds without more to send", "%", 100 * seconds.without_more});
  report.figures.push_back({name + "highest second", "% off", percent(seconds.highest)});
  report.figures.push_back({name + "highest 0.2 s", "% off", percent(bursts.highest)});
}

void add_figures(const std::string& name, const RateOutcome& outcome, double mbit, int sensors,
                 LineReport& report) {
  add_line_figures(name, outcome, mbit, report);
  report.figures.push_back(
      {name + "frames of a sensor", "1/s",
       static_cast<double>(outcome.ages_ms.size()) / outcome.seconds / sensors});
  const auto ages = distribution("", "ms", outcome.ages_ms);
  report.figures.push_back({name + "age on arrival, p50", "ms", ages.p50});
  report.figures.push_back({name + "age on arrival, p99", "ms", ages.p99});
}

}  // namespace

Status measure_rate(const LineBenchOptions& options,
                    const std::function<void(const std::string&)>& progress, LineReport& report) {
  for (const double mbit : options.target_mbit) {
    if (progress) progress(fmt::format("a target of {:g} Mbit/s", mbit));
    sensor::CodecChoice codec;
    codec.target_mbit_per_s = mbit / options.sensors;
    auto room = RateRoom::open(options, {.mbit_per_s = 100, .round_trip = 30ms}, codec);
    if (!room) return room.error();
    std::this_thread::sleep_for(options.rate_warm_up);
    add_figures(fmt::format("rate {:g} Mbit/s: ", mbit), (*room)->measure(options.duration), mbit,
                options.sensors, report);
  }
  return {};
}

Status measure_uplink(const LineBenchOptions& options,
                      const std::function<void(const std::string&)>& progress, LineReport& report) {
  for (const double mbit : options.target_mbit) {
    if (progress) progress(fmt::format("an uplink of {:g} Mbit/s", mbit));
    auto room = RateRoom::open(options, {.mbit_per_s = 100, .round_trip = 30ms}, {}, mbit);
    if (!room) return room.error();
    std::this_thread::sleep_for(options.rate_warm_up);
    const std::string name = fmt::format("uplink {:g} Mbit/s: ", mbit);
    add_figures(name, (*room)->measure(options.duration), mbit, options.sensors, report);
    const auto turning = (*room)->measure_turning(options.duration);
    if (!turning) return turning.error();
    add_line_figures(name + "turning, ", *turning, mbit, report);
  }
  return {};
}

}  // namespace roomcast::bench
