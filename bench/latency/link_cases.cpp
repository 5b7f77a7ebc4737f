// SPDX-License-Identifier: Apache-2.0
// Measures a viewer behind an emulated link, with hub, sensors and other viewers at the near end.
#include <algorithm>
#include <memory>
#include <optional>
#include <thread>

#include "bench/latency/latency_cases.h"
#include "bench/latency/set_watcher.h"
#include "bench/latency/timed_sensor.h"
#include "bench/link/emulated_link.h"
#include "roomcast/hub/server/running_hub.h"

namespace roomcast::bench {

namespace {

using namespace std::chrono_literals;
constexpr double kFps = 30;
constexpr auto kRateSearch = 2s;  // time for congestion control to find its rate

struct LinkCase {
  LinkSpec link;
  int sensors = 4;
  std::size_t frame_bytes = 20'480;
  int other_viewers = 0;
};

struct LinkOutcome {
  Arrivals far;
  std::vector<double> near_ages_ms;
  std::map<std::uint64_t, int> near_sets;  // as received by one of the near viewers
  double sets_sent = 0;
  double link_bytes = 0;  // IP packets carried by the link
};

/// All clients of the room, and their measurements.
class LinkRoom {
 public:
  static Result<std::unique_ptr<LinkRoom>> open(const LinkCase& link_case) {
    auto link = EmulatedLink::open(link_case.link);
    if (!link) return link.error();
    std::unique_ptr<LinkRoom> room(new LinkRoom(link_case, *std::move(link)));
    if (auto status = room->enter(); !status) return status.error();
    return room;
  }

  Result<LinkOutcome> measure(std::chrono::milliseconds duration) {
    const auto give_up = std::chrono::steady_clock::now() + 10s;
    while (!far_->sees_something() && std::chrono::steady_clock::now() < give_up) {
      std::this_thread::sleep_for(20ms);
    }
    if (!far_->sees_something()) {
      return Error{ErrorCode::kUnavailable, "nothing arrives over the emulated link"};
    }
    std::this_thread::sleep_for(kRateSearch);
    (void)far_->take();
    for (const auto& watcher : near_) (void)watcher->take();
    const std::uint64_t sent = sensors_.front()->frames_sent();
    const std::uint64_t crossed = link_->carried_bytes();
    std::this_thread::sleep_for(duration);
    LinkOutcome outcome;
    outcome.link_bytes = static_cast<double>(link_->carried_bytes() - crossed);
    outcome.sets_sent = static_cast<double>(sensors_.front()->frames_sent() - sent);
    outcome.far = far_->take();
    for (const auto& watcher : near_) {
      Arrivals near = watcher->take();
      outcome.near_ages_ms.insert(outcome.near_ages_ms.end(), near.ages_ms.begin(),
                                  near.ages_ms.end());
      outcome.near_sets = std::move(near.sets);
    }
    return outcome;
  }

 private:
  LinkRoom(const LinkCase& link_case, std::unique_ptr<EmulatedLink> link)
      : case_(link_case), link_(std::move(link)) {}

  Status enter() {
    Status status;
    link_->run(EmulatedLink::End::kNear, [&] { status = enter_near(); });
    if (!status) return status;
    link_->run(EmulatedLink::End::kFar, [&] { far_ = std::make_unique<SetWatcher>(hub_->url()); });
    return {};
  }

  Status enter_near() {
    auto hub = hub::RunningHub::start(
        {.address = EmulatedLink::address(EmulatedLink::End::kNear), .port = 0});
    if (!hub) return hub.error();
    hub_ = *std::move(hub);
    for (int i = 0; i < case_.sensors; ++i) {
      sensors_.push_back(std::make_unique<TimedSensor>(
          TimedSensorOptions{hub_->url(), "s" + std::to_string(i), case_.frame_bytes, kFps}));
    }
    for (int i = 0; i < case_.other_viewers; ++i) {
      near_.push_back(std::make_unique<SetWatcher>(hub_->url()));
    }
    return {};
  }

  const LinkCase case_;
  std::unique_ptr<EmulatedLink> link_;
  std::unique_ptr<hub::RunningHub> hub_;
  std::vector<std::unique_ptr<TimedSensor>> sensors_;
  std::vector<std::unique_ptr<SetWatcher>> near_;
  std::unique_ptr<SetWatcher> far_;
};

Result<LinkOutcome> measure(const LinkCase& link_case, std::chrono::milliseconds duration) {
  auto room = LinkRoom::open(link_case);
  if (!room) return room.error();
  return (*room)->measure(duration);
}

/// Number of sets of which the far viewer received less than a near one: a set may lack a sensor
/// that was late itself. Ignores the sets at either end, which the measurement may have cut off.
int partial_sets(const LinkOutcome& outcome) {
  const std::map<std::uint64_t, int>& far = outcome.far.sets;
  if (far.size() < 3) return 0;
  return static_cast<int>(
      std::count_if(std::next(far.begin()), std::prev(far.end()), [&](const auto& set) {
        const auto whole = outcome.near_sets.find(set.first);
        return whole != outcome.near_sets.end() && set.second < whole->second;
      }));
}

double percent(double part, double whole) {
  return whole > 0 ? 100 * part / whole : 0;
}

}  // namespace

Status measure_internet(std::chrono::milliseconds duration, LatencyReport& report) {
  const LinkCase link_case{.link = {.mbit_per_s = 20, .round_trip = 50ms, .loss = 0.01},
                           .sensors = 1,
                           .frame_bytes = 33'333};
  auto outcome = measure(link_case, duration);
  if (!outcome) return outcome.error();
  report.rows.push_back(distribution("internet: age on arrival", "ms", outcome->far.ages_ms));
  report.rows.push_back(
      distribution("internet: error of room time", "us", outcome->far.clock_errors_us));
  report.figures.push_back(
      {"internet: sets delivered", "%",
       percent(static_cast<double>(outcome->far.sets.size()), outcome->sets_sent)});
  return {};
}

Status measure_narrow(std::chrono::milliseconds duration, LatencyReport& report) {
  const LinkCase link_case{.link = {.mbit_per_s = 10, .round_trip = 50ms}, .other_viewers = 20};
  auto outcome = measure(link_case, duration);
  if (!outcome) return outcome.error();
  report.rows.push_back(distribution("narrow: age on arrival", "ms", outcome->far.ages_ms));
  report.rows.push_back(distribution("narrow: age, other viewers", "ms", outcome->near_ages_ms));
  const double capacity =
      link_case.link.mbit_per_s * 1e6 / 8 * std::chrono::duration<double>(duration).count();
  report.figures.push_back(
      {"narrow: use of the link", "%", percent(outcome->link_bytes, capacity)});
  report.figures.push_back(
      {"narrow: sets delivered", "%",
       percent(static_cast<double>(outcome->far.sets.size()), outcome->sets_sent)});
  report.figures.push_back(
      {"narrow: partial sets", "", static_cast<double>(partial_sets(*outcome))});
  return {};
}

}  // namespace roomcast::bench
