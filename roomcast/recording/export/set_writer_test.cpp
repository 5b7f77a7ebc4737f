// SPDX-License-Identifier: Apache-2.0
// Checks that the exported files exist, are complete and decode to the input; tests/cli reads each
// format with third-party readers.
#include "roomcast/recording/export/set_writer.h"

#include <fstream>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/recording/dataset/recording_fixture.h"
#include "roomcast/recording/dataset/tum_list.h"
#include "roomcast/recording/export/cloud_files.h"
#include "roomcast/recording/export/folder_writer.h"
#include "roomcast/recording/export/foxglove_writer.h"
#include "roomcast/recording/export/gltf_scene.h"
#include "roomcast/recording/export/wall_fixture.h"
#include "roomcast/recording/mcap/reader.h"

namespace roomcast::recording {
namespace {

class SetWriterTest : public testing::Test {
 protected:
  Result<std::unique_ptr<SetWriter>> make(ExportFormat format) const {
    return make_set_writer(format, out, {wall_sensors(), kBeganAt}, {});
  }
  static constexpr nanoseconds kBeganAt{1'764'000'000'000'000'123};  // in November 2025
  TemporaryFolder folder;
  std::filesystem::path out = folder / "out";
};

class EveryFormat : public SetWriterTest, public testing::WithParamInterface<ExportFormat> {};

TEST_P(EveryFormat, writes_two_sets) {
  auto writer = make(GetParam());
  ASSERT_TRUE(writer.ok()) << writer.error().message;
  FrameSet set = wall_set();
  ASSERT_TRUE((*writer)->add(set).ok());
  set = wall_set();
  set.number = 1;
  set.time = std::chrono::milliseconds(100);
  for (SetFrame& frame : set.frames) frame.time = set.time;
  ASSERT_TRUE((*writer)->add(set).ok());
  ASSERT_TRUE((*writer)->finish().ok());
  EXPECT_EQ((*writer)->totals().sets, 2u);
  EXPECT_FALSE(std::filesystem::is_empty(out));
}

INSTANTIATE_TEST_SUITE_P(SetWriter, EveryFormat, testing::ValuesIn(kExportFormats),
                         [](const auto& format) { return std::string(name_of(format.param)); });

TEST_F(SetWriterTest, goes_on_where_it_was_interrupted) {
  ASSERT_TRUE((*make(ExportFormat::kPly))->add(wall_set()).ok());
  auto again = make(ExportFormat::kPly);
  ASSERT_TRUE((*again)->add(wall_set()).ok());
  EXPECT_EQ((*again)->totals().kept, 1u);
  EXPECT_EQ((*again)->totals().sets, 0u);
}

TEST_F(SetWriterTest, a_rig_is_read_again_as_it_was) {
  auto writer = make(ExportFormat::kTum);
  ASSERT_TRUE((*writer)->add(wall_set()).ok());
  ASSERT_TRUE((*writer)->finish().ok());
  EXPECT_TRUE(std::filesystem::exists(out / "near" / "groundtruth.txt"));
  auto reader = open_frame_sets(out);
  ASSERT_TRUE(reader.ok()) << reader.error().message;
  FrameSet set;
  ASSERT_TRUE(*(*reader)->next(set));
  ASSERT_EQ(set.frames.size(), 2u);
  EXPECT_EQ(set.frames[1].pictures->depth_mm, wall_set().frames[1].pictures->depth_mm);
  EXPECT_EQ(set.frames[1].world_from_depth->translation_m, wall_pose(1).translation_m);
}

std::map<std::string, std::string> files_below(const std::filesystem::path& top) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(top)) {
    if (entry.is_regular_file())
      files[entry.path().lexically_relative(top).string()] = text_of(entry.path());
  }
  return files;
}

void export_tum(const std::filesystem::path& from, const std::filesystem::path& to) {
  auto reader = open_frame_sets(from);
  ASSERT_TRUE(reader.ok()) << reader.error().message;
  const ExportedRoom room = {(*reader)->sensors(), (*reader)->began_at()};
  auto writer = make_set_writer(ExportFormat::kTum, to, room, {});
  ASSERT_TRUE(writer.ok()) << writer.error().message;
  FrameSet set;
  while (*(*reader)->next(set)) ASSERT_TRUE((*writer)->add(set).ok());
  ASSERT_TRUE((*writer)->finish().ok());
}

TEST_F(SetWriterTest, a_folder_that_was_exported_is_exported_again_byte_for_byte) {
  export_tum(write_small_rig(folder), folder / "first");
  export_tum(folder / "first", folder / "second");
  const auto first = files_below(folder / "first"), second = files_below(folder / "second");
  EXPECT_TRUE(first.contains("s1/rgb/000004.jpg"));
  ASSERT_EQ(first.size(), second.size());
  for (const auto& [path, bytes] : first) EXPECT_TRUE(second.at(path) == bytes) << path;
}

TEST_F(SetWriterTest, a_folder_keeps_the_errors_of_the_poses_and_of_the_scale) {
  std::vector<SetSensor> sensors = wall_sensors();
  for (SetSensor& sensor : sensors) sensor.scale_error = 0.018;
  sensors[0].expected_error_m = 0.039;
  auto writer = make_set_writer(ExportFormat::kRig, out, {sensors, kBeganAt}, {});
  ASSERT_TRUE((*writer)->add(wall_set()).ok());
  ASSERT_TRUE((*writer)->finish().ok());
  const auto again = open_frame_sets(out);
  ASSERT_TRUE(again.ok()) << again.error().message;
  ASSERT_EQ((*again)->sensors().size(), sensors.size());
  for (const SetSensor& sensor : (*again)->sensors()) {
    EXPECT_EQ(sensor.scale_error, 0.018);
    EXPECT_NEAR(sensor.expected_error_m, sensor.name == sensors[0].name ? 0.039 : 0, 1e-9);
  }
}

TEST_F(SetWriterTest, a_folder_keeps_the_date_of_its_frames) {
  auto writer = make(ExportFormat::kTum);
  ASSERT_TRUE((*writer)->add(wall_set()).ok());
  ASSERT_TRUE((*writer)->finish().ok());
  const auto listed = read_tum_list(out / "far" / "depth.txt");
  ASSERT_TRUE(listed.ok()) << listed.error().message;
  EXPECT_EQ(listed->front().timestamp, kBeganAt);
  std::ifstream poses(out / "far" / "groundtruth.txt");
  std::string seconds;
  poses >> seconds;
  EXPECT_EQ(seconds, tum_seconds(kBeganAt));
}

TEST_F(SetWriterTest, clouds_and_meshes_tell_when_they_were_captured) {
  for (const ExportFormat format : {ExportFormat::kPly, ExportFormat::kPcd, ExportFormat::kGltf}) {
    auto writer = make(format);
    FrameSet set = wall_set();
    set.time = std::chrono::milliseconds(1500);
    ASSERT_TRUE((*writer)->add(set).ok());
  }
  for (const char* file : {"set_000000.ply", "set_000000.pcd", "set_000000.glb"}) {
    std::ifstream in(out / file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    EXPECT_NE(bytes.find("2025-11-24T16:00:01.500000123Z"), std::string::npos) << file;
  }
}

TEST_F(SetWriterTest, a_foxglove_file_keeps_the_date_of_its_frames) {
  auto writer = make(ExportFormat::kFoxglove);
  ASSERT_TRUE((*writer)->add(wall_set()).ok());
  ASSERT_TRUE((*writer)->finish().ok());
  const auto file = recording::mcap::Reader::open(out / "room.mcap");
  ASSERT_TRUE(file.ok());
  EXPECT_EQ(file->summary().statistics.start_time, kBeganAt);
  EXPECT_EQ(file->summary().statistics.end_time, kBeganAt);
}

TEST_F(SetWriterTest, a_foxglove_file_has_the_channels_that_programs_look_for) {
  auto writer = make(ExportFormat::kFoxglove);
  ASSERT_TRUE((*writer)->add(wall_set()).ok());
  ASSERT_TRUE((*writer)->finish().ok());
  const auto file = recording::mcap::Reader::open(out / "room.mcap");
  ASSERT_TRUE(file.ok());
  std::map<std::string, std::string> schema_of;
  for (const auto& [id, channel] : file->summary().channels)
    schema_of[channel.topic] = file->summary().schemas.at(channel.schema).name;
  EXPECT_EQ(schema_of.at("/points"), "foxglove.PointCloud");
  EXPECT_EQ(schema_of.at("/tf"), "foxglove.FrameTransform");
  EXPECT_EQ(schema_of.at("/near/color"), "foxglove.CompressedVideo");
  EXPECT_EQ(schema_of.at("/far/depth"), "foxglove.RawImage");
  EXPECT_EQ(schema_of.at("/far/camera"), "foxglove.CameraCalibration");
  EXPECT_EQ(file->summary().statistics.message_count, 9u);
}

TEST(CloudFiles, ply_and_pcd_are_as_long_as_their_headers_say) {
  PointCloud cloud;
  cloud.add({1, 2, 3}, {0, 0, 1}, {10, 20, 30});
  cloud.add({4, 5, 6}, {0, 1, 0}, {40, 50, 60});
  std::vector<std::uint8_t> ply, pcd;
  append_ply(cloud, {}, ply);
  append_pcd(cloud, {}, pcd);
  const auto header_end = [](const std::vector<std::uint8_t>& bytes, std::string_view last) {
    const std::string text(bytes.begin(), bytes.end());
    return text.find(last) + last.size();
  };
  EXPECT_EQ(ply.size() - header_end(ply, "end_header\n"), 2 * 27u);
  EXPECT_EQ(pcd.size() - header_end(pcd, "DATA binary\n"), 2 * 28u);
}

TEST(GltfScene, an_empty_set_is_a_file_without_meshes) {
  GltfScene scene(wall_sensors());
  std::vector<std::uint8_t> glb;
  ASSERT_TRUE(scene.append({}, {}, glb).ok());
  EXPECT_EQ(std::string(glb.begin(), glb.begin() + 4), "glTF");
  EXPECT_EQ(glb.size() % 4, 0u);
}

}  // namespace
}  // namespace roomcast::recording
