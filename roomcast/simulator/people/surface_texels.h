// SPDX-License-Identifier: Apache-2.0
// SurfaceTexels: precomputed patterns of the moving surfaces. Looking up texels of moving clothes
// is some ten times cheaper than evaluating the patterns at every pixel. Immutable after
// construction.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "roomcast/core/image.h"
#include "roomcast/simulator/people/moving_things.h"
#include "roomcast/simulator/scene/room.h"

namespace roomcast::simulator {

class SurfaceTexels {
 public:
  /// For the surfaces used by the meshes of `things`.
  SurfaceTexels(const Room& room, const MovingThings& things);

  /// Albedo at a point of a surface (metres), bilinear, fourth channel 0; coordinates wrap around.
  [[nodiscard]] Eigen::Array4f at(SurfaceIndex surface, const Eigen::Vector2f& uv_m) const;

 private:
  struct Sheet {
    Image<Eigen::Array4f> texels;  // width and height are powers of two
    float per_m = 1.0F;
  };
  std::vector<Sheet> sheets_;  // by surface; empty if no moving thing uses it
};

}  // namespace roomcast::simulator
