// SPDX-License-Identifier: Apache-2.0
// How much light people take from the floor: a coarse map of the floor about them, from the balls
// that stand for their bodies. A ball hides part of the sky over a point, and of each lamp it is in
// the way of. Reused from frame to frame. Metres; the map's cells are a few centimetres wide.
// Occlusion by balls: Quilez, "Sphere ambient occlusion" and "Sphere soft shadow".
#pragma once

#include <span>

#include <Eigen/Geometry>

#include "roomcast/core/image.h"
#include "roomcast/source/simulator/people/moving_things.h"
#include "roomcast/source/simulator/scene/room.h"

namespace roomcast::sim {

class FloorShade {
 public:
  void work_out(std::span<const ShadeBall> balls, const Room& room);

  /// The part of the floor that is shaded at all; x, z.
  [[nodiscard]] const Eigen::AlignedBox2f& area_m() const { return area_; }
  /// Share of the light that is left at a point of the floor, by the nearest four cells.
  [[nodiscard]] float light_left(float x_m, float z_m) const;

 private:
  Image<float> left_;
  Eigen::AlignedBox2f area_;
};

}  // namespace roomcast::sim
