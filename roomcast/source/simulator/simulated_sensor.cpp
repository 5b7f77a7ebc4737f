// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/simulated_sensor.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "roomcast/source/simulator/scene/value_noise.h"
#include "roomcast/source/simulator/sensing/kinect_calibration.h"

namespace roomcast {
namespace {

Status check(const SimulatedSensor::Options &options) {
  const std::string most = std::to_string(sim::kMaxSimulatedSensors);
  if (options.sensor_count < 1 ||
      options.sensor_count > sim::kMaxSimulatedSensors) {
    return Error{ErrorCode::kInvalidArgument,
                 "A simulated room has 1 to " + most + " sensors, not " +
                     std::to_string(options.sensor_count) + "."};
  }
  if (options.sensor_index < 0 ||
      options.sensor_index >= options.sensor_count) {
    return Error{ErrorCode::kInvalidArgument,
                 "There is no simulated sensor s" +
                     std::to_string(options.sensor_index) +
                     "; this room has s0 to s" +
                     std::to_string(options.sensor_count - 1) + "."};
  }
  return {};
}

RigidTransform stand_pose(const sim::SensorStand &stand) {
  return world_from_optical_looking_at(stand.eye_m.cast<double>(),
                                       stand.target_m.cast<double>());
}

DepthImage rounded_mm(const Image<float> &z_m) {
  DepthImage depth_mm(z_m.width(), z_m.height());
  for (std::size_t i = 0; i < z_m.view().pixel_count(); ++i) {
    depth_mm.data()[i] =
        static_cast<std::uint16_t>(1000.0F * z_m.data()[i] + 0.5F);
  }
  return depth_mm;
}

template <class T> void copy_into(const Image<T> &from, Image<T> &to) {
  if (from.width() != to.width() || from.height() != to.height())
    to.resize(from.width(), from.height());
  std::copy_n(from.data(), from.view().pixel_count(), to.data());
}

float nearest_z(const sim::MovingLayer &layer, const Image<float> &plate_z_m,
                int x, int y) {
  return sim::is_in_front(layer, plate_z_m, x, y) ? layer.z_m().at(x, y)
                                                  : plate_z_m.at(x, y);
}

sim::PixelBox grown(const sim::PixelBox &box, int width, int height) {
  return {std::max(0, box.left - 1), std::max(0, box.top - 1),
          std::min(width, box.right + 1), std::min(height, box.bottom + 1)};
}

constexpr std::array<std::array<int, 2>, 4> kNeighbours = {
    {{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

struct Beside {
  float z_m; // the neighbour across the largest step; the pixel's own depth
             // without one
  bool thing_near; // something moving is at this pixel or at a neighbour
};

Beside look_beside(const sim::MovingLayer &layer, const Image<float> &plate_z_m,
                   int x, int y) {
  const float here = nearest_z(layer, plate_z_m, x, y);
  Beside beside{here, sim::is_in_front(layer, plate_z_m, x, y)};
  for (const auto &[dx, dy] : kNeighbours) {
    const int nx = x + dx;
    const int ny = y + dy;
    if (nx < 0 || ny < 0 || nx >= plate_z_m.width() || ny >= plate_z_m.height())
      continue;
    beside.thing_near =
        beside.thing_near || sim::is_in_front(layer, plate_z_m, nx, ny);
    const float there = nearest_z(layer, plate_z_m, nx, ny);
    const bool larger = std::abs(there - here) > std::abs(beside.z_m - here);
    if (sim::is_depth_step(here, there) && larger)
      beside.z_m = there;
  }
  return beside;
}

void put_noisy_moving_depth(const sim::MovingThings &things,
                            const sim::MovingLayer &layer,
                            const sim::PlacedCamera &camera,
                            const sim::DepthPlate &plate, const sim::Room &room,
                            const sim::DepthNoise &noise, std::uint32_t key,
                            ImageView<std::uint16_t> depth_mm) {
  if (layer.box().empty())
    return;
  const sim::PixelBox box = grown(layer.box(), depth_mm.width, depth_mm.height);
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) {
      const Beside beside = look_beside(layer, plate.z_m, x, y);
      if (!beside.thing_near)
        continue;
      sim::PerfectReading reading{plate.z_m.at(x, y), plate.facing.at(x, y),
                                  plate.infrared.at(x, y), beside.z_m};
      if (sim::is_in_front(layer, plate.z_m, x, y)) {
        const sim::MovingPoint point =
            sim::moving_point(things, layer, camera, x, y);
        reading.z_m = layer.z_m().at(x, y);
        reading.facing = point.facing;
        reading.infrared = room.surfaces[point.surface].infrared;
      }
      const auto pixel = static_cast<std::uint32_t>(y * depth_mm.width + x);
      depth_mm.at(x, y) = noise.read(reading, key, pixel);
    }
  }
}

} // namespace

Result<std::unique_ptr<SimulatedSensor>>
SimulatedSensor::open(const Options &options) {
  if (Status legal = check(options); !legal)
    return std::move(legal).error();
  auto built = sim::build_room(options.scene, options.seed);
  if (!built)
    return std::move(built).error();
  auto room = std::make_unique<const sim::Room>(*std::move(built));
  auto scene = sim::RayScene::build(room->mesh); // needed for the plates only
  if (!scene)
    return std::move(scene).error();
  return std::unique_ptr<SimulatedSensor>(
      new SimulatedSensor(options, std::move(room), **scene));
}

SimulatedSensor::SimulatedSensor(const Options &options,
                                 std::unique_ptr<const sim::Room> room,
                                 const sim::RayScene &scene)
    : options_(options), room_(std::move(room)),
      calibration_(sim::kinect_calibration(options.sensor_index)),
      depth_camera_(
          calibration_.depth,
          stand_pose(
              room_->stands[static_cast<std::size_t>(options.sensor_index)])),
      color_camera_(calibration_.color,
                    depth_camera_.world_from_camera() *
                        calibration_.color_from_depth.inverse()),
      depth_plate_(sim::trace_depth_plate(*room_, scene, depth_camera_)),
      color_plate_(sim::trace_color_plate(*room_, scene, color_camera_)),
      plate_mm_(rounded_mm(depth_plate_.z_m)), things_(*room_, options.speed),
      texels_(*room_, things_),
      things_in_depth_(calibration_.depth.width, calibration_.depth.height),
      things_in_color_(calibration_.color.width, calibration_.color.height),
      gaussians_(noise_key(~std::uint64_t{0})),
      depth_noise_(depth_plate_, gaussians_) {}

std::uint32_t SimulatedSensor::noise_key(std::uint64_t frame_index) const {
  const auto low = [](std::uint64_t value) {
    return static_cast<std::uint32_t>(value);
  };
  const auto seed = sim::hash_of(low(options_.seed), low(options_.seed >> 32));
  const auto sensor = sim::hash_of(
      seed, low(static_cast<std::uint64_t>(options_.sensor_index)));
  return sim::hash_of(sim::hash_of(sensor, low(frame_index)),
                      low(frame_index >> 32));
}

void SimulatedSensor::render(nanoseconds scene_time, std::uint64_t frame_index,
                             DepthImage &depth_mm, ColorImage &color,
                             bool with_noise) {
  things_.move_to(scene_time);
  const auto key = noise_key(frame_index);
  copy_into(plate_mm_, depth_mm);
  copy_into(color_plate_.color, color);
  render_depth(key, with_noise, depth_mm.view());
  render_color(color.view());
  if (with_noise)
    sim::add_color_noise(key, gaussians_, color.view());
}

void SimulatedSensor::render_true_depth(nanoseconds scene_time,
                                        DepthImage &depth_mm) {
  copy_into(plate_mm_, depth_mm);
  things_.move_to(scene_time);
  render_depth(0, false, depth_mm.view());
}

void SimulatedSensor::render_moving(nanoseconds scene_time, MaskImage &moving) {
  DepthImage depth_mm;
  render_true_depth(scene_time, depth_mm);
  moving.resize(depth_mm.width(), depth_mm.height());
  for (std::size_t i = 0; i < moving.view().pixel_count(); ++i) {
    moving.data()[i] = depth_mm.data()[i] == plate_mm_.data()[i] ? 0 : 255;
  }
}

void SimulatedSensor::render_depth(std::uint32_t key, bool with_noise,
                                   ImageView<std::uint16_t> out) {
  things_in_depth_.draw(things_, depth_camera_);
  if (!with_noise)
    return sim::put_moving_depth(things_in_depth_, depth_plate_, out);
  depth_noise_.read_plate(key, out);
  put_noisy_moving_depth(things_, things_in_depth_, depth_camera_, depth_plate_,
                         *room_, depth_noise_, key, out);
}

void SimulatedSensor::render_color(ImageView<Rgb8> out) {
  things_in_color_.draw(things_, color_camera_);
  moving_colors_.light(things_, *room_);
  moving_colors_.put_shade(*room_, color_camera_, color_plate_, out);
  moving_colors_.put(things_, things_in_color_, color_plate_, texels_, out);
}

} // namespace roomcast
