// SPDX-License-Identifier: Apache-2.0
#include "roomcast/aligner/room_placing.h"

#include <gtest/gtest.h>

#include "roomcast/align/made_up_room.h"

namespace roomcast::aligner {
namespace {

TEST(RoomPlacing, a_view_of_no_use_is_reported) {
  auto dark = align::made_up_bundle({}, "dark", align::corner_pose(2, 1.5));
  dark.color = ColorImage(dark.color.width(), dark.color.height());
  RoomPlacing placing;
  placing.add(dark);
  const auto placements = placing.solve({}, {});
  ASSERT_EQ(placements.size(), 1U);
  EXPECT_EQ(placements[0].sensor, "dark");
  EXPECT_FALSE(placements[0].note.empty());
}

}  // namespace
}  // namespace roomcast::aligner
