// SPDX-License-Identifier: Apache-2.0
// The surface of a solid as quads: one vertex for each cell of a grid that the surface passes
// through, in the middle of where it crosses the cell's edges. Closed, front faces
// counter-clockwise. Metres.
// Naive surface nets: after Gibson, "Constrained elastic surface nets", 1998.
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
