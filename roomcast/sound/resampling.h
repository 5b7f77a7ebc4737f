// SPDX-License-Identifier: Apache-2.0
// Another sample rate for a whole sound: a windowed sinc filter (J. O. Smith, "Digital Audio
// Resampling", 2002), 16 zero crossings on each side. No state.
#pragma once

#include <vector>

namespace roomcast::sound {

/// Rates above 0. Samples beyond the ends count as silence.
[[nodiscard]] std::vector<float> resampled(std::vector<float> samples, int from_hz, int to_hz);

}  // namespace roomcast::sound
