// SPDX-License-Identifier: Apache-2.0
// open_recording_test.cpp opens the recordings of such a folder.
#include "roomcast/recording/import/cwipc_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/recording/dataset/recording_fixture.h"

namespace roomcast::recording {
namespace {

Result<std::vector<CwipcCamera>> cameras_of(const std::string& text) {
  const TemporaryFolder folder;
  put_text(folder / kCwipcFile, text);
  return read_cwipc_config(folder / kCwipcFile);
}

constexpr const char* kTurned = "[[0,-1,0,0.5],[1,0,0,1.25],[0,0,1,-2],[0,0,0,1]]";

TEST(CwipcConfig, has_the_files_and_places_of_its_cameras) {
  const auto cameras = cameras_of(
      R"({"version": 3, "type": "kinect_playback", "system": {"map_color_to_depth": true},
          "camera": [{"type": "kinect_playback", "serial": "12", "filename": "C:\\rec\\a.mkv",
                      "trafo": )" +
      std::string(kTurned) + R"(}, {"type": "kinect", "serial": "13", "disabled": true},
          {"type": "kinect", "serial": "14", "playback_filename": "b.mkv",
           "trafo": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}, {"serial": "15"}]})");
  ASSERT_TRUE(cameras.ok()) << cameras.error().message;
  ASSERT_EQ(cameras->size(), 3u);
  EXPECT_EQ((*cameras)[0].file, "a.mkv");
  EXPECT_TRUE((*cameras)[0].is_color_camera);
  ASSERT_TRUE((*cameras)[0].world_from_camera);
  EXPECT_EQ((*cameras)[0].world_from_camera->translation_m, Eigen::Vector3d(0.5, 1.25, -2));
  EXPECT_EQ((*cameras)[1].file, "b.mkv");
  EXPECT_FALSE((*cameras)[1].world_from_camera);  // not placed
  EXPECT_EQ((*cameras)[2].serial, "15");
}

TEST(CwipcConfig, poses_of_realsense_cameras_are_those_of_depth_unless_it_is_mapped) {
  for (const auto& [filtering, is_color] :
       {std::pair("{}", false), std::pair(R"({"map_color_to_depth": 1})", false),
        std::pair(R"({"map_color_to_depth": -1})", false),
        std::pair(R"({"map_color_to_depth": 0})", true),
        std::pair(R"({"map_color_to_depth": false})", true)}) {
    const auto cameras = cameras_of(R"({"filtering": )" + std::string(filtering) +
                                    R"(, "camera": [{"type": "realsense_playback"}]})");
    ASSERT_TRUE(cameras.ok());
    EXPECT_EQ((*cameras)[0].is_color_camera, is_color) << filtering;
  }
}

TEST(CwipcConfig, what_is_no_pose_is_told_and_left_out) {
  for (const char* trafo : {"[]", "7", "[[2,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]",
                            "[[1,0,0],[0,1,0],[0,0,1]]", R"([["x",0,0,0],[],[],[]])"}) {
    const auto cameras = cameras_of(R"({"camera": [{"trafo": )" + std::string(trafo) + "}]}");
    ASSERT_TRUE(cameras.ok()) << trafo;
    EXPECT_FALSE((*cameras)[0].world_from_camera) << trafo;
    EXPECT_THAT((*cameras)[0].note, testing::HasSubstr("is not used")) << trafo;
  }
}

TEST(CwipcConfig, what_is_no_configuration_is_a_sentence) {
  EXPECT_THAT(cameras_of("{}").error().message, testing::EndsWith("has no list \"camera\""));
  EXPECT_FALSE(cameras_of("[]").ok());
  EXPECT_FALSE(cameras_of(R"({"camera": [7]})").ok());
  std::string many = R"({"camera": [{})";
  for (int i = 0; i < 64; ++i) many += ",{}";
  EXPECT_EQ(cameras_of(many + "]}").error().code, ErrorCode::kTooLarge);
  EXPECT_EQ(read_cwipc_config("/nowhere/x").error().code, ErrorCode::kNotFound);
}

}  // namespace
}  // namespace roomcast::recording
