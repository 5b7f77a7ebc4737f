// SPDX-License-Identifier: Apache-2.0
// What is to be seen of a simulated room from a place where no sensor stands: the truth for judging
// pictures that a renderer makes of the sensors' data. Colour is that of the sensors' light at gain
// 1, without noise. Metres, world frame of scene/room.h.
#pragma once

#include <span>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/image.h"
#include "roomcast/simulator/simulated_sensor.h"

namespace roomcast::simulator {

/// At most so many sensors fit into a mask of who sees a point.
inline constexpr std::size_t kMaxSeeingSensors = 8;

class FreeView {
 public:
  /// Traces the empty room on `threads` threads (0: all cores).
  FreeView(const SimulatedRoom& room, const CameraIntrinsics& lens,
           const RigidTransform& world_from_view, int threads);

  /// Looks at the things where they are now.
  void look(const simulator::MovingThings& things);

  [[nodiscard]] const ColorImage& color() const { return color_; }
  [[nodiscard]] const DepthImage& depth_mm() const { return depth_mm_; }

  /// Bit i of a pixel: sensor i, whose clean depth of this instant is `sensor_depths[i]`, sees that
  /// surface point: inside its picture and its range, and at most 12 mm behind the farthest of the
  /// four depth pixels about it.
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

/// Places of `count` people who stand in the room, away from its furniture, and look at what at
/// least one sensor sees: the best of many drawn from the seed, no two alike. Fewer where there is
/// no room.
[[nodiscard]] std::vector<RigidTransform> free_viewpoints(
    const SimulatedRoom& room, std::span<const SimulatedSensor* const> sensors, int count,
    std::uint64_t seed);

}  // namespace roomcast::simulator
