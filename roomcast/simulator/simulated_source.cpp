// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/simulated_source.h"

#include <chrono>
#include <cmath>
#include <optional>

#include "roomcast/core/interruptible_wait.h"
#include "roomcast/simulator/simulated_room.h"
#include "roomcast/simulator/simulated_sensor.h"
#include "roomcast/simulator/simulated_spec.h"

namespace roomcast::simulator {
namespace {

constexpr nanoseconds kPhaseStep =
    std::chrono::microseconds(2300);  // between sensors, real time only
constexpr nanoseconds kDeviceOffset =
    std::chrono::milliseconds(1250);  // between the sensors' clocks

class SimulatedSource final : public source::FrameSource {
 public:
  SimulatedSource(std::unique_ptr<SimulatedSensor> sensor, int index,
                  const SimulatedSourceOptions& options)
      : mounted_(std::move(sensor)),
        pace_(options.pace),
        period_s_(1.0 / options.fps),
        phase_(pace_ == source::Pace::kRealTime ? kPhaseStep * index : nanoseconds{}),
        device_offset_(kDeviceOffset * (index + 1)) {
    description_.name = "s" + std::to_string(index);
    description_.calibration = mounted_.sensor->calibration();
    description_.world_from_depth = mounted_.sensor->world_from_depth();
    description_.fps = options.fps;
    if (pace_ == source::Pace::kRealTime) next_instant_ = first_instant_after(SteadyClock().now());
  }

  /// Replaces the sensor by `moved` from that time on.
  void bump_at(nanoseconds after_opening, std::unique_ptr<SimulatedSensor> moved) {
    bump_ = Bump{time_of(next_instant_) + after_opening, MountedSensor(std::move(moved))};
  }

  /// The room is as `other` sees it in every second stretch of this length.
  void rearrange_every(nanoseconds stretch, std::unique_ptr<SimulatedSensor> other) {
    rearranged_ = Rearranged{stretch, MountedSensor(std::move(other))};
  }

  const source::SensorDescription& description() const override { return description_; }

  Result<bool> next(source::CapturedFrame& frame, std::stop_token stop) override {
    if (stop.stop_requested()) return false;
    if (pace_ == source::Pace::kRealTime) {
      skip_missed_instants();
      if (!wait_until(HostTime(time_of(next_instant_)), stop)) return false;
    }
    const nanoseconds scene_time = time_of(next_instant_++);
    frame.index = frame_count_++;
    frame.capture_time = HostTime(scene_time);
    frame.device_time = scene_time + device_offset_;
    capture(mounted_at(scene_time), scene_time, frame);
    return true;
  }

 private:
  /// The sensor at one pose, with the memory of one thread.
  struct MountedSensor {
    explicit MountedSensor(std::unique_ptr<SimulatedSensor> opened)
        : sensor(std::move(opened)),
          moment(sensor->make_moment()),
          exposure(sensor->auto_exposure()) {}
    std::unique_ptr<SimulatedSensor> sensor;
    SimulatedSensor::Moment moment;
    simulator::AutoExposure exposure;
  };
  struct Bump {
    nanoseconds at;  // scene time
    MountedSensor mounted;
  };

  struct Rearranged {
    nanoseconds stretch;  // scene time
    MountedSensor mounted;
  };

  MountedSensor& mounted_at(nanoseconds scene_time) {
    if (bump_ && scene_time >= bump_->at) return bump_->mounted;
    const bool is_other = rearranged_ && (scene_time / rearranged_->stretch) % 2 == 1;
    return is_other ? rearranged_->mounted : mounted_;
  }

  static void capture(MountedSensor& mounted, nanoseconds scene_time,
                      source::CapturedFrame& frame) {
    const SimulatedSensor& sensor = *mounted.sensor;
    sensor.look(scene_time, mounted.moment);
    sensor.read_depth(frame.index, mounted.moment, frame.depth_mm);
    const float exposure = sensor.next_exposure(scene_time, mounted.moment, mounted.exposure);
    sensor.read_color(frame.index, exposure, mounted.moment, frame.color);
  }

  [[nodiscard]] nanoseconds time_of(std::int64_t instant) const {
    return phase_ + nanoseconds(std::llround(static_cast<double>(instant) * period_s_ * 1e9));
  }
  [[nodiscard]] std::int64_t first_instant_after(HostTime now) const {
    const double since_phase_s =
        std::chrono::duration<double>(now.time_since_epoch() - phase_).count();
    return static_cast<std::int64_t>(std::ceil(since_phase_s / period_s_));
  }
  /// A late caller gets the newest instant that has passed; older ones are skipped.
  void skip_missed_instants() {
    next_instant_ = std::max(next_instant_, first_instant_after(SteadyClock().now()) - 1);
  }

  MountedSensor mounted_;
  std::optional<Bump> bump_;
  std::optional<Rearranged> rearranged_;
  source::Pace pace_;
  double period_s_;
  nanoseconds phase_;
  nanoseconds device_offset_;
  source::SensorDescription description_;
  std::int64_t next_instant_ = 0;  // index k of the instants k / fps + phase
  std::uint64_t frame_count_ = 0;
};

}  // namespace

Result<std::unique_ptr<source::FrameSource>> open_simulated_source(
    const std::string& text, int sensor_index, const SimulatedSourceOptions& options) {
  if (!(options.fps > 0.0 && options.fps <= kMaxSimulatedFps)) {
    return Error{ErrorCode::kInvalidArgument,
                 "A simulated source gives more than 0 and at most 120 frames per second."};
  }
  const auto spec = parse_simulated_spec(text);
  if (!spec) return spec.error();
  const Visitor visitor = spec->board ? Visitor::kBoardBearer : Visitor::kNone;
  const auto cabinet = spec->cabinet_s ? std::optional(0) : std::nullopt;
  auto room = SimulatedRoom::build(spec->scene, options.seed, visitor, cabinet);
  if (!room) return std::move(room).error();
  SimulatedSensor::Options sensing;
  sensing.index = sensor_index;
  sensing.count = options.sensor_count;
  sensing.seed = options.seed;
  sensing.speed = spec->speed;
  sensing.sensing = spec->sensing;
  sensing.fps = options.fps;
  sensing.workers = options.workers;
  auto sensor = SimulatedSensor::open(*room, sensing);
  if (!sensor) return std::move(sensor).error();
  auto source = std::make_unique<SimulatedSource>(*std::move(sensor), sensor_index, options);
  if (spec->bump_at_s) {
    sensing.mount_from_depth = spec->bump.mount_from_depth();
    auto moved = SimulatedSensor::open(*room, sensing);
    if (!moved) return std::move(moved).error();
    source->bump_at(nanoseconds(std::llround(1e9 * *spec->bump_at_s)), *std::move(moved));
  }
  if (spec->cabinet_s && *spec->cabinet_s > 0) {
    auto rearranged = SimulatedRoom::build(spec->scene, options.seed, visitor, 1);
    if (!rearranged) return std::move(rearranged).error();
    auto other = SimulatedSensor::open(*rearranged, sensing);
    if (!other) return std::move(other).error();
    source->rearrange_every(nanoseconds(std::llround(1e9 * *spec->cabinet_s)), *std::move(other));
  }
  return std::unique_ptr<source::FrameSource>(std::move(source));
}

}  // namespace roomcast::simulator
