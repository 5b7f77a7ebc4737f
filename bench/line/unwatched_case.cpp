// SPDX-License-Identifier: Apache-2.0
// Measures simulated sensors, a hub and a viewer in this process, first watched, then unwatched.
#include <algorithm>
#include <cstdint>
#include <ctime>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "bench/latency/set_watcher.h"
#include "bench/line/line_bench.h"
#include "roomcast/client/subscriber.h"
#include "roomcast/hub/room/frame_demand.h"
#include "roomcast/hub/server/running_hub.h"
#include "roomcast/sensor/sensor_feed.h"
#include "roomcast/sensor/source_factory.h"

namespace roomcast::bench {
namespace {

using namespace std::chrono_literals;

constexpr auto kWarmUp = 5s;     // bundles are sent, the codec has adapted to the room
constexpr auto kPatience = 10s;  // for a first picture

struct Feeds {
  std::vector<std::unique_ptr<sensor::SensorFeed>> all;

  [[nodiscard]] double bytes_sent() const {
    double bytes = 0;
    for (const auto& feed : all) bytes += static_cast<double>(feed->stats().bytes_sent);
    return bytes;
  }
};

Result<Feeds> start_feeds(const LineBenchOptions& options, const std::string& hub_url) {
  Feeds feeds;
  for (int i = 0; i < options.sensors; ++i) {
    sensor::SourceOptions sim;
    sim.sim_sensor_count = options.sensors;
    auto source = sensor::open_source("sim:" + options.scene + "#" + std::to_string(i), sim);
    if (!source) return source.error();
    sensor::SensorFeedOptions feed;
    feed.hub_url = hub_url;
    auto started = sensor::SensorFeed::start(*std::move(source), feed);
    if (!started) return started.error();
    feeds.all.push_back(*std::move(started));
  }
  return feeds;
}

struct Cost {
  double bytes_per_s = 0, cpu_share = 0;  // of one core
};

Cost measure(const Feeds& feeds, std::chrono::milliseconds duration) {
  const double bytes = feeds.bytes_sent();
  const std::clock_t cpu = std::clock();
  const HostTime began = SteadyClock().now();
  std::this_thread::sleep_for(duration);
  const double seconds = std::chrono::duration<double>(SteadyClock().now() - began).count();
  return {(feeds.bytes_sent() - bytes) / seconds,
          static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC / seconds};
}

/// Time from connecting until a viewer has decoded a picture of each sensor, ms; nothing: it never
/// had.
std::optional<double> time_to_whole_picture(const std::string& hub_url, std::size_t sensors) {
  const HostTime began = SteadyClock().now();
  const auto viewer =
      client::Subscriber::open({.hub_url = hub_url, .room = {}, .name = {}, .log = {}});
  if (!viewer) return std::nullopt;
  std::uint64_t revision = 0;
  while (SteadyClock().now() < began + kPatience) {
    const auto room = (*viewer)->wait_newer(revision, 50ms);
    revision = room->revision;
    const auto shown = std::ranges::count_if(
        room->sensors, [](const client::RoomSensor& sensor) { return sensor.picture != nullptr; });
    if (static_cast<std::size_t>(shown) == sensors)
      return std::chrono::duration<double, std::milli>(SteadyClock().now() - began).count();
  }
  return std::nullopt;
}

void wait_until_unwatched() {
  std::this_thread::sleep_for(hub::FrameDemand::kKeptUnwatched + 1s);
}

}  // namespace

Status measure_unwatched(const LineBenchOptions& options,
                         const std::function<void(const std::string&)>& progress,
                         LineReport& report) {
  const auto say = [&](const std::string& what) {
    if (progress) progress(what);
  };
  say("starting the sensors");
  auto hub = hub::RunningHub::start({.port = 0});
  if (!hub) return hub.error();
  auto feeds = start_feeds(options, (*hub)->url());
  if (!feeds) return feeds.error();
  auto viewer = std::make_unique<SetWatcher>((*hub)->url());
  std::this_thread::sleep_for(kWarmUp);
  say("with a viewer");
  const Cost watched = measure(*feeds, options.duration);
  viewer.reset();
  wait_until_unwatched();
  say("without a viewer");
  const Cost unwatched = measure(*feeds, options.duration);

  std::vector<double> waits_ms;
  for (int i = 0; i < options.first_viewers; ++i) {
    say("a first viewer, " + std::to_string(i + 1) + " of " +
        std::to_string(options.first_viewers));
    const auto wait_ms =
        time_to_whole_picture((*hub)->url(), static_cast<std::size_t>(options.sensors));
    if (!wait_ms) return Error{ErrorCode::kUnavailable, "no picture of all sensors came in 10 s"};
    waits_ms.push_back(*wait_ms);
    wait_until_unwatched();
  }

  report.figures.push_back({"unwatched: bytes, watched", "kB/s", watched.bytes_per_s / 1e3});
  report.figures.push_back({"unwatched: bytes", "kB/s", unwatched.bytes_per_s / 1e3});
  report.figures.push_back(
      {"unwatched: bytes", "% of watched", 100 * unwatched.bytes_per_s / watched.bytes_per_s});
  report.figures.push_back({"unwatched: CPU, watched", "cores", watched.cpu_share});
  report.figures.push_back({"unwatched: CPU", "cores", unwatched.cpu_share});
  report.figures.push_back(
      {"unwatched: CPU", "% of watched", 100 * unwatched.cpu_share / watched.cpu_share});
  if (!waits_ms.empty()) {
    report.figures.push_back({"unwatched: first viewer's wait for all sensors, longest", "ms",
                              *std::ranges::max_element(waits_ms)});
  }
  return {};
}

}  // namespace roomcast::bench
