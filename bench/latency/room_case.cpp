// SPDX-License-Identifier: Apache-2.0
// Measures the age of a picture at every stage, with three simulated sensors, a hub and a viewer on
// one machine.
#include <atomic>
#include <map>
#include <memory>
#include <thread>

#include "bench/latency/latency_cases.h"
#include "bench/latency/replayed_sensor.h"
#include "bench/latency/set_watcher.h"
#include "roomcast/client/subscriber.h"
#include "roomcast/hub/server/running_hub.h"

namespace roomcast::bench {

namespace {

using namespace std::chrono_literals;
constexpr int kSensors = 3, kSimulatedFrames = 45;
constexpr auto kWarmUp = 3s;  // time for the codec to adapt to the room

/// The age of pictures when a viewer could draw them.
class DecodedAges {
 public:
  explicit DecodedAges(const client::Subscriber& viewer)
      : thread_([this, &viewer](const std::stop_token& stop) { watch(viewer, stop); }) {}

  std::vector<double> finish() {
    thread_.request_stop();
    thread_.join();
    return std::move(ages_ms_);
  }
  void start_counting() { counts_ = true; }

 private:
  void watch(const client::Subscriber& viewer, const std::stop_token& stop) {
    std::map<SensorId, std::uint32_t> seen;
    std::uint64_t revision = 0;
    while (!stop.stop_requested()) {
      const auto room = viewer.wait_newer(revision, 50ms);
      const HostTime now = SteadyClock().now();
      revision = room->revision;
      for (const client::RoomSensor& sensor : room->sensors) {
        if (!sensor.picture) continue;
        const auto [known, is_new] = seen.try_emplace(sensor.id, sensor.picture->seq);
        if (!is_new && std::exchange(known->second, sensor.picture->seq) == sensor.picture->seq)
          continue;
        const std::chrono::duration<double, std::milli> age =
            now.time_since_epoch() - sensor.picture->capture_time.time_since_epoch();
        if (counts_) ages_ms_.push_back(age.count());
      }
    }
  }

  std::vector<double> ages_ms_;
  std::atomic<bool> counts_ = false;
  std::jthread thread_;
};

}  // namespace

Status measure_room(std::chrono::milliseconds duration, LatencyReport& report) {
  auto hub = hub::RunningHub::start({.port = 0});
  if (!hub) return hub.error();
  std::vector<std::unique_ptr<ReplayedSensor>> sensors;
  for (int i = 0; i < kSensors; ++i) {
    auto sensor = ReplayedSensor::start("sim#" + std::to_string(i), (*hub)->url(),
                                        {.frame_count = kSimulatedFrames});
    if (!sensor) return sensor.error();
    sensors.push_back(*std::move(sensor));
  }
  auto viewer =
      client::Subscriber::open({.hub_url = (*hub)->url(), .room = {}, .name = {}, .log = {}});
  if (!viewer) return viewer.error();
  SetWatcher watcher((*hub)->url());
  DecodedAges decoded(**viewer);
  std::this_thread::sleep_for(kWarmUp);
  (void)watcher.take();
  decoded.start_counting();
  std::this_thread::sleep_for(duration);

  const Arrivals arrivals = watcher.take();
  const auto decoded_ms = decoded.finish();
  std::vector<double> encoded_ms;
  for (const auto& sensor : sensors) {
    const auto of_sensor = sensor->finish();
    encoded_ms.insert(encoded_ms.end(), of_sensor.begin(), of_sensor.end());
  }
  std::vector<double> beyond_ms = decoded_ms;
  for (double& age : beyond_ms) age -= 1000 / ReplayOptions().fps;
  report.rows.push_back(distribution("room: encoded", "ms", encoded_ms));
  report.rows.push_back(distribution("room: arrived", "ms", arrivals.ages_ms));
  report.rows.push_back(distribution("room: decoded", "ms", decoded_ms));
  report.rows.push_back(distribution("room: decoded, beyond a period", "ms", beyond_ms));
  report.rows.push_back(distribution("room: error of room time", "us", arrivals.clock_errors_us));
  return {};
}

}  // namespace roomcast::bench
