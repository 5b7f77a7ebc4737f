// SPDX-License-Identifier: Apache-2.0
// Applies the sensors' colour corrections to matches: a feature seen a few pixels off its true
// place was also lifted into space off its true place. Metres, pixels. Thread-safe (no state).
#pragma once

#include <span>
#include <vector>

#include "roomcast/alignment/pair/pair_equations.h"
#include "roomcast/alignment/pair/rigid_fit.h"
#include "roomcast/alignment/view/color_picture.h"

namespace roomcast::alignment {

/// The same matches in the same order, with corrected points; pixels are unchanged.
[[nodiscard]] std::vector<PointMatch> corrected_matches(std::span<const PointMatch> matches,
                                                        const ColorPicture& a,
                                                        const ColorPicture& b,
                                                        const PairState& state);

}  // namespace roomcast::alignment
