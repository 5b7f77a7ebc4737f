// SPDX-License-Identifier: Apache-2.0
// FloorShade: shading of the floor by people: a coarse map of the floor around them, computed from
// balls that approximate their bodies. A ball hides part of the sky above a point, and part of each
// lamp that it occludes. Reused from frame to frame. Metres; the map's cells are a few centimetres
// wide. Occlusion by balls: Quilez, "Sphere ambient occlusion" and "Sphere soft shadow".
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

  /// The visibly shaded part of the floor; x, z.
  [[nodiscard]] const Eigen::AlignedBox2f& area_m() const { return area_; }
  /// Remaining share of a display value at a point of that part, interpolated from four cells.
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
  Eigen::AlignedBox2f map_, area_;  // extent of the cells; its visibly shaded part
};

}  // namespace roomcast::simulator
