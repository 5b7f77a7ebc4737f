// SPDX-License-Identifier: Apache-2.0
// Measures how fairly sensors share a line that estimate what it carries: one uses it, and another
// comes later.
#include <thread>

#include <fmt/format.h>

#include "bench/latency/latency_cases.h"
#include "bench/line/line_bench.h"
#include "bench/line/rate_room.h"

namespace roomcast::bench {
namespace {

using namespace std::chrono_literals;

constexpr double kSharedLink_mbit = 3;  // less than two sensors could use
constexpr int kLateParts = 4;

}  // namespace

Status measure_late(const LineBenchOptions& options,
                    const std::function<void(const std::string&)>& progress, LineReport& report) {
  sensor::CodecChoice codec;
  codec.fits_line = true;
  LineBenchOptions first = options, both = options;
  first.sensors = 1, both.sensors = 2;
  auto room = RateRoom::open(first, {.mbit_per_s = kSharedLink_mbit, .round_trip = 30ms}, codec);
  if (!room) return room.error();
  std::this_thread::sleep_for(options.rate_warm_up);
  if (Status status = (*room)->join_sensor(both, codec, 1); !status) return status;
  std::vector<double> before = (*room)->bytes_sent();
  for (int part = 1; part <= kLateParts; ++part) {
    const std::string name = fmt::format("late, {}. part: ", part);
    if (progress) progress(name);
    const RateOutcome outcome = (*room)->measure(options.duration);
    const std::vector<double> after = (*room)->bytes_sent();
    const double sent = after[0] - before[0], sent_late = after[1] - before[1];
    before = after;
    if (sent + sent_late > 0) {
      report.figures.push_back(
          {name + "share of the one who came later", "%", 100 * sent_late / (sent + sent_late)});
    }
    report.figures.push_back(
        {name + "share of the link", "%", 100 * outcome.line.mean() / kSharedLink_mbit});
    report.figures.push_back(
        {name + "age on arrival, p95", "ms", distribution("", "ms", outcome.ages_ms).p95});
  }
  return {};
}

}  // namespace roomcast::bench
