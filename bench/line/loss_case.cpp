// SPDX-License-Identifier: Apache-2.0
// Measures what a viewer sees of a bad line: the sensors' or his own. The line loses packets in
// bursts, stands still for 300 ms now and then, or becomes half as fast. What counts is how long a
// sensor's picture stands still.
#include <thread>

#include <fmt/format.h>

#include "bench/latency/latency_cases.h"
#include "bench/line/line_bench.h"
#include "bench/line/rate_room.h"

namespace roomcast::bench {
namespace {

using namespace std::chrono_literals;

constexpr double kLink_mbit = 6, kHalf_mbit = 3;
constexpr double kLoss = 0.05, kBurst = 4;  // packets
constexpr std::chrono::milliseconds kOutage{300}, kBetweenOutages{4'000};

struct Trouble {
  const char* name;
  LinkSpec link;
  bool has_outages = false, halves = false;
};

RateOutcome measure_trouble(RateRoom& room, const Trouble& trouble,
                            std::chrono::milliseconds duration) {
  const std::jthread making([&](const std::stop_token& stop) {
    if (trouble.halves) {
      std::this_thread::sleep_for(duration / 2);
      room.set_link_rate(kHalf_mbit);
    }
    auto next = std::chrono::steady_clock::now() + kBetweenOutages / 2;
    while (trouble.has_outages && !stop.stop_requested()) {
      std::this_thread::sleep_for(20ms);
      if (std::chrono::steady_clock::now() < next) continue;
      room.stop_link_for(kOutage);
      next += kBetweenOutages;
    }
  });
  return room.measure(duration);
}

}  // namespace

Status measure_loss(const LineBenchOptions& options,
                    const std::function<void(const std::string&)>& progress, LineReport& report) {
  const LinkSpec good{.mbit_per_s = kLink_mbit, .round_trip = 30ms};
  LinkSpec lossy = good;
  lossy.loss = kLoss;
  lossy.loss_burst = kBurst;
  const Trouble troubles[] = {{.name = "no trouble", .link = good},
                              {.name = "5 % loss in bursts", .link = lossy},
                              {.name = "outages of 300 ms", .link = good, .has_outages = true},
                              {.name = "half the rate", .link = good, .halves = true}};
  sensor::CodecChoice fits_line;
  fits_line.fits_line = true;
  for (const bool is_viewers : {false, true}) {
    for (const Trouble& trouble : troubles) {
      const std::string name =
          fmt::format("{} line, {}: ", is_viewers ? "viewer's" : "sensors'", trouble.name);
      if (progress) progress(name);
      auto room =
          RateRoom::open(options, trouble.link, is_viewers ? sensor::CodecChoice() : fits_line, 0,
                         is_viewers ? RateRoom::End::kNear : RateRoom::End::kFar);
      if (!room) return room.error();
      std::this_thread::sleep_for(options.rate_warm_up);
      const RateOutcome outcome = measure_trouble(**room, trouble, options.duration);
      const LatencyRow ages = distribution("", "ms", outcome.ages_ms);
      report.figures.push_back({name + "longest freeze of a sensor", "ms", outcome.longest_gap_ms});
      report.figures.push_back(
          {name + "frames of a sensor", "1/s",
           static_cast<double>(outcome.ages_ms.size()) / outcome.seconds / options.sensors});
      report.figures.push_back({name + "age on arrival, p50", "ms", ages.p50});
      report.figures.push_back({name + "age on arrival, p99", "ms", ages.p99});
    }
  }
  return {};
}

}  // namespace roomcast::bench
