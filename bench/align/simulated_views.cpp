// SPDX-License-Identifier: Apache-2.0
#include "bench/align/simulated_views.h"

#include <ctime>
#include <utility>

#include "roomcast/alignment/bundle/bundle_capture.h"
#include "roomcast/simulator/simulated_room.h"
#include "roomcast/simulator/simulated_sensor.h"

namespace roomcast::bench {
namespace {

/// Interval between the frames of a bundle: long enough that a person who walks by has left most of
/// them.
constexpr nanoseconds kFrameGap = std::chrono::milliseconds(800);

Result<alignment::CalibrationBundle> capture(const simulator::SimulatedSensor& sensor,
                                             const std::string& name, int frames) {
  alignment::BundleCapture capture(name, sensor.calibration());
  auto moment = sensor.make_moment();
  auto exposure = sensor.auto_exposure();
  DepthImage depth_mm;
  ColorImage color;
  for (int i = 0; i < frames; ++i) {
    const auto frame = static_cast<std::uint64_t>(i);
    const nanoseconds time = i * kFrameGap;
    const float gain = sensor.next_exposure(time, moment, exposure);
    sensor.look(time, moment);
    sensor.read_depth(frame, moment, depth_mm);
    sensor.read_color(frame, gain, moment, color);
    if (const auto added = capture.add(depth_mm, color); !added) return added.error();
  }
  return capture.finish();
}

Result<SimulatedView> simulate_view(const std::shared_ptr<const simulator::SimulatedRoom>& room,
                                    const SimulatedViewsOptions& options, int index) {
  const auto sensor = simulator::SimulatedSensor::open(
      room, {index, options.sensors, options.seed, 1.0, 1, options.sensing});
  if (!sensor) return sensor.error();
  SimulatedView seen{nullptr, (*sensor)->world_from_depth(), 0};
  const auto bundle = capture(**sensor, "s" + std::to_string(index), options.frames);
  if (!bundle) return seen;
  const std::clock_t start = std::clock();
  auto view = alignment::make_sensor_view(*bundle);
  seen.look_cpu_s = double(std::clock() - start) / CLOCKS_PER_SEC;
  if (view) seen.view = std::make_shared<const alignment::SensorView>(std::move(*view));
  return seen;
}

}  // namespace

Result<std::vector<SimulatedView>> simulate_views(const SimulatedViewsOptions& options) {
  const auto room = simulator::SimulatedRoom::build(options.scene, options.seed);
  if (!room) return room.error();
  std::vector<SimulatedView> views;
  for (int i = 0; i < options.sensors && views.size() < options.only_first; ++i) {
    auto view = simulate_view(*room, options, i);
    if (!view) return view.error();
    views.push_back(std::move(*view));
  }
  return views;
}

}  // namespace roomcast::bench
