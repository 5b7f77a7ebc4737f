// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/board/tag_cells.h"

#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

TEST(TagCells, a_white_rim_surrounds_a_black_border) {
  const TagCells cells = *tag_cells(0);
  for (std::size_t i = 0; i < kTagCells; ++i) {
    EXPECT_TRUE(cells[0][i] && cells[i][0] && cells[9][i] && cells[i][9]);
    if (i == 0 || i == 9) continue;
    EXPECT_FALSE(cells[1][i] || cells[i][1] || cells[8][i] || cells[i][8]);
  }
}

TEST(TagCells, tags_differ_and_there_are_587) {
  EXPECT_EQ(tag_count(), 587);
  EXPECT_NE(*tag_cells(0), *tag_cells(1));
  EXPECT_FALSE(tag_cells(587));
  EXPECT_FALSE(tag_cells(-1));
}

}  // namespace
}  // namespace roomcast::alignment
