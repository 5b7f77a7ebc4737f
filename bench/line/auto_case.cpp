// SPDX-License-Identifier: Apache-2.0
// Measures how well sensors that estimate their line use it: the link changes its rate, and three
// figures say what came of it: the share of the link that was used, the age of frames on arrival,
// and the time until most of a faster link is used.
#include <thread>

#include <fmt/format.h>

#include "bench/latency/latency_cases.h"
#include "bench/line/line_bench.h"
#include "bench/line/rate_room.h"

namespace roomcast::bench {
namespace {

using namespace std::chrono_literals;

constexpr double kGoodShare = 0.8;
constexpr auto kWindow = 500ms;  // over which a rate counts

void add_ages(const std::string& name, const std::vector<double>& ages_ms, LineReport& report) {
  const LatencyRow ages = distribution("", "ms", ages_ms);
  report.figures.push_back({name + "age on arrival, p50", "ms", ages.p50});
  report.figures.push_back({name + "age on arrival, p95", "ms", ages.p95});
}

void add_phase(std::size_t number, double mbit, double mbit_before, const RateOutcome& outcome,
               const LineRate::Extremes& seconds, int sensors, LineReport& report) {
  const std::string name = fmt::format("auto, {}. {:g} Mbit/s: ", number, mbit);
  report.figures.push_back({name + "share of the link", "%", 100 * outcome.line.mean() / mbit});
  report.figures.push_back(
      {name + "seconds without more to send", "%", 100 * seconds.without_more});
  if (seconds.mean_of_others) {
    report.figures.push_back(
        {name + "share of the link in the others", "%", 100 * *seconds.mean_of_others / mbit});
  }
  report.figures.push_back(
      {name + "frames of a sensor", "1/s",
       static_cast<double>(outcome.ages_ms.size()) / outcome.seconds / sensors});
  add_ages(name, outcome.ages_ms, report);
  if (mbit_before == 0 || mbit_before >= mbit) return;
  const auto used = outcome.line.time_until(kGoodShare * mbit, kWindow);
  if (used) {
    report.figures.push_back({name + "until 80 % of the link is used", "s",
                              std::chrono::duration<double>(*used).count()});
  }
}

}  // namespace

Status measure_auto(const LineBenchOptions& options,
                    const std::function<void(const std::string&)>& progress, LineReport& report) {
  sensor::CodecChoice codec;
  codec.fits_line = true;
  auto room =
      RateRoom::open(options, {.mbit_per_s = options.link_mbit.front(), .round_trip = 30ms}, codec);
  if (!room) return room.error();
  std::this_thread::sleep_for(options.rate_warm_up);
  double carried = 0, capacity = 0, before = 0;
  double carried_with_more = 0, capacity_with_more = 0;
  std::vector<double> ages_ms;
  for (std::size_t i = 0; i < options.link_mbit.size(); ++i) {
    const double mbit = options.link_mbit[i];
    if (progress) progress(fmt::format("a link of {:g} Mbit/s", mbit));
    (*room)->set_link_rate(mbit);
    const RateOutcome outcome = (*room)->measure(options.duration);
    const LineRate::Extremes seconds = outcome.line.over(1s);
    add_phase(i + 1, mbit, before, outcome, seconds, options.sensors, report);
    carried += outcome.line.mean();
    capacity += mbit;
    carried_with_more += (1 - seconds.without_more) * seconds.mean_of_others.value_or(0);
    capacity_with_more += (1 - seconds.without_more) * mbit;
    ages_ms.insert(ages_ms.end(), outcome.ages_ms.begin(), outcome.ages_ms.end());
    before = mbit;
  }
  report.figures.push_back({"auto: share of the link", "%", 100 * carried / capacity});
  if (capacity_with_more > 0) {
    report.figures.push_back({"auto: share of the link in seconds with more to send", "%",
                              100 * carried_with_more / capacity_with_more});
  }
  add_ages("auto: ", ages_ms, report);
  return {};
}

}  // namespace roomcast::bench
