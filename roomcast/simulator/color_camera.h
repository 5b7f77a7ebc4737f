// SPDX-License-Identifier: Apache-2.0
// ColorCamera: the colour camera of a simulated sensor: renders the incoming light and applies the
// camera's response to it. Const calls are thread-safe if every thread uses its own Work.
#pragma once

#include "roomcast/core/image.h"
#include "roomcast/core/parallel_rows.h"
#include "roomcast/simulator/people/moving_layer.h"
#include "roomcast/simulator/people/moving_picture.h"
#include "roomcast/simulator/people/moving_things.h"
#include "roomcast/simulator/sensing/auto_exposure.h"
#include "roomcast/simulator/sensing/color_response.h"
#include "roomcast/simulator/sensing/sensor_unit.h"
#include "roomcast/simulator/simulated_room.h"
#include "roomcast/simulator/tracing/static_plate.h"

namespace roomcast::simulator {

class ColorCamera {
 public:
  /// Memory of one thread, with the light at the instant of the last draw.
  struct Work {
    MovingLayer layer, meter_layer;
    MovingColors colors;
    ColorImage light, meter;
    std::array<float, 3> drift = {1, 1, 1};  // of the unit's gains, at that instant
  };

  ColorCamera(const SimulatedRoom& room, const SensorUnit& unit,
              const RigidTransform& world_from_color, const Workers& workers);

  [[nodiscard]] Work make_work() const;

  /// Renders the things in their current state. Must precede the other calls for each instant.
  void draw(const MovingThings& things, Work& work) const;
  /// Draws the things as a camera with this shutter sees them, at a scene time, and moves them.
  void draw_slowly(const Shutter& shutter, nanoseconds scene_time, MovingThings& things,
                   Work& work) const;
  /// The picture of the last draw with the unit's white balance and an exposure gain, without
  /// noise.
  void expose(float gain, const Work& work, ColorImage& color) const;
  /// As expose, with noise, which is a function of `key`.
  void read(float gain, std::uint32_t key, const Work& work, ColorImage& color) const;

  /// Mean linear light of a small picture of the things in their current state.
  [[nodiscard]] float brightness(const MovingThings& things, Work& work) const;
  /// An exposure control whose target is the brightness of the empty room.
  [[nodiscard]] AutoExposure auto_exposure() const { return AutoExposure(calm_brightness_); }

 private:
  void develop(const ColorResponse& response, std::uint32_t key, const Work& work,
               ColorImage& color) const;
  [[nodiscard]] std::array<float, 3> gains(float exposure, const Work& work) const;

  const SimulatedRoom& room_;
  std::array<float, 3> unit_gain_;
  PlacedCamera camera_, meter_camera_;
  ColorPlate plate_, meter_plate_;
  float calm_brightness_;
  GaussianTable gaussians_;
};

}  // namespace roomcast::simulator
