// SPDX-License-Identifier: Apache-2.0
#include "bench/render/aligned_poses.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::bench {
namespace {

RigidTransform shifted(double x) {
  RigidTransform pose;
  pose.translation_m.x() = x;
  return pose;
}

class AlignedPosesTest : public testing::Test {
 protected:
  AlignedPosesTest() {
    rig.sensors.resize(2);
    rig.sensors[0].id = "s0";
    rig.sensors[1].id = "s1";
    rig.sensors[0].world_from_depth = shifted(5);
  }

  /// s1 is 2 m from s0.
  void write(const std::string& s1_placed) const {
    std::ofstream(report) << R"({"sensors": [{"id": "s0", "placed": true, "world_from_depth":
        [1,0,0,1, 0,1,0,0, 0,0,1,0, 0,0,0,1]}, {"id": "s1", "placed": )"
                          << s1_placed << R"(, "world_from_depth":
        [1,0,0,3, 0,1,0,0, 0,0,1,0, 0,0,0,1]}]})";
  }

  const TemporaryFolder folder;
  const std::filesystem::path report = folder / "report.json";
  recording::RigDescription rig;
};

TEST_F(AlignedPosesTest, the_first_sensor_has_the_rigs_pose) {
  write("true");
  const auto poses = read_aligned_poses(report, rig);
  ASSERT_TRUE(poses.ok()) << poses.error().message;
  EXPECT_DOUBLE_EQ(poses->at(0).translation_m.x(), 5);
  EXPECT_DOUBLE_EQ(poses->at(1).translation_m.x(), 7);
}

TEST_F(AlignedPosesTest, a_sensor_that_was_not_placed_is_named) {
  write("false");
  const auto poses = read_aligned_poses(report, rig);
  ASSERT_FALSE(poses.ok());
  EXPECT_NE(poses.error().message.find("s1"), std::string::npos) << poses.error().message;
}

TEST_F(AlignedPosesTest, a_file_of_something_else_is_refused) {
  std::ofstream(report) << R"({"sensors": 3})";
  EXPECT_FALSE(read_aligned_poses(report, rig).ok());
}

}  // namespace
}  // namespace roomcast::bench
