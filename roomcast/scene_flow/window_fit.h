// SPDX-License-Identifier: Apache-2.0
// How well the neighbourhood of a cell fits another place: the inner loop of CellMatcher.
#pragma once

#include <cstddef>
#include <cstdint>

namespace roomcast::scene_flow {

/// A square of 2 * kReach + 1 cells, in rows of eight so that a row is one vector.
template <int kReach>
struct Window {
  static_assert(kReach <= 3);
  static constexpr int kRows = 2 * kReach + 1;
  static constexpr int kLanes = 8;
  alignas(16) std::int16_t cells[kRows * kLanes];  // mm; 0: no foreground
};

/// Reads the window whose first cell is at `first`; rows are `stride` cells apart, and eight cells
/// of each are readable.
template <int kReach>
[[nodiscard]] Window<kReach> window_at(const std::int16_t* first, std::ptrdiff_t stride);

struct WindowFit {
  float cost = 1;        // 0: the same surface, to 1: nothing in common
  float farther_mm = 0;  // how much deeper the other place is
};

/// Cells that only one of the two has cost as much as cells on another surface.
template <int kReach>
[[nodiscard]] WindowFit fit(const Window<kReach>& window, const std::int16_t* other_first,
                            std::ptrdiff_t stride);

}  // namespace roomcast::scene_flow
