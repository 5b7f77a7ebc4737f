// SPDX-License-Identifier: Apache-2.0
// Measures how well sensors with a target rate keep to it: simulated sensors at the near end of an
// emulated link that carries more than they send, hub and viewer at its far end.
#include <memory>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "bench/latency/latency_cases.h"
#include "bench/latency/set_watcher.h"
#include "bench/line/line_bench.h"
#include "bench/line/line_rate.h"
#include "bench/line/looped_source.h"
#include "bench/link/emulated_link.h"
#include "roomcast/hub/server/running_hub.h"
#include "roomcast/sensor/sensor_feed.h"

namespace roomcast::bench {
namespace {

using namespace std::chrono_literals;

constexpr double kFps = 15;  // what this machine can register and encode for several sensors
constexpr int kLoopFrames = 45;
constexpr auto kReadEvery = 10ms;  // the link's counter

struct RateOutcome {
  LineRate line;
  std::vector<double> ages_ms;
  double seconds = 0;
};

class RateRoom {
 public:
  static Result<std::unique_ptr<RateRoom>> open(const LineBenchOptions& options, double mbit) {
    auto link = EmulatedLink::open({.mbit_per_s = 100, .round_trip = 30ms});
    if (!link) return link.error();
    std::unique_ptr<RateRoom> room(new RateRoom(*std::move(link)));
    if (auto status = room->enter(options, mbit); !status) return status.error();
    return room;
  }

  RateOutcome measure(const LineBenchOptions& options) {
    RateOutcome outcome;
    std::this_thread::sleep_for(options.rate_warm_up);
    (void)watcher_->take();
    const auto began = std::chrono::steady_clock::now();
    for (auto now = began; now < began + options.duration; now = std::chrono::steady_clock::now()) {
      outcome.line.add(now, link_->carried_bytes());
      std::this_thread::sleep_for(kReadEvery);
    }
    outcome.ages_ms = watcher_->take().ages_ms;
    outcome.seconds = std::chrono::duration<double>(options.duration).count();
    return outcome;
  }

 private:
  explicit RateRoom(std::unique_ptr<EmulatedLink> link) : link_(std::move(link)) {}

  Status enter(const LineBenchOptions& options, double mbit) {
    Status status;
    link_->run(EmulatedLink::End::kFar, [&] { status = enter_far(); });
    if (!status) return status;
    link_->run(EmulatedLink::End::kNear, [&] { status = enter_near(options, mbit); });
    return status;
  }

  Status enter_far() {
    auto hub = hub::RunningHub::start(
        {.address = EmulatedLink::address(EmulatedLink::End::kFar), .port = 0});
    if (!hub) return hub.error();
    hub_ = *std::move(hub);
    watcher_ = std::make_unique<SetWatcher>(hub_->url());
    return {};
  }

  Status enter_near(const LineBenchOptions& options, double mbit) {
    for (int i = 0; i < options.sensors; ++i) {
      auto source = LoopedSource::capture(options.scene, i, options.sensors, kFps, kLoopFrames);
      if (!source) return source.error();
      sensor::SensorFeedOptions feed;
      feed.hub_url = hub_->url();
      feed.codec.target_mbit_per_s = mbit / options.sensors;
      auto started = sensor::SensorFeed::start(*std::move(source), feed);
      if (!started) return started.error();
      feeds_.push_back(*std::move(started));
    }
    return {};
  }

  const std::unique_ptr<EmulatedLink> link_;
  std::unique_ptr<hub::RunningHub> hub_;
  std::unique_ptr<SetWatcher> watcher_;
  std::vector<std::unique_ptr<sensor::SensorFeed>> feeds_;
};

void add_figures(const RateOutcome& outcome, double mbit, int sensors, LineReport& report) {
  const auto percent = [mbit](double rate) { return 100 * (rate / mbit - 1); };
  const auto seconds = outcome.line.over(1s), bursts = outcome.line.over(200ms);
  const std::string name = fmt::format("rate {:g} Mbit/s: ", mbit);
  report.figures.push_back({name + "mean", "Mbit/s", outcome.line.mean()});
  report.figures.push_back({name + "lowest second", "% off", percent(seconds.lowest)});
  report.figures.push_back({name + "highest second", "% off", percent(seconds.highest)});
  report.figures.push_back({name + "highest 0.2 s", "% off", percent(bursts.highest)});
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
    auto room = RateRoom::open(options, mbit);
    if (!room) return room.error();
    add_figures((*room)->measure(options), mbit, options.sensors, report);
  }
  return {};
}

}  // namespace roomcast::bench
