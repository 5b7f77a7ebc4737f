// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/source_factory.h"

#include <gtest/gtest.h>

#include "roomcast/io/file_bytes.h"
#include "roomcast/recording/dataset/recording.h"
#include "roomcast/recording/dataset/recording_fixture.h"
#include "roomcast/recording/import/azure_kinect_fixture.h"

namespace roomcast::sensor {
namespace {

const SourceOptions kFastOnce{.pace = source::Pace::kAsFastAsPossible, .loop = false};

void expect_opens(const std::string& spec, const std::string& name) {
  auto source = open_source(spec, kFastOnce);
  ASSERT_TRUE(source.ok()) << spec << ": " << source.error().message;
  EXPECT_EQ((*source)->description().name, name);
  source::CapturedFrame frame;
  const auto more = (*source)->next(frame, {});
  ASSERT_TRUE(more.ok()) << spec << ": " << more.error().message;
  EXPECT_TRUE(*more) << spec;
}

TEST(SourceFactory, opens_a_sensor_of_a_rig) {
  const TemporaryFolder folder;
  expect_opens("rig:" + recording::write_small_rig(folder).string() + "#s1", "s1");
}

TEST(SourceFactory, opens_a_single_recording) {
  const TemporaryFolder folder;
  const auto sensor =
      recording::write_small_rig(folder) / "s0";  // rig sensor folders are TUM folders
  expect_opens("tum:" + sensor.string(), "s0");
}

TEST(SourceFactory, an_error_for_an_unknown_kind_lists_all_kinds) {
  for (const char* spec : {"", "camera", "foo:bar", ":", "#", "RIG:x"}) {
    const auto source = open_source(spec);
    ASSERT_FALSE(source.ok()) << spec;
    EXPECT_EQ(source.error().code, ErrorCode::kInvalidArgument);
    for (const char* kind : {"sim", "rig:DIR", "tum:DIR"}) {
      EXPECT_NE(source.error().message.find(kind), std::string::npos) << source.error().message;
    }
  }
}

TEST(SourceFactory, a_folder_that_is_not_named_or_not_there_is_refused) {
  EXPECT_EQ(open_source("rig:").error().code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(open_source("tum").error().code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(open_source("rig:/nowhere#s0").error().code, ErrorCode::kNotFound);
  EXPECT_EQ(open_source("tum:/nowhere").error().code, ErrorCode::kNotFound);
  const auto recorded = open_source("mcap:/nowhere.mcap#s0");
  ASSERT_FALSE(recorded.ok());
  EXPECT_EQ(recorded.error().message.find('#'), std::string::npos) << recorded.error().message;
}

TEST(SourceFactory, recordings_of_other_programs_open_alone_or_as_one_room) {
  const TemporaryFolder folder;
  recording::AzureFixture made;
  made.color = "";
  ASSERT_TRUE(io::write_file(folder / "a.mkv", recording::azure_recording(made)).ok());
  const std::string spec = "mkv:" + (folder / "a.mkv").string();
  expect_opens(spec, "000123");
  expect_opens(spec + "#000123", "000123");
  EXPECT_EQ(open_source(spec + "#other").error().code, ErrorCode::kNotFound);
  const auto room =
      open_recorded_room({"sim#0", spec, spec}, kFastOnce, recording::JoiningClock::kAutomatic);
  ASSERT_TRUE(room.ok()) << room.error().message;
  EXPECT_EQ(room->sources[0], nullptr);
  EXPECT_EQ(room->sources[1]->description().name, "000123");
  EXPECT_EQ(room->sources[2]->description().name, "000123-2");
  EXPECT_FALSE(room->clock.empty());
}

TEST(SourceFactory, lists_the_sensors_of_a_rig) {
  const TemporaryFolder folder;
  const auto names = recording::rig_sensor_names(recording::write_small_rig(folder).string());
  ASSERT_TRUE(names.ok());
  EXPECT_EQ(*names, (std::vector<std::string>{"s0", "s1"}));
  EXPECT_EQ(recording::rig_sensor_names(folder.path().string()).error().code, ErrorCode::kNotFound);
}

TEST(SourceFactory, a_simulated_sensor_is_numbered) {
  EXPECT_EQ(open_source("sim:livingroom#x").error().code, ErrorCode::kInvalidArgument);
  EXPECT_FALSE(open_source("sim:no-such-scene#0").ok());
}

TEST(SourceFactory, a_camera_that_is_not_there_or_not_built_in_says_so) {
  for (const char* spec : {"freenect2:000012345", "k4a", "realsense:"}) {
    const auto opened = open_source(spec);
    ASSERT_FALSE(opened.ok()) << spec;
    EXPECT_NE(opened.error().code, ErrorCode::kInvalidArgument) << opened.error().message;
  }
}

}  // namespace
}  // namespace roomcast::sensor
