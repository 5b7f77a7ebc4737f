// SPDX-License-Identifier: Apache-2.0
// Candidate surfaces that predict those of a block. Shared by encoder and decoder.
// docs/spec/codec.md §2.4.4.
#pragma once

#include <algorithm>
#include <array>

#include "roomcast/codec/live/live_state.h"

namespace roomcast::codec {

inline constexpr std::int32_t kMaxCoefficient = 1 << 20;
[[nodiscard]] constexpr std::int32_t limited(std::int64_t coefficient) {
  return static_cast<std::int32_t>(
      std::clamp<std::int64_t>(coefficient, -kMaxCoefficient, kMaxCoefficient));
}

/// The surface, extended by one block to the right or downwards.
[[nodiscard]] inline SurfaceParameters continued(SurfaceParameters surface, bool right, bool down) {
  // A slope coefficient of c changes the mean coefficient of the next block by -3.512 c.
  constexpr std::int64_t kStep = 899;  // in 1/256
  const std::int64_t along =
      (right ? surface.slope_x : 0) + std::int64_t{down ? surface.slope_y : 0};
  surface.mean = limited(surface.mean - (along * kStep >> 8));
  return surface;
}

using SurfaceCandidates = std::array<SurfaceParameters, kSurfaceCandidates>;

/// Candidates for surface `which` (0, 1) of the block `here`: left and upper block (same surface),
/// the block itself in the reference frame, left and upper block (the other surface), the surface
/// coded last.
[[nodiscard]] inline SurfaceCandidates surface_candidates(const LiveState& state,
                                                          const std::vector<BlockTrace>& now,
                                                          const BlockView& here, std::size_t which,
                                                          const SurfaceParameters& last) {
  SurfaceCandidates candidates;
  if (here.has_left()) {
    const BlockTrace& left = now[here.left()];
    candidates[0] = continued(left.surfaces[which], true, false);
    candidates[3] = continued(left.surfaces[1 - which], true, false);
  }
  if (here.has_above()) {
    const BlockTrace& above = now[here.above()];
    candidates[1] = continued(above.surfaces[which], false, true);
    candidates[4] = continued(above.surfaces[1 - which], false, true);
  }
  candidates[2] = state.trace[here.index()].surfaces[which];
  candidates[5] = last;
  return candidates;
}

/// Fills in the coefficients of a surface from its steps. Returns how many rows from the top may be
/// other than 0.
[[nodiscard]] inline int surface_coefficients(const BlockCoefficients& steps, int step,
                                              const SurfaceParameters& prediction,
                                              BlockCoefficients& coefficients) {
  int rows = 2;
  for (int k = 0; k < kBlockPixels; ++k) {
    const auto i = static_cast<std::size_t>(k);
    coefficients[i] = limited(std::int64_t{steps[i]} * step);
    if (steps[i] != 0) rows = std::max(rows, k / kBlockSide + 1);
  }
  if (prediction.known) {
    coefficients[0] = limited(std::int64_t{coefficients[0]} + prediction.mean);
    coefficients[1] = limited(std::int64_t{coefficients[1]} + prediction.slope_x);
    coefficients[8] = limited(std::int64_t{coefficients[8]} + prediction.slope_y);
  }
  return rows;
}

}  // namespace roomcast::codec
