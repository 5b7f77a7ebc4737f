// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/board/tag_cells.h"

#include <cstdint>
#include <memory>

#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>

namespace roomcast::alignment {
namespace {

using Family = std::unique_ptr<apriltag_family_t, void (*)(apriltag_family_t*)>;

Family family_36h11() {
  return {tag36h11_create(), tag36h11_destroy};
}

}  // namespace

int tag_count() {
  return static_cast<int>(family_36h11()->ncodes);
}

std::optional<TagCells> tag_cells(int tag) {
  const Family family = family_36h11();
  if (tag < 0 || tag >= static_cast<int>(family->ncodes)) return std::nullopt;
  TagCells cells{};
  for (std::size_t i = 0; i < kTagCells; ++i)
    cells[0][i] = cells[kTagCells - 1][i] = cells[i][0] = cells[i][kTagCells - 1] = true;
  constexpr std::size_t kSquare = (kTagCells - kTagSquareCells) / 2;  // first black-square cell
  for (std::uint32_t bit = 0; bit < family->nbits; ++bit) {
    const bool white = ((family->codes[tag] >> (family->nbits - 1 - bit)) & 1U) != 0;
    cells[family->bit_y[bit] + kSquare][family->bit_x[bit] + kSquare] = white;
  }
  return cells;
}

}  // namespace roomcast::alignment
