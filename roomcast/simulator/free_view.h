// SPDX-License-Identifier: Apache-2.0
// FreeView: the true view of a simulated room from a viewpoint without a sensor, for evaluating
// pictures rendered from the sensors' data. Colour as the sensors see it at gain 1, without noise.
// Metres, world frame of scene/room.h.
#pragma once

#include <span>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/image.h"
#include "roomcast/core/parallel_rows.h"
#include "roomcast/simulator/simulated_sensor.h"

namespace roomcast::simulator {

/// Maximum number of sensors in a visibility mask.
inline constexpr std::size_t kMaxSeeingSensors = 8;

class FreeView {
 public:
  /// Traces the empty room.
  FreeView(const SimulatedRoom& room, const CameraIntrinsics& lens,
           const RigidTransform& world_from_view, const Workers& workers);

  /// Renders the things in their current state.
  void look(const simulator::MovingThings& things);

  [[nodiscard]] const ColorImage& color() const { return color_; }
  [[nodiscard]] const DepthImage& depth_mm() const { return depth_mm_; }

  /// Bit i of a pixel is set if sensor i, whose clean depth of this instant is `sensor_depths[i]`,
  /// sees that surface point: it is inside the sensor's picture and range, and at most 12 mm behind
  /// the farthest of the four depth pixels around it.
  [[nodiscard]] MaskImage seen_by(std::span<const SimulatedSensor* const> sensors,
                                  std::span<const DepthImage> sensor_depths) const;

 private:
  const SimulatedRoom& room_;
  simulator::PlacedCamera camera_;
  simulator::ColorPlate plate_;
  simulator::MovingLayer layer_;
  simulator::MovingColors colors_;
  ColorImage color_;
  DepthImage depth_mm_;
};

/// Viewpoints of `count` people who stand in the room, away from its furniture, and look at
/// something that at least one sensor sees. Picks the candidates with the largest seen share from
/// many drawn by the seed, all different. Fewer if there is no space.
[[nodiscard]] std::vector<RigidTransform> free_viewpoints(
    const SimulatedRoom& room, std::span<const SimulatedSensor* const> sensors, int count,
    std::uint64_t seed);

}  // namespace roomcast::simulator
