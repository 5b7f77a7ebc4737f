// SPDX-License-Identifier: Apache-2.0
// Ambient occlusion of one picture: worked out on every fourth pixel and interpolated between those that lie on the
// same surface, which costs a sixteenth of asking at every pixel. Const calls are thread-safe.
#pragma once

#include <Eigen/Core>

#include "roomcast/core/image.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/source/simulator/lighting.h"

namespace roomcast::sim {

class OpennessMap {
 public:
  /// `rays`: (x/z, y/z) per pixel of the picture.
  OpennessMap(const RayScene& scene, const RigidTransform& world_from_camera,
              ImageView<const Eigen::Vector2f> rays);

  /// At a point seen at pixel (x, y). Asks the scene where no neighbour lies on the same surface.
  [[nodiscard]] float at(int x, int y, const LitPoint& point) const;

 private:
  struct Node {
    LitPoint point;
    float openness = -1.0F;  // negative: nothing was seen there
  };

  const RayScene& scene_;
  Image<Node> nodes_;
};

}  // namespace roomcast::sim
