// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/rig_poses.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/io/file_bytes.h"
#include "roomcast/recording/dataset/rig_json.h"

namespace roomcast::cli {
namespace {

namespace fs = std::filesystem;

/// A rig.json of two sensors, both at the origin.
void write_rig(const fs::path& folder) {
  recording::RigDescription rig;
  rig.fps = 15;
  for (const char* id : {"s0", "s1"}) {
    recording::RigSensorEntry entry;
    entry.id = id;
    entry.path = id;
    entry.world_from_depth = RigidTransform{};
    rig.sensors.push_back(entry);
  }
  EXPECT_TRUE(io::write_file(folder / "rig.json", recording::rig_json_text(rig)).ok());
}

alignment::AlignmentReport first_placed() {
  alignment::AlignmentReport report;
  report.sensors.resize(2);
  report.sensors[0].id = "s0";
  report.sensors[0].placed = true;
  report.sensors[0].world_from_depth = RigidTransform{};
  report.sensors[0].world_from_depth->translation_m = {0, 1.5, 0};
  report.sensors[1].id = "s1";
  return report;
}

TEST(RigPoses, replace_those_in_the_file_and_nothing_else) {
  const TemporaryFolder folder;
  write_rig(folder.path());
  ASSERT_TRUE(write_rig_poses(folder.path(), first_placed()).ok());
  const auto rig = recording::read_rig_json(folder / "rig.json");
  ASSERT_TRUE(rig.ok());
  EXPECT_EQ(rig->sensors[0].world_from_depth->translation_m.y(), 1.5);
  EXPECT_FALSE(rig->sensors[1].world_from_depth.has_value()) << "it was not placed";
  EXPECT_EQ(rig->fps, 15);
}

TEST(RigPoses, come_with_depth_scales_that_multiply_those_in_the_file) {
  const TemporaryFolder folder;
  write_rig(folder.path());
  alignment::AlignmentReport report = first_placed();
  report.sensors[0].depth_scale = 1.02;
  report.sensors[1].depth_scale = 1.1;  // it was not placed, so nothing holds for it
  ASSERT_TRUE(write_rig_poses(folder.path(), report).ok());
  ASSERT_TRUE(write_rig_poses(folder.path(), report).ok());
  const auto rig = recording::read_rig_json(folder / "rig.json");
  ASSERT_TRUE(rig.ok());
  EXPECT_DOUBLE_EQ(rig->sensors[0].depth_scale, 1.02 * 1.02);
  EXPECT_EQ(rig->sensors[1].depth_scale, 1);
}

TEST(RigPoses, come_with_their_expected_errors_and_that_of_the_scale) {
  const TemporaryFolder folder;
  write_rig(folder.path());
  alignment::AlignmentReport report = first_placed();
  report.sensors[0].expected_error_mm = 39;
  report.scale_error = 0.018;
  ASSERT_TRUE(write_rig_poses(folder.path(), report).ok());
  const auto rig = recording::read_rig_json(folder / "rig.json");
  ASSERT_TRUE(rig.ok());
  EXPECT_EQ(rig->sensors[0].expected_error_mm, 39);
  EXPECT_EQ(rig->sensors[1].expected_error_mm, 0);
  EXPECT_EQ(rig->scale_error, 0.018);
}

TEST(RigPoses, stay_when_a_depth_scale_would_leave_its_range) {
  const TemporaryFolder folder;
  write_rig(folder.path());
  alignment::AlignmentReport report = first_placed();
  report.sensors[0].depth_scale = 3;
  const Status status = write_rig_poses(folder.path(), report);
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().message, testing::HasSubstr("the depth scale of s0"));
  EXPECT_EQ(recording::read_rig_json(folder / "rig.json")->sensors[0].depth_scale, 1);
}

TEST(RigPoses, stay_when_no_sensor_was_placed) {
  const TemporaryFolder folder;
  write_rig(folder.path());
  alignment::AlignmentReport report = first_placed();
  report.sensors[0].placed = false;
  const Status status = write_rig_poses(folder.path(), report);
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().message, testing::HasSubstr("no sensor could be placed"));
  EXPECT_TRUE(
      recording::read_rig_json(folder / "rig.json")->sensors[1].world_from_depth.has_value());
}

}  // namespace
}  // namespace roomcast::cli
