// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/frame_sets/frame_set_reader.h"

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/recording/dataset/rig_writer.h"
#include "roomcast/recording/room/recording_fixture.h"

namespace roomcast::recording {
namespace {

using recording::RecordingFixtureRoom;

TEST(FrameSetReader, gives_the_sets_of_a_recording) {
  const TemporaryFolder folder;
  RecordingFixtureRoom().record(folder / "a.mcap", 12);
  auto reader = open_frame_sets(folder / "a.mcap");
  ASSERT_TRUE(reader.ok()) << reader.error().message;
  ASSERT_EQ((*reader)->sensors().size(), 2u);
  EXPECT_EQ((*reader)->sensors()[1].name, "s1");
  FrameSet set;
  for (int instant = 0; instant < 12; ++instant) {
    ASSERT_TRUE(*(*reader)->next(set));
    EXPECT_EQ(set.number, static_cast<std::uint64_t>(instant));
    ASSERT_EQ(set.frames.size(), 2u);
    for (const SetFrame& frame : set.frames) {
      EXPECT_EQ(frame.pictures->depth_mm, RecordingFixtureRoom::depth(instant));
      ASSERT_TRUE(frame.world_from_depth.has_value());
      EXPECT_EQ(frame.world_from_depth->translation_m.x(), 0.5 * static_cast<double>(frame.sensor));
    }
  }
  EXPECT_FALSE(*(*reader)->next(set));
}

TEST(FrameSetReader, says_whether_a_recording_may_be_exported) {
  const TemporaryFolder folder;
  RecordingFixtureRoom().record(folder / "a.mcap", 12);
  EXPECT_TRUE((*open_frame_sets(folder / "a.mcap"))->may_be_exported());
  auto writer = recording::RoomRecordingWriter::create(folder / "b.mcap", "lab");
  RecordingFixtureRoom room;
  ASSERT_TRUE(writer->forbid_export().ok());
  ASSERT_TRUE(writer->add_roster(room.roster(), RecordingFixtureRoom::came(0)).ok());
  ASSERT_TRUE(writer->add_frame(room.frame(0, 0), RecordingFixtureRoom::came(0)).ok());
  ASSERT_TRUE(writer->finish().ok());
  const auto forbidden = open_frame_sets(folder / "b.mcap");
  EXPECT_FALSE((*forbidden)->may_be_exported());
  EXPECT_EQ(check_may_be_exported(**forbidden).error().code, ErrorCode::kUnavailable);
}

TEST(FrameSetReader, begins_at_the_given_time) {
  const TemporaryFolder folder;
  RecordingFixtureRoom().record(folder / "a.mcap", 40);
  auto reader = open_frame_sets(folder / "a.mcap", std::chrono::milliseconds(2750));
  FrameSet set;
  ASSERT_TRUE(*(*reader)->next(set));
  EXPECT_EQ(set.frames[0].pictures->depth_mm, RecordingFixtureRoom::depth(28));
}

/// Writes a rig of two sensors. The second one's clock is 3 s ahead, and its second frame is
/// dropped.
void write_rig(const std::filesystem::path& folder) {
  std::vector<RigSensor> sensors(2);
  for (int i = 0; i < 2; ++i) {
    sensors[static_cast<std::size_t>(i)].description.name = RecordingFixtureRoom::name(i);
    sensors[static_cast<std::size_t>(i)].description.calibration =
        RecordingFixtureRoom::calibration();
    sensors[static_cast<std::size_t>(i)].description.world_from_depth =
        RecordingFixtureRoom::world_from_depth(i);
  }
  sensors[1].clock_offset_s = 3;
  auto writer = RigWriter::create(folder, 10, sensors);
  ASSERT_TRUE(writer.ok()) << writer.error().message;
  for (int instant = 0; instant < 4; ++instant) {
    for (std::size_t i = 0; i < 2; ++i) {
      if (i == 1 && instant == 1) continue;
      source::CapturedFrame frame;
      frame.depth_mm = RecordingFixtureRoom::depth(instant);
      frame.color = RecordingFixtureRoom::color(static_cast<int>(i));
      frame.index = static_cast<std::uint64_t>(instant);
      const nanoseconds ahead = i == 1 ? std::chrono::seconds(3) : std::chrono::seconds(0);
      ASSERT_TRUE(writer->add(i, frame, instant * RecordingFixtureRoom::kPeriod + ahead).ok());
    }
  }
  ASSERT_TRUE(writer->finish().ok());
}

TEST(FrameSetReader, lines_up_the_sensors_of_a_rig) {
  const TemporaryFolder folder;
  write_rig(folder / "rig");
  auto reader = open_frame_sets(folder / "rig");
  ASSERT_TRUE(reader.ok()) << reader.error().message;
  FrameSet set;
  for (int instant = 0; instant < 4; ++instant) {
    ASSERT_TRUE(*(*reader)->next(set));
    ASSERT_EQ(set.frames.size(), 2u);
    EXPECT_EQ(set.frames[0].pictures->depth_mm, RecordingFixtureRoom::depth(instant));
    const int shown = instant == 1 ? 0 : instant;  // a dropped frame is replaced by the one before
    EXPECT_EQ(set.frames[1].pictures->depth_mm, RecordingFixtureRoom::depth(shown));
    EXPECT_NEAR(set.frames[1].pictures->color.at(30, 20).r, 160, 4);
  }
  EXPECT_FALSE(*(*reader)->next(set));
}

TEST(FrameSetReader, knows_the_number_of_a_rigs_sets) {
  const TemporaryFolder folder;
  write_rig(folder / "rig");
  RecordingFixtureRoom().record(folder / "a.mcap", 12);
  EXPECT_EQ((*open_frame_sets(folder / "rig"))->set_count(), 4u);
  EXPECT_EQ((*open_frame_sets(folder / "rig", std::chrono::milliseconds(150)))->set_count(), 2u);
  EXPECT_FALSE((*open_frame_sets(folder / "a.mcap"))->set_count().has_value());
}

TEST(FrameSetReader, names_a_path_that_is_no_recording) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "empty");
  EXPECT_EQ(open_frame_sets(folder / "empty").error().code, ErrorCode::kNotFound);
  EXPECT_EQ(open_frame_sets(folder / "nothing").error().code, ErrorCode::kNotFound);
}

}  // namespace
}  // namespace roomcast::recording
