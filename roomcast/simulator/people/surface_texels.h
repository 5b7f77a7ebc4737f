// SPDX-License-Identifier: Apache-2.0
// The patterns of what moves, worked out once: clothes in motion are coloured by looking up texels,
// some ten times cheaper than evaluating the patterns at every pixel. Immutable after construction.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "roomcast/core/image.h"
#include "roomcast/simulator/people/moving_things.h"
#include "roomcast/simulator/scene/room.h"

namespace roomcast::simulator {

class SurfaceTexels {
 public:
  /// Of the surfaces that the things' meshes name.
  SurfaceTexels(const Room& room, const MovingThings& things);

  /// Albedo at a point of a surface (metres), bilinear, its fourth channel 0; what lies beyond the
  /// texels continues at their other side.
  [[nodiscard]] Eigen::Array4f at(SurfaceIndex surface, const Eigen::Vector2f& uv_m) const;

 private:
  struct Sheet {
    Image<Eigen::Array4f> texels;  // a power of two wide and high
    float per_m = 1.0F;
  };
  std::vector<Sheet> sheets_;  // by surface; without texels where nothing moving wears it
};

}  // namespace roomcast::simulator
