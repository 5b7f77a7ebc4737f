// SPDX-License-Identifier: Apache-2.0
// Meshes the surface of a solid with quads: one vertex per grid cell that the surface passes
// through, at the mean of its crossings with the cell's edges. Closed, front faces
// counter-clockwise. Metres. Naive surface nets: after Gibson, "Constrained elastic surface nets",
// 1998.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "roomcast/simulator/people/solid.h"

namespace roomcast::simulator {

struct SurfaceNet {
  std::vector<Eigen::Vector3f> positions;
  std::vector<std::array<std::uint32_t, 4>> quads;
};

[[nodiscard]] SurfaceNet surface_net(const Solid& solid, float cell_m);

}  // namespace roomcast::simulator
