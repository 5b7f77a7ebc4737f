// SPDX-License-Identifier: Apache-2.0
// Pairs depth pictures with colour pictures by time, and sorts both. Thread-safe (no state).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "roomcast/core/clock.h"

namespace roomcast::recording {

/// For each depth time the colour picture nearest in time, if one is within `tolerance`. Both lists
/// increase.
[[nodiscard]] std::vector<std::optional<std::size_t>> nearest_colors(
    const std::vector<nanoseconds>& depth_times, const std::vector<nanoseconds>& color_times,
    nanoseconds tolerance);

/// The same, within half of the usual time between depth pictures.
[[nodiscard]] std::vector<std::optional<std::size_t>> nearest_colors(
    const std::vector<nanoseconds>& depth_times, const std::vector<nanoseconds>& color_times);

/// Between frames, where a recording has a single one.
inline constexpr nanoseconds kNominalGap = std::chrono::milliseconds(33);

/// The middle of the gaps between increasing times; `otherwise` if there are fewer than two.
[[nodiscard]] nanoseconds median_gap(const std::vector<nanoseconds>& times, nanoseconds otherwise);

/// Frames per second as a rig allows them, 0.001 to 240, for gaps of this length.
[[nodiscard]] double fps_of_gap(nanoseconds gap);

}  // namespace roomcast::recording
