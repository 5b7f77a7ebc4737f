// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/color_camera.h"

#include <algorithm>
#include <utility>

namespace roomcast::simulator {
namespace {

constexpr double kMeterWidth = 48.0;  // pixels

struct Look {
  const PlacedCamera& camera;
  const ColorPlate& plate;
};

/// Renders the static room and the moving things through one camera.
void look(const SimulatedRoom& room, const MovingThings& things, const Look& at, MovingLayer& layer,
          MovingColors& colors, ColorImage& light) {
  const ColorImage& still = at.plate.color;
  if (!same_size(still.view(), light.view())) light.resize(still.width(), still.height());
  std::copy_n(still.data(), still.view().pixel_count(), light.data());
  layer.draw(things, at.camera);
  colors.light(things, room.room());
  colors.put_shade(room.room(), at.camera, at.plate, light.view());
  colors.put(things, layer, at.plate, room.texels(), light.view());
}

}  // namespace

ColorCamera::ColorCamera(const SimulatedRoom& room, const SensorUnit& unit,
                         const RigidTransform& world_from_color, const Workers& workers)
    : room_(room),
      unit_gain_(unit.color_gain),
      camera_(unit.exact.color, world_from_color),
      meter_camera_(resampled(unit.exact.color, kMeterWidth / unit.exact.color.width),
                    world_from_color),
      plate_(trace_color_plate(room.room(), room.rays(), camera_, workers)),
      meter_plate_(trace_color_plate(room.room(), room.rays(), meter_camera_, workers)),
      calm_brightness_(mean_brightness(meter_plate_.color)) {}

ColorCamera::Work ColorCamera::make_work() const {
  return {MovingLayer(camera_.width(), camera_.height()),
          MovingLayer(meter_camera_.width(), meter_camera_.height()),
          {},
          {},
          {},
          {1, 1, 1}};
}

void ColorCamera::draw(const MovingThings& things, Work& work) const {
  look(room_, things, {camera_, plate_}, work.layer, work.colors, work.light);
}

void ColorCamera::draw_slowly(const Shutter& shutter, nanoseconds scene_time, MovingThings& things,
                              Work& work) const {
  std::array<ColorImage, kShutterInstants> lights;
  const auto instants = shutter.instants();
  for (std::size_t i = 0; i < lights.size(); ++i) {
    things.move_to(scene_time + instants[i]);
    draw(things, work);
    lights[i] = std::move(work.light);
    work.light = ColorImage();
  }
  work.light.resize(lights[0].width(), lights[0].height());
  expose_rows(shutter, lights, work.light.view());
}

float ColorCamera::brightness(const MovingThings& things, Work& work) const {
  look(room_, things, {meter_camera_, meter_plate_}, work.meter_layer, work.colors, work.meter);
  return mean_brightness(work.meter);
}

std::array<float, 3> ColorCamera::gains(float exposure, const Work& work) const {
  return {exposure * unit_gain_[0] * work.drift[0], exposure * unit_gain_[1] * work.drift[1],
          exposure * unit_gain_[2] * work.drift[2]};
}

void ColorCamera::develop(const ColorResponse& response, std::uint32_t key, const Work& work,
                          ColorImage& color) const {
  if (!same_size(work.light.view(), color.view()))
    color.resize(work.light.width(), work.light.height());
  response.expose(work.light, key, gaussians_, color.view());
}

void ColorCamera::expose(float gain, const Work& work, ColorImage& color) const {
  develop(ColorResponse(gains(gain, work), false), 0, work, color);
}

void ColorCamera::read(float gain, std::uint32_t key, const Work& work, ColorImage& color) const {
  develop(ColorResponse(gains(gain, work), true), key, work, color);
}

}  // namespace roomcast::simulator
