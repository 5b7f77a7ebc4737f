// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/simulated_source.h"

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>

#include "roomcast/source/simulator/simulated_room.h"
#include "roomcast/source/simulator/simulated_sensor.h"
#include "roomcast/source/simulator/simulated_spec.h"

namespace roomcast {
namespace {

constexpr nanoseconds kPhaseStep =
    std::chrono::microseconds(2300);  // between sensors, real time only
constexpr nanoseconds kDeviceOffset =
    std::chrono::milliseconds(1250);  // between the sensors' clocks

/// Sleeps until the host clock shows `instant`. False when `stop` was requested first.
bool sleep_until(HostTime instant, const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any wake;
  std::unique_lock lock(mutex);
  const std::chrono::steady_clock::time_point due(instant.time_since_epoch());
  wake.wait_until(lock, stop, due, [] { return false; });
  return !stop.stop_requested();
}

class SimulatedSource final : public FrameSource {
 public:
  SimulatedSource(std::unique_ptr<SimulatedSensor> sensor, int index, const SourceOptions& options)
      : sensor_(std::move(sensor)),
        moment_(sensor_->make_moment()),
        exposure_(sensor_->auto_exposure()),
        pace_(options.pace),
        period_s_(1.0 / options.sim_fps),
        phase_(pace_ == Pace::kRealTime ? kPhaseStep * index : nanoseconds{}),
        device_offset_(kDeviceOffset * (index + 1)) {
    description_.name = "s" + std::to_string(index);
    description_.calibration = sensor_->calibration();
    description_.world_from_depth = sensor_->world_from_depth();
    description_.fps = options.sim_fps;
    if (pace_ == Pace::kRealTime) next_instant_ = first_instant_after(SteadyClock().now());
  }

  const SensorDescription& description() const override { return description_; }

  Result<bool> next(CapturedFrame& frame, std::stop_token stop) override {
    if (stop.stop_requested()) return false;
    if (pace_ == Pace::kRealTime) {
      skip_missed_instants();
      if (!sleep_until(HostTime(time_of(next_instant_)), stop)) return false;
    }
    const nanoseconds scene_time = time_of(next_instant_++);
    frame.index = frame_count_++;
    frame.capture_time = HostTime(scene_time);
    frame.device_time = scene_time + device_offset_;
    sensor_->look(scene_time, moment_);
    sensor_->read_depth(frame.index, moment_, frame.depth_mm);
    const float exposure = sensor_->next_exposure(scene_time, moment_, exposure_);
    sensor_->read_color(frame.index, exposure, moment_, frame.color);
    return true;
  }

 private:
  [[nodiscard]] nanoseconds time_of(std::int64_t instant) const {
    return phase_ + nanoseconds(std::llround(static_cast<double>(instant) * period_s_ * 1e9));
  }
  [[nodiscard]] std::int64_t first_instant_after(HostTime now) const {
    const double since_phase_s =
        std::chrono::duration<double>(now.time_since_epoch() - phase_).count();
    return static_cast<std::int64_t>(std::ceil(since_phase_s / period_s_));
  }
  /// A caller that is late gets the newest instant that has passed, not all of them.
  void skip_missed_instants() {
    next_instant_ = std::max(next_instant_, first_instant_after(SteadyClock().now()) - 1);
  }

  std::unique_ptr<SimulatedSensor> sensor_;
  SimulatedSensor::Moment moment_;
  sim::AutoExposure exposure_;
  Pace pace_;
  double period_s_;
  nanoseconds phase_;
  nanoseconds device_offset_;
  SensorDescription description_;
  std::int64_t next_instant_ = 0;  // of the instants k / fps + phase
  std::uint64_t frame_count_ = 0;
};

}  // namespace

Result<std::unique_ptr<FrameSource>> open_simulated_source(const std::string& text,
                                                           int sensor_index,
                                                           const SourceOptions& options) {
  if (!(options.sim_fps > 0.0 && options.sim_fps <= kMaxSimulatedFps)) {
    return Error{ErrorCode::kInvalidArgument,
                 "A simulated source gives more than 0 and at most 120 frames per second."};
  }
  const auto spec = parse_simulated_spec(text);
  if (!spec) return spec.error();
  auto room = SimulatedRoom::build(spec->scene, options.sim_seed);
  if (!room) return std::move(room).error();
  SimulatedSensor::Options sensing;
  sensing.index = sensor_index;
  sensing.count = options.sim_sensor_count;
  sensing.seed = options.sim_seed;
  sensing.speed = spec->speed;
  sensing.sensing = spec->sensing;
  auto sensor = SimulatedSensor::open(*std::move(room), sensing);
  if (!sensor) return std::move(sensor).error();
  return std::unique_ptr<FrameSource>(
      std::make_unique<SimulatedSource>(*std::move(sensor), sensor_index, options));
}

}  // namespace roomcast
