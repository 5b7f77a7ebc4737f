// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/open_recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/io/file_bytes.h"
#include "roomcast/recording/dataset/recording_fixture.h"
#include "roomcast/recording/import/azure_kinect_fixture.h"

namespace roomcast::recording {
namespace {

std::filesystem::path write_azure(const std::filesystem::path& path, const std::string& serial) {
  AzureFixture made;
  made.serial = serial;
  made.color = "";
  EXPECT_TRUE(io::write_file(path, azure_recording(made)).ok());
  return path;
}

TEST(OpenRecording, a_file_is_known_by_its_content) {
  const TemporaryFolder folder;
  const auto files = open_any(write_azure(folder / "without-ending", "7"));
  ASSERT_TRUE(files.ok()) << files.error().message;
  ASSERT_EQ(files->size(), 1U);
  EXPECT_EQ((*files)[0]->info().description.name, "7");
}

TEST(OpenRecording, a_folder_gives_the_sensors_of_all_its_recordings_by_name) {
  const TemporaryFolder folder;
  write_azure(folder / "b.mkv", "b");
  write_azure(folder / "a.mkv", "a");
  put_text(folder / "notes.txt", "no recording");
  const auto files = open_any(folder.path());
  ASSERT_TRUE(files.ok()) << files.error().message;
  ASSERT_EQ(files->size(), 2U);
  EXPECT_EQ((*files)[0]->info().description.name, "a");
}

TEST(OpenRecording, a_sensor_is_chosen_by_name) {
  const TemporaryFolder folder;
  const auto path = write_azure(folder / "a.mkv", "7");
  EXPECT_TRUE(open_sensor("mkv", path, "").ok());
  EXPECT_TRUE(open_sensor("mkv", path, "7").ok());
  const auto other = open_sensor("mkv", path, "8");
  ASSERT_FALSE(other.ok());
  EXPECT_EQ(other.error().code, ErrorCode::kNotFound);
  EXPECT_THAT(other.error().message, testing::HasSubstr("choose one of 7"));
}

TEST(OpenRecording, a_folder_of_cwipc_gives_sensors_where_they_are) {
  const TemporaryFolder folder;
  write_azure(folder / "left.mkv", "7");
  write_azure(folder / "8.mkv", "8");
  write_azure(folder / "not-listed.mkv", "9");
  put_text(folder / "cameraconfig.json",
           R"({"camera": [{"serial": "7", "filename": "left.mkv",
                           "trafo": [[0,-1,0,0.5],[1,0,0,1.25],[0,0,1,-2],[0,0,0,1]]},
                          {"serial": "8"}]})");
  for (const bool by_kind : {false, true}) {
    const auto files = by_kind ? open_recording("cwipc", folder.path()) : open_any(folder.path());
    ASSERT_TRUE(files.ok()) << files.error().message;
    ASSERT_EQ(files->size(), 2U);
    const SensorFileInfo& info = (*files)[0]->info();
    ASSERT_TRUE(info.description.world_from_depth);
    // The matrix is of the colour camera: a point 1 m in front of it.
    const Eigen::Vector3d in_color(0, 0, 1);
    const Eigen::Vector3d in_depth =
        info.description.calibration.color_from_depth.inverse() * in_color;
    const Eigen::Vector3d in_world = *info.description.world_from_depth * in_depth;
    EXPECT_LT((in_world - Eigen::Vector3d(0.5, 1.25, -1)).norm(), 1e-9);
    EXPECT_FALSE((*files)[1]->info().description.world_from_depth);
    EXPECT_THAT((*files)[1]->info().notes.back(), testing::HasSubstr("does not say where it is"));
    DepthImage depth;
    EXPECT_TRUE((*files)[0]->read_depth(0, depth).ok());
  }
  put_text(folder / "cameraconfig.json", R"({"camera": [{"filename": "gone.mkv"}]})");
  EXPECT_EQ(open_any(folder.path()).error().code, ErrorCode::kNotFound);
  put_text(folder / "cameraconfig.json", R"({"camera": [{"serial": "5"}]})");
  EXPECT_THAT(open_any(folder.path()).error().message,
              testing::HasSubstr("has a camera \"5\" without a recording beside it"));
}

TEST(OpenRecording, a_rig_need_not_be_imported) {
  const TemporaryFolder folder;
  const auto files = open_any(write_small_rig(folder, 1));
  ASSERT_FALSE(files.ok());
  EXPECT_EQ(files.error().code, ErrorCode::kUnsupported);
  EXPECT_THAT(files.error().message, testing::HasSubstr("is a rig or a TUM folder already"));
}

TEST(OpenRecording, what_is_no_recording_is_refused) {
  const TemporaryFolder folder;
  put_text(folder / "a.txt", "text");
  put_text(folder / "empty.mkv", "");
  EXPECT_EQ(open_any(folder / "absent").error().code, ErrorCode::kNotFound);
  EXPECT_EQ(open_any(folder / "a.txt").error().code, ErrorCode::kUnsupported);
  EXPECT_EQ(open_any(folder / "empty.mkv").error().code, ErrorCode::kUnsupported);
  EXPECT_EQ(open_any(folder.path()).error().code, ErrorCode::kUnsupported);
  EXPECT_EQ(open_recording("mkv", folder / "empty.mkv").error().code, ErrorCode::kMalformed);
  EXPECT_EQ(open_recording("vhs", folder / "a.txt").error().code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(import_kind_of(write_azure(folder / "b", "7")), "mkv");
  EXPECT_EQ(import_kind_of(folder / "a.txt"), "");
  EXPECT_TRUE(is_import_kind("mkv"));
  EXPECT_FALSE(is_import_kind("rig"));
}

}  // namespace
}  // namespace roomcast::recording
