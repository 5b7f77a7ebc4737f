// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/dataset/rig_writer.h"

#include <gtest/gtest.h>

#include "roomcast/recording/dataset/recording_fixture.h"
#include "roomcast/recording/dataset/rig_json.h"

namespace roomcast::recording {
namespace {

std::vector<RigSensor> sensors_named(const std::vector<std::string>& names) {
  std::vector<RigSensor> sensors;
  for (const std::string& name : names) {
    sensors.push_back({{name, small_calibration(), std::nullopt, 30}, 0, 0});
  }
  return sensors;
}

TEST(RigWriter, lists_name_every_frame_with_its_time) {
  const TemporaryFolder folder;
  const auto rig = write_small_rig(folder, 4);
  EXPECT_EQ(text_of(rig / "s1/depth.txt"),
            "# timestamp path\n107.503000000 depth/000000.png\n107.523000000 depth/000001.png\n"
            "107.563000000 depth/000003.png\n");
  EXPECT_TRUE(std::filesystem::exists(rig / "s1/rgb/000003.jpg"));
  EXPECT_FALSE(std::filesystem::exists(rig / "s1/rgb/000002.jpg"));
}

TEST(RigWriter, missing_numbers_become_dropped_frames) {
  const TemporaryFolder folder;
  const auto rig = read_rig_json(write_small_rig(folder) / "rig.json");
  ASSERT_TRUE(rig.ok()) << rig.error().message;
  EXPECT_TRUE(rig->sensors[0].drop.empty());
  EXPECT_EQ(rig->sensors[1].drop, (std::vector<std::uint64_t>{2}));
  EXPECT_EQ(rig->sensors[1].clock_offset_s, 7.5);
}

TEST(RigWriter, frames_said_to_be_dropped_are_listed_even_at_the_end) {
  const TemporaryFolder folder;
  auto writer = RigWriter::create(folder / "rig", 30, sensors_named({"s0"}), {"test", 90});
  ASSERT_TRUE(writer.ok());
  ASSERT_TRUE(writer->add(0, small_frame(0, 0), nanoseconds(5)).ok());
  ASSERT_TRUE(writer->drop(0, 1).ok());
  ASSERT_TRUE(writer->add(0, small_frame(0, 3), nanoseconds(9)).ok());
  ASSERT_TRUE(writer->drop(0, 4).ok());
  EXPECT_FALSE(writer->drop(0, 4).ok());
  EXPECT_EQ(read_rig_json(folder / "rig/rig.json")->source, "test (not finished)");
  ASSERT_TRUE(writer->finish().ok());
  const auto rig = read_rig_json(folder / "rig/rig.json");
  EXPECT_EQ(rig->sensors[0].drop, (std::vector<std::uint64_t>{1, 2, 4}));
  EXPECT_EQ(rig->source, "test");
}

TEST(RigWriter, an_interrupted_recording_is_complete_up_to_its_last_frame) {
  const TemporaryFolder folder;
  {
    auto writer = RigWriter::create(folder / "rig", 30, sensors_named({"s0"}));
    ASSERT_TRUE(writer.ok());
    ASSERT_TRUE(writer->add(0, small_frame(0, 0), nanoseconds(5)).ok());
  }  // no finish()
  EXPECT_TRUE(read_rig_json(folder / "rig/rig.json").ok());
  EXPECT_EQ(text_of(folder / "rig/s0/depth.txt"),
            "# timestamp path\n0.000000005 depth/000000.png\n");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
    EXPECT_NE(entry.path().extension(), ".part");
  }
}

TEST(RigWriter, never_writes_into_a_folder_that_holds_something) {
  const TemporaryFolder folder;
  put_text(folder / "precious", "kept");
  const auto writer = RigWriter::create(folder.path(), 30, sensors_named({"s0"}));
  ASSERT_FALSE(writer.ok());
  EXPECT_EQ(writer.error().code, ErrorCode::kUnavailable);
  EXPECT_NE(writer.error().message.find("not empty"), std::string::npos);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
  EXPECT_FALSE(RigWriter::create(folder / "precious", 30, sensors_named({"s0"})).ok());
  EXPECT_EQ(text_of(folder / "precious"), "kept");
}

TEST(RigWriter, an_empty_folder_will_do) {
  const TemporaryFolder folder;
  EXPECT_TRUE(RigWriter::create(folder.path(), 30, sensors_named({"s0"})).ok());
}

TEST(RigWriter, refuses_rigs_that_could_not_be_read_back) {
  const TemporaryFolder folder;
  const auto refused = [&](double fps, const std::vector<RigSensor>& sensors, int quality = 90) {
    const auto writer = RigWriter::create(folder / "rig", fps, sensors, {"", quality});
    return !writer.ok() && writer.error().code == ErrorCode::kInvalidArgument &&
           !std::filesystem::exists(folder / "rig");
  };
  EXPECT_TRUE(refused(0, sensors_named({"s0"})));
  EXPECT_TRUE(refused(30, {}));
  EXPECT_TRUE(refused(30, sensors_named({"s0", "s0"})));
  EXPECT_TRUE(refused(30, sensors_named({""})));
  EXPECT_TRUE(refused(30, sensors_named({".."})));
  EXPECT_TRUE(refused(30, sensors_named({"."})));
  EXPECT_TRUE(refused(30, sensors_named({"a/b"})));
  EXPECT_TRUE(refused(30, sensors_named({"s0"}), 0));
  auto bad_camera = sensors_named({"s0"});
  bad_camera[0].description.calibration.depth.fx = 0;
  EXPECT_TRUE(refused(30, bad_camera));
}

TEST(RigWriter, refuses_frames_of_another_size_and_numbers_that_do_not_grow) {
  const TemporaryFolder folder;
  auto writer = RigWriter::create(folder / "rig", 30, sensors_named({"s0"}));
  ASSERT_TRUE(writer.ok());
  ASSERT_TRUE(writer->add(0, small_frame(0, 5), nanoseconds(5)).ok());
  EXPECT_FALSE(writer->add(0, small_frame(0, 5), nanoseconds(6)).ok());
  EXPECT_FALSE(writer->add(0, small_frame(0, 1U << 30U), nanoseconds(6)).ok());
  source::CapturedFrame frame = small_frame(0, 6);
  frame.color.resize(10, 10);
  EXPECT_FALSE(writer->add(0, frame, nanoseconds(6)).ok());
  frame = small_frame(0, 6);
  frame.depth_mm.resize(10, 10);
  EXPECT_FALSE(writer->add(0, frame, nanoseconds(6)).ok());
  EXPECT_TRUE(writer->add(0, small_frame(0, 6), nanoseconds(6)).ok());
}

TEST(RigWriter, a_recording_need_not_begin_at_frame_0) {
  const TemporaryFolder folder;
  auto writer = RigWriter::create(folder / "rig", 30, sensors_named({"s0"}));
  ASSERT_TRUE(writer.ok());
  ASSERT_TRUE(writer->add(0, small_frame(0, 7), nanoseconds(5)).ok());
  ASSERT_TRUE(writer->finish().ok());
  EXPECT_TRUE(read_rig_json(folder / "rig/rig.json")->sensors[0].drop.empty());
}

TEST(RigWriter, a_disk_that_fails_is_reported) {
  const TemporaryFolder folder;
  auto writer = RigWriter::create(folder / "rig", 30, sensors_named({"s0"}));
  ASSERT_TRUE(writer.ok());
  std::filesystem::remove_all(folder / "rig/s0/depth");
  const Status status = writer->add(0, small_frame(0, 0), nanoseconds(5));
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::kUnavailable);
}

}  // namespace
}  // namespace roomcast::recording
