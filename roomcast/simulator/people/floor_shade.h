// SPDX-License-Identifier: Apache-2.0
// How much light people take from the floor: a coarse map of the floor about them, from the balls
// that stand for their bodies. A ball hides part of the sky over a point, and of each lamp it is in
// the way of. Reused from frame to frame. Metres; the map's cells are a few centimetres wide.
// Occlusion by balls: Quilez, "Sphere ambient occlusion" and "Sphere soft shadow".
#pragma once

#include <algorithm>
#include <span>

#include <Eigen/Geometry>

#include "roomcast/core/image.h"
#include "roomcast/simulator/people/moving_things.h"
#include "roomcast/simulator/scene/room.h"

namespace roomcast::simulator {

class FloorShade {
 public:
  void work_out(std::span<const ShadeBall> balls, const Room& room);

  /// The part of the floor that is visibly shaded; x, z.
  [[nodiscard]] const Eigen::AlignedBox2f& area_m() const { return area_; }
  /// Share of a display value that is left at a point of that part, by the nearest four cells.
  [[nodiscard]] float display_left(float x_m, float z_m) const {
    const float x = std::clamp((x_m - map_.min().x()) / kCell_m, 0.0F,
                               static_cast<float>(left_.width() - 1) - 0.001F);
    const float z = std::clamp((z_m - map_.min().y()) / kCell_m, 0.0F,
                               static_cast<float>(left_.height() - 1) - 0.001F);
    const int i = static_cast<int>(x);
    const int j = static_cast<int>(z);
    const float across = x - static_cast<float>(i);
    const float down = z - static_cast<float>(j);
    const float *near = &left_.at(i, j), *far = &left_.at(i, j + 1);
    return (1.0F - down) * ((1.0F - across) * near[0] + across * near[1]) +
           down * ((1.0F - across) * far[0] + across * far[1]);
  }

 private:
  static constexpr float kCell_m = 0.07F;

  Image<float> left_;
  Eigen::AlignedBox2f map_, area_;  // what the cells cover; what is visibly shaded of that
};

}  // namespace roomcast::simulator
