// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/simulated_sensor.h"

#include <string>
#include <utility>
#include <vector>

#include "roomcast/core/assert.h"
#include "roomcast/simulator/random/value_noise.h"
#include "roomcast/simulator/tracing/foreign_light.h"

namespace roomcast::simulator {
namespace {

Status check(const SimulatedSensor::Options& options) {
  if (options.count < 1 || options.count > simulator::kMaxSimulatedSensors) {
    return Error{ErrorCode::kInvalidArgument,
                 "A simulated room has 1 to " + std::to_string(simulator::kMaxSimulatedSensors) +
                     " sensors, not " + std::to_string(options.count) + "."};
  }
  if (options.index < 0 || options.index >= options.count) {
    return Error{ErrorCode::kInvalidArgument,
                 "There is no simulated sensor s" + std::to_string(options.index) +
                     "; this room has s0 to s" + std::to_string(options.count - 1) + "."};
  }
  return {};
}

RigidTransform world_from_mount(const simulator::SensorMount& mount) {
  return world_from_optical_looking_at(mount.eye_m.cast<double>(), mount.target_m.cast<double>());
}

/// Devices test roughly whether the colour camera sees a surface, for their depth is noisy.
constexpr RegistrationOptions kDeviceRegistration{0.1, 0.1, 1};

}  // namespace

SimulatedSensor::Moment::Moment(const SimulatedSensor& sensor)
    : things_(sensor.room_->room(), sensor.options_.speed),
      depth_(sensor.depth_.make_work()),
      color_(sensor.color_.make_work()) {
  if (!sensor.unit_.registered_by) return;
  auto registration = Registration::create(*sensor.unit_.registered_by, kDeviceRegistration);
  ROOMCAST_ASSERT(registration);
  registration_ = *std::move(registration);
}

Result<std::unique_ptr<SimulatedSensor>> SimulatedSensor::open(
    std::shared_ptr<const SimulatedRoom> room, const Options& options) {
  if (Status legal = check(options); !legal) return std::move(legal).error();
  std::unique_ptr<SimulatedSensor> sensor(new SimulatedSensor(std::move(room), options));
  if (!options.workers.stop.stop_requested()) return sensor;
  return Error{ErrorCode::kClosed, "stopped while the simulated room was being prepared"};
}

SimulatedSensor::SimulatedSensor(std::shared_ptr<const SimulatedRoom> room, const Options& options)
    : room_(std::move(room)),
      options_(options),
      unit_(simulator::make_unit(options.sensing, options.seed, options.index)),
      world_from_depth_(
          world_from_mount(room_->room().sensor_mounts[static_cast<std::size_t>(options.index)]) *
          options.mount_from_depth),
      depth_(*room_, unit_, world_from_depth_, options.sensing, options.workers),
      color_(*room_, unit_, world_from_depth_ * unit_.exact.color_from_depth.inverse(),
             options.workers) {
  if (options.sensing.mutual_interference && options.sensing.noise)
    depth_.expose_to(light_of_others());
}

simulator::MutualInterference SimulatedSensor::light_of_others() const {
  std::vector<simulator::MutualInterference::Other> others;
  for (int i = 0; i < options_.count; ++i) {
    const auto& mount = room_->room().sensor_mounts[static_cast<std::size_t>(i)];
    const simulator::SensorUnit unit = simulator::make_unit(options_.sensing, options_.seed, i);
    if (i == options_.index ||
        !simulator::disturbs(unit.profile.principle, unit_.profile.principle)) {
      continue;
    }
    const simulator::PlacedCamera other(unit.exact.depth, world_from_mount(mount));
    others.push_back(
        {simulator::trace_foreign_light(room_->rays(), depth_.placed(), other, options_.workers),
         simulator::FrameClock(options_.timing, options_.fps, unit.key)});
  }
  return {unit_.profile, unit_.key, std::move(others)};
}

std::uint32_t SimulatedSensor::noise_key(std::uint64_t frame) const {
  const auto key = simulator::hash_of(unit_.key, 6);
  return simulator::hash_of(simulator::hash_of(key, static_cast<std::uint32_t>(frame)),
                            static_cast<std::uint32_t>(frame >> 32));
}

void SimulatedSensor::look(nanoseconds scene_time, Moment& moment) const {
  moment.scene_time_ = scene_time;
  if (unit_.shutter.takes_time())
    color_.draw_slowly(unit_.shutter, scene_time, moment.things_, moment.color_);
  moment.things_.move_to(scene_time);
  depth_.draw(moment.things_, moment.depth_);
  if (!unit_.shutter.takes_time()) color_.draw(moment.things_, moment.color_);
  moment.color_.drift = unit_.drift.gains(scene_time);
}

const DepthImage& SimulatedSensor::clean_depth_mm(const Moment& moment) const {
  return depth_.clean_mm(moment.depth_);
}

void SimulatedSensor::mark_moving(const Moment& moment, MaskImage& moving) const {
  depth_.mark_moving(moment.depth_, moving);
}

void SimulatedSensor::clean_color(float exposure, const Moment& moment, ColorImage& color) const {
  color_.expose(exposure, moment.color_, color);
}

void SimulatedSensor::read_depth(std::uint64_t frame, Moment& moment, DepthImage& depth_mm) const {
  depth_.read(moment.things_, noise_key(frame), moment.scene_time_, moment.depth_, depth_mm);
  if (unit_.registered_by) moment.reported_mm_ = depth_mm;
}

void SimulatedSensor::expected_depth(const Moment& moment, DepthImage& depth_mm) const {
  depth_.expect(moment.things_, moment.depth_, depth_mm);
}

void SimulatedSensor::read_color(std::uint64_t frame, float exposure, Moment& moment,
                                 ColorImage& color) const {
  if (!options_.sensing.noise) return color_.expose(exposure, moment.color_, color);
  color_.read(exposure, simulator::hash_of(noise_key(frame), 1), moment.color_, color);
  if (unit_.registered_by) register_color(moment, color);
}

/// As a device's driver does: black where there is no depth.
void SimulatedSensor::register_color(Moment& moment, ColorImage& color) const {
  std::swap(color, moment.unregistered_);
  const Status registered =
      moment.registration_->run(moment.reported_mm_, moment.unregistered_, moment.registered_);
  ROOMCAST_ASSERT(registered);
  std::swap(color, moment.registered_.color);
}

std::array<float, 3> SimulatedSensor::color_gains(float exposure, nanoseconds scene_time) const {
  std::array<float, 3> gains = unit_.color_gain;
  const std::array<float, 3> drift = unit_.drift.gains(scene_time);
  for (std::size_t i = 0; i < gains.size(); ++i) gains[i] *= exposure * drift[i];
  return gains;
}

float SimulatedSensor::next_exposure(nanoseconds scene_time, Moment& moment,
                                     simulator::AutoExposure& control) const {
  if (!options_.sensing.auto_exposure) return 1.0F;
  const float gain = control.next(scene_time);
  if (control.is_due(scene_time)) {
    moment.things_.move_to(scene_time);
    control.meter(scene_time, color_.brightness(moment.things_, moment.color_));
  }
  return gain;
}

}  // namespace roomcast::simulator
