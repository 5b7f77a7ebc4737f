// SPDX-License-Identifier: Apache-2.0
// The colour camera of a simulated sensor in its room: the light that reaches it, and what it makes
// of that. Const calls are thread-safe as long as every thread brings its own Work.
#pragma once

#include "roomcast/core/image.h"
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
  /// Memory of one thread, and what is to be seen at the instant it was last drawn for.
  struct Work {
    MovingLayer layer, meter_layer;
    MovingColors colors;
    ColorImage light, meter;
  };

  ColorCamera(const SimulatedRoom& room, const SensorUnit& unit,
              const RigidTransform& world_from_color, int threads);

  [[nodiscard]] Work make_work() const;

  /// Looks at the things where they are now. First of all for every instant.
  void draw(const MovingThings& things, Work& work) const;
  /// The picture of the last draw with the unit's own colours and an exposure gain.
  void expose(float gain, const Work& work, ColorImage& color) const;
  /// The same with noise, a function of the key.
  void read(float gain, std::uint32_t key, const Work& work, ColorImage& color) const;

  /// Mean linear light of a small picture of the things where they are now.
  [[nodiscard]] float brightness(const MovingThings& things, Work& work) const;
  /// A control that steers for the brightness of the empty room.
  [[nodiscard]] AutoExposure auto_exposure() const { return AutoExposure(calm_brightness_); }

 private:
  void develop(const ColorResponse& response, std::uint32_t key, const Work& work,
               ColorImage& color) const;
  [[nodiscard]] std::array<float, 3> gains(float exposure) const;

  const SimulatedRoom& room_;
  std::array<float, 3> unit_gain_;
  PlacedCamera camera_, meter_camera_;
  ColorPlate plate_, meter_plate_;
  float calm_brightness_;
  GaussianTable gaussians_;
};

}  // namespace roomcast::simulator
