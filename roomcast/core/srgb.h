// SPDX-License-Identifier: Apache-2.0
// Levels of sRGB and linear light. Source: IEC 61966-2-1.
#pragma once

#include <array>

namespace roomcast {

/// Linear light 0..1 from an sRGB level 0..255, and the inverse.
[[nodiscard]] float linear_from_level(float level);
[[nodiscard]] float level_from_linear(float linear);

/// The linear light of each level.
[[nodiscard]] std::array<float, 256> linear_levels();

}  // namespace roomcast
