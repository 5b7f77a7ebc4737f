// SPDX-License-Identifier: Apache-2.0
// The cell pattern of an AprilTag of family 36h11: 10 x 10 cells, the outermost ring white.
// Thread-safe (no state).
#pragma once

#include <array>
#include <optional>

namespace roomcast::alignment {

inline constexpr int kTagCells = 10;       // across, with the white ring
inline constexpr int kTagSquareCells = 8;  // across the black square

/// White cells are true; rows from the top.
using TagCells = std::array<std::array<bool, kTagCells>, kTagCells>;

/// The number of tags in the family.
[[nodiscard]] int tag_count();

/// Nothing for a number that the family does not have.
[[nodiscard]] std::optional<TagCells> tag_cells(int tag);

}  // namespace roomcast::alignment
