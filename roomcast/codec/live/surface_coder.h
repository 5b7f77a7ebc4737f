// SPDX-License-Identifier: Apache-2.0
// Turns a block's labelled target into at most two surfaces: splits it at the largest gap in depth,
// extends a surface by a plane where it has no pixels, and quantises the difference from a
// prediction. Used by the live encoder only.
#pragma once

#include "roomcast/codec/live/block_code.h"
#include "roomcast/codec/live/block_planner.h"
#include "roomcast/codec/live/surface_prediction.h"

namespace roomcast::codec {

/// Maximum error of a coded reading, levels.
inline constexpr int kErrorBound = 12 * kLevelsPerSigma;

/// Sets surface_count, and label kSecond for the pixels behind the gap.
void split_surfaces(BlockCode& code, BlockTarget& target);

/// Chooses a candidate and quantises. Returns false if even the finest step exceeds kErrorBound.
bool encode_surface(const SurfaceCandidates& candidates, PixelLabel label, int step,
                    const BlockCode& code, const BlockTarget& target, SurfaceCode& surface);

}  // namespace roomcast::codec
