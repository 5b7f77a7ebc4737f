// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/lossless/value_table.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "roomcast/codec/testing/synthetic_depth.h"

namespace roomcast::codec {
namespace {

using Values = std::vector<std::uint16_t>;

DepthImage row_of(const Values& depth_mm) {
  DepthImage image(static_cast<int>(depth_mm.size()), 1);
  std::copy(depth_mm.begin(), depth_mm.end(), image.data());
  return image;
}

TEST(ValueTable, few_distances_pay_and_many_do_not) {
  ValueTable table;
  Values values;
  EXPECT_TRUE(table.choose(row_of({1000, 0, 2000, 3000}), 0, values));
  EXPECT_EQ(values, (Values{0, 1000, 2000, 3000}));
  EXPECT_FALSE(table.choose(row_of({1000, 1001, 1003}), 0, values));
  EXPECT_FALSE(table.choose(row_of({0, 0}), 0, values)) << "no reading at all";
}

TEST(ValueTable, within_a_bound_one_value_stands_for_several) {
  ValueTable table;
  Values values;
  const DepthImage depth = row_of({1000, 1001, 1004, 1005, 3000});
  ASSERT_TRUE(table.choose(depth, 2, values));
  EXPECT_EQ(values, (Values{0, 1002, 1005, 3000}));
  DepthImage indices(5, 1);
  table.map(depth, indices.view());
  EXPECT_EQ(indices, row_of({1, 1, 1, 2, 3}));
}

TEST(ValueTable, holes_map_to_zero_and_readings_stay_within_the_bound) {
  ValueTable table;
  for (const int bound : {0, 1, 3}) {
    const DepthImage room = synthetic_disparity_room(64, 48);
    Values values;
    (void)table.choose(room, bound, values);
    DepthImage indices(64, 48);
    table.map(room, indices.view());
    for (std::size_t i = 0; i < room.view().pixel_count(); ++i) {
      const int in = room.data()[i], out = values[indices.data()[i]];
      ASSERT_EQ(in == 0, out == 0);
      ASSERT_LE(std::abs(in - out), bound);
    }
  }
}

}  // namespace
}  // namespace roomcast::codec
