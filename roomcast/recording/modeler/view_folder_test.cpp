// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/modeler/view_folder.h"

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/recording/export/wall_fixture.h"

namespace roomcast::recording {
namespace {

KeptViews::Saved wall_views() {
  return {wall_sensors(), wall_set()};
}

TEST(ViewFolder, views_are_read_as_they_were_written) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_views(folder / "lab", wall_views()).ok());
  const auto read = read_views(folder / "lab");
  ASSERT_TRUE(read.ok()) << read.error().message;
  ASSERT_EQ(read->set.frames.size(), 2u);
  EXPECT_EQ(read->sensors[0].name, "near");
  EXPECT_EQ(read->sensors[0].depth, wall_sensors()[0].depth);
  EXPECT_EQ(read->set.frames[0].pictures->depth_mm.at(5, 5), 2000);
  EXPECT_EQ(*read->set.frames[1].world_from_depth, wall_pose(1));
}

TEST(ViewFolder, later_views_take_the_place_of_earlier_ones) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_views(folder / "lab", wall_views()).ok());
  KeptViews::Saved one = wall_views();
  one.sensors.pop_back();
  one.set.frames.pop_back();
  ASSERT_TRUE(write_views(folder / "lab", one).ok());
  EXPECT_EQ(read_views(folder / "lab")->sensors.size(), 1u);
  ASSERT_TRUE(write_views(folder / "lab", {}).ok());
  EXPECT_EQ(read_views(folder / "lab").error().code, ErrorCode::kNotFound);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "nothing is left beside it";
}

TEST(ViewFolder, a_disk_that_refuses_is_told_with_a_sentence) {
  const auto status = write_views("/proc/nothing/lab", wall_views());
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::kUnavailable);
}

}  // namespace
}  // namespace roomcast::recording
