// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/rig/contact_sheet.h"

#include <set>

#include <gtest/gtest.h>

namespace roomcast::simulator {
namespace {

ContactSheetOptions small_picture() {
  ContactSheetOptions options;
  options.cell_width = 64;
  return options;
}

TEST(ContactSheet, holds_five_views_that_differ) {
  const auto sheet = contact_sheet("corners", small_picture()).value();
  ASSERT_EQ(sheet.width(), 4 * 64);
  ASSERT_EQ(sheet.height(), 2 * 36);
  std::set<std::vector<int>> rows;  // the middle row of every view
  for (const auto& [left, row] : {std::pair{0, 36}, {128, 18}, {192, 18}, {128, 54}, {192, 54}}) {
    std::vector<int> values;
    for (int x = 0; x < 64; ++x) values.push_back(sheet.at(left + x, row).g);
    EXPECT_GT(*std::max_element(values.begin(), values.end()), 40) << "black at " << left;
    rows.insert(values);
  }
  EXPECT_EQ(rows.size(), 5U);
}

TEST(ContactSheet, the_same_seed_gives_the_same_picture_and_another_one_another) {
  ContactSheetOptions one_thread = small_picture();
  one_thread.threads = 1;
  const auto first = contact_sheet("bare", small_picture()).value();
  EXPECT_EQ(first, contact_sheet("bare", one_thread).value());
  ContactSheetOptions other = small_picture();
  other.seed = 2;
  EXPECT_NE(first, contact_sheet("bare", other).value());
}

TEST(ContactSheet, unknown_scenes_and_sizes_are_refused) {
  EXPECT_EQ(contact_sheet("attic", small_picture()).error().code, ErrorCode::kNotFound);
  ContactSheetOptions tiny;
  tiny.cell_width = 3;
  EXPECT_EQ(contact_sheet("bare", tiny).error().code, ErrorCode::kInvalidArgument);
}

}  // namespace
}  // namespace roomcast::simulator
