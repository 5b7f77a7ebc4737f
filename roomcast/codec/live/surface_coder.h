// SPDX-License-Identifier: Apache-2.0
// Turns a block's labelled target into at most two surfaces: splits it at the
// largest gap in depth, goes on with a plane where a surface has no pixels, and
// quantises what a neighbour does not predict. The live encoder's own affair.
#pragma once

#include "roomcast/codec/live/block_code.h"
#include "roomcast/codec/live/block_planner.h"
#include "roomcast/codec/live/surface_prediction.h"

namespace roomcast::codec {

/// No coded reading is further from its target than this.
inline constexpr int kErrorBound = 12 * kLevelsPerSigma;

/// Sets surface_count, and kSecond in the labels of farther pixels.
void split_surfaces(BlockCode& code, BlockTarget& target);

/// Chooses a candidate and quantises. False: even the finest step breaks the
/// bound.
bool encode_surface(const SurfaceCandidates& candidates, PixelLabel label, int step,
                    const BlockCode& code, const BlockTarget& target, SurfaceCode& surface);

}  // namespace roomcast::codec
