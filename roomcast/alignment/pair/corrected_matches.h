// SPDX-License-Identifier: Apache-2.0
// Matches as they are once their sensors' colour cameras are corrected: a feature that is seen a
// few pixels aside was lifted into space aside, too. Metres, pixels. Thread-safe (no state).
#pragma once

#include <span>
#include <vector>

#include "roomcast/alignment/pair/pair_equations.h"
#include "roomcast/alignment/pair/rigid_fit.h"
#include "roomcast/alignment/view/color_picture.h"

namespace roomcast::alignment {

/// The same matches in the same order, with their points moved; pixels stay what was seen.
[[nodiscard]] std::vector<PointMatch> corrected_matches(std::span<const PointMatch> matches,
                                                        const ColorPicture& a,
                                                        const ColorPicture& b,
                                                        const PairState& state);

}  // namespace roomcast::alignment
