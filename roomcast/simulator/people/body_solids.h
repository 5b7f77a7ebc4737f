// SPDX-License-Identifier: Apache-2.0
// The shapes of a person's clothes, head, hair, hands and shoes around the bones of the cutting
// pose. Each piece covers the pieces under it, so hems and cuffs are where a cloth ends. Metres.
#pragma once

#include <vector>

#include "roomcast/simulator/people/skeleton.h"
#include "roomcast/simulator/people/solid.h"

namespace roomcast::simulator {

struct BodyPiece {
  Solid solid;
  SurfaceIndex surface = 0;
  float cell_m = 0.02F;     // of the grid it is meshed with
  std::vector<Bone> bones;  // bones that it follows
};

/// Ordered from the outermost piece inwards.
[[nodiscard]] std::vector<BodyPiece> body_pieces(const Build& build, const Outfit& outfit,
                                                 const Pose& cutting, const Measures& measures);

}  // namespace roomcast::simulator
