// SPDX-License-Identifier: Apache-2.0
// Measures what a viewer with a slow line gets of sensors that have a good one: with the full
// renditions only, and with small ones where his line takes no more.
#include <algorithm>
#include <thread>

#include <fmt/format.h>

#include "bench/latency/latency_cases.h"
#include "bench/line/line_bench.h"
#include "bench/line/rate_room.h"

namespace roomcast::bench {
namespace {

using namespace std::chrono_literals;

void add_viewer_figures(const std::string& name, const RateOutcome& outcome, double mbit,
                        int sensors, LineReport& report) {
  const auto frames = static_cast<double>(outcome.ages_ms.size());
  const LatencyRow ages = distribution("", "ms", outcome.ages_ms);
  report.figures.push_back(
      {name + "frames of a sensor", "1/s", frames / outcome.seconds / sensors});
  report.figures.push_back(
      {name + "of these small", "%",
       100 * static_cast<double>(outcome.small_frames) / std::max(1.0, frames)});
  report.figures.push_back({name + "longest freeze of a sensor", "ms", outcome.longest_gap_ms});
  const RateOutcome::BestSensor& best = outcome.best_sensor;
  report.figures.push_back(
      {name + "frames of the sensor that comes most", "1/s", best.frames / outcome.seconds});
  report.figures.push_back({name + "its longest freeze", "ms", best.longest_gap_ms});
  report.figures.push_back({name + "age on arrival, p50", "ms", ages.p50});
  report.figures.push_back({name + "age on arrival, p95", "ms", ages.p95});
  report.figures.push_back({name + "share of the line", "%", 100 * outcome.line.mean() / mbit});
}

}  // namespace

Status measure_viewer(const LineBenchOptions& options,
                      const std::function<void(const std::string&)>& progress, LineReport& report) {
  for (const double mbit : options.target_mbit) {
    for (const bool has_small : {false, true}) {
      const std::string name = fmt::format("viewer's line of {:g} Mbit/s, {}: ", mbit,
                                           has_small ? "two renditions" : "one rendition");
      if (progress) progress(name);
      sensor::CodecChoice codec;
      if (!has_small) codec.small_mbit_per_s = 0;
      auto room = RateRoom::open(options, {.mbit_per_s = mbit, .round_trip = 30ms}, codec, 0,
                                 RateRoom::End::kNear);
      if (!room) return room.error();
      std::this_thread::sleep_for(options.rate_warm_up);
      add_viewer_figures(name, (*room)->measure(options.duration), mbit, options.sensors, report);
    }
  }
  return {};
}

}  // namespace roomcast::bench
