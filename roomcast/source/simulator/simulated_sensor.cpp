// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/simulated_sensor.h"

#include <cmath>

#include "roomcast/source/simulator/people/body_picture.h"
#include "roomcast/source/simulator/scene/value_noise.h"
#include "roomcast/source/simulator/sensing/kinect_calibration.h"

namespace roomcast {
namespace {

Status check(const SimulatedSensor::Options& options) {
  const std::string most = std::to_string(sim::kMaxSimulatedSensors);
  if (options.sensor_count < 1 || options.sensor_count > sim::kMaxSimulatedSensors) {
    return Error{ErrorCode::kInvalidArgument, "A simulated room has 1 to " + most +
                                                  " sensors, not " +
                                                  std::to_string(options.sensor_count) + "."};
  }
  if (options.sensor_index < 0 || options.sensor_index >= options.sensor_count) {
    return Error{ErrorCode::kInvalidArgument,
                 "There is no simulated sensor s" + std::to_string(options.sensor_index) +
                     "; this room has s0 to s" + std::to_string(options.sensor_count - 1) + "."};
  }
  return {};
}

RigidTransform stand_pose(const sim::SensorStand& stand) {
  return world_from_optical_looking_at(stand.eye_m.cast<double>(), stand.target_m.cast<double>());
}

DepthImage rounded_mm(const Image<float>& z_m) {
  DepthImage depth_mm(z_m.width(), z_m.height());
  for (std::size_t i = 0; i < z_m.view().pixel_count(); ++i) {
    depth_mm.data()[i] = static_cast<std::uint16_t>(1000.0F * z_m.data()[i] + 0.5F);
  }
  return depth_mm;
}

template <class T>
void copy_into(const Image<T>& from, Image<T>& to) {
  if (from.width() != to.width() || from.height() != to.height())
    to.resize(from.width(), from.height());
  std::copy_n(from.data(), from.view().pixel_count(), to.data());
}

}  // namespace

Result<std::unique_ptr<SimulatedSensor>> SimulatedSensor::open(const Options& options) {
  if (Status legal = check(options); !legal) return std::move(legal).error();
  auto built = sim::build_room(options.scene, options.seed);
  if (!built) return std::move(built).error();
  auto room = std::make_unique<const sim::Room>(*std::move(built));
  auto scene = sim::RayScene::build(room->mesh);  // needed for the plates only
  if (!scene) return std::move(scene).error();
  return std::unique_ptr<SimulatedSensor>(new SimulatedSensor(options, std::move(room), **scene));
}

SimulatedSensor::SimulatedSensor(const Options& options, std::unique_ptr<const sim::Room> room,
                                 const sim::RayScene& scene)
    : options_(options),
      room_(std::move(room)),
      calibration_(sim::kinect_calibration(options.sensor_index)),
      depth_camera_(calibration_.depth,
                    stand_pose(room_->stands[static_cast<std::size_t>(options.sensor_index)])),
      color_camera_(calibration_.color,
                    depth_camera_.world_from_camera() * calibration_.color_from_depth.inverse()),
      depth_plate_(sim::trace_depth_plate(*room_, scene, depth_camera_)),
      color_plate_(sim::trace_color_plate(*room_, scene, color_camera_)),
      plate_mm_(rounded_mm(depth_plate_.z_m)),
      clothes_(room_->clothes),
      body_in_depth_(calibration_.depth.width, calibration_.depth.height),
      body_in_color_(calibration_.color.width, calibration_.color.height),
      gaussians_(noise_key(~std::uint64_t{0})),
      depth_noise_(depth_plate_, gaussians_) {}

std::uint32_t SimulatedSensor::noise_key(std::uint64_t frame_index) const {
  const auto low = [](std::uint64_t value) { return static_cast<std::uint32_t>(value); };
  const auto seed = sim::hash_of(low(options_.seed), low(options_.seed >> 32));
  const auto sensor = sim::hash_of(seed, low(static_cast<std::uint64_t>(options_.sensor_index)));
  return sim::hash_of(sim::hash_of(sensor, low(frame_index)), low(frame_index >> 32));
}

sim::WalkingBody SimulatedSensor::body_at(nanoseconds scene_time) const {
  const double played = static_cast<double>(scene_time.count()) * options_.speed;
  return sim::WalkingBody::at(room_->walk, nanoseconds(std::llround(played)));
}

void SimulatedSensor::render(nanoseconds scene_time, std::uint64_t frame_index,
                             DepthImage& depth_mm, ColorImage& color, bool with_noise) {
  const auto body = body_at(scene_time);
  const auto key = noise_key(frame_index);
  copy_into(plate_mm_, depth_mm);
  copy_into(color_plate_.color, color);
  render_depth(body, key, with_noise, depth_mm.view());
  render_color(body, color.view());
  if (with_noise) sim::add_color_noise(key, gaussians_, color.view());
}

void SimulatedSensor::render_true_depth(nanoseconds scene_time, DepthImage& depth_mm) {
  copy_into(plate_mm_, depth_mm);
  render_depth(body_at(scene_time), 0, false, depth_mm.view());
}

void SimulatedSensor::render_moving(nanoseconds scene_time, MaskImage& moving) {
  DepthImage depth_mm;
  render_true_depth(scene_time, depth_mm);
  moving.resize(depth_mm.width(), depth_mm.height());
  for (std::size_t i = 0; i < moving.view().pixel_count(); ++i) {
    moving.data()[i] = depth_mm.data()[i] == plate_mm_.data()[i] ? 0 : 255;
  }
}

void SimulatedSensor::render_depth(const sim::WalkingBody& body, std::uint32_t key, bool with_noise,
                                   ImageView<std::uint16_t> out) {
  body_in_depth_.draw(body, depth_camera_);
  if (!with_noise) return sim::put_body_depth(body_in_depth_, depth_plate_, out);
  depth_noise_.read_plate(key, out);
  sim::put_noisy_body_depth(body, body_in_depth_, depth_camera_, depth_plate_, room_->clothes,
                            depth_noise_, key, out);
}

void SimulatedSensor::render_color(const sim::WalkingBody& body, ImageView<Rgb8> out) {
  body_in_color_.draw(body, color_camera_);
  sim::put_floor_shade(body, color_camera_, color_plate_, out);
  sim::put_body_color(body, body_in_color_, color_camera_, color_plate_, *room_, clothes_, out);
}

}  // namespace roomcast
