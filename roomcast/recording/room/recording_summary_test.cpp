// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/room/recording_summary.h"

#include <fstream>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/recording/room/recording_fixture.h"

namespace roomcast::recording {
namespace {

class RecordingSummaryTest : public testing::Test {
 protected:
  TemporaryFolder folder;
  std::filesystem::path path = folder / "room.mcap";
  RecordingFixtureRoom room;
};

TEST_F(RecordingSummaryTest, has_room_times_and_sensors) {
  room.record(path, 12);
  const auto summary = summarize_recording(path);
  ASSERT_TRUE(summary.ok()) << summary.error().message;
  EXPECT_EQ(summary->about.room, "lab");
  EXPECT_EQ(summary->about.by, "");
  EXPECT_EQ(summary->start, RecordingFixtureRoom::came(0));
  EXPECT_EQ(summary->end, RecordingFixtureRoom::came(11));
  EXPECT_EQ(summary->sensors, 2u);
  EXPECT_FALSE(summary->has_voices);
  EXPECT_FALSE(summary->damage.has_value());
}

TEST_F(RecordingSummaryTest, says_whether_voices_are_in_it) {
  {
    auto writer = RoomRecordingWriter::create(path, "lab");
    const std::uint8_t payload = 0x78;
    const auto packet =
        RecordingFixtureRoom::voice(1, 0, RecordingFixtureRoom::capture(0), {&payload, 1});
    ASSERT_TRUE(writer->add_voice(packet, RecordingFixtureRoom::came(0)).ok());
    ASSERT_TRUE(writer->add_voice(room.frame(0, 0), RecordingFixtureRoom::came(0)).ok())
        << "ignored";
    EXPECT_EQ(writer->voice_packets(), 1u);
    ASSERT_TRUE(writer->finish().ok());
  }
  const auto summary = summarize_recording(path);
  ASSERT_TRUE(summary.ok()) << summary.error().message;
  EXPECT_TRUE(summary->has_voices);
  EXPECT_EQ(summary->sensors, 0u);
}

TEST_F(RecordingSummaryTest, has_who_started_it_also_when_export_is_forbidden) {
  {
    auto writer = RoomRecordingWriter::create(path, "lab", "Ada");
    ASSERT_TRUE(writer->forbid_export().ok());
    ASSERT_TRUE(writer->finish().ok());
  }
  const auto summary = summarize_recording(path);
  ASSERT_TRUE(summary.ok()) << summary.error().message;
  EXPECT_EQ(summary->about.by, "Ada");
  EXPECT_FALSE(summary->about.may_be_exported);
  EXPECT_EQ(summary->sensors, 0u);
}

TEST_F(RecordingSummaryTest, says_why_an_end_is_missing) {
  room.record(path, 30, false);
  const auto summary = summarize_recording(path);
  ASSERT_TRUE(summary.ok()) << summary.error().message;
  EXPECT_TRUE(summary->damage.has_value());
  EXPECT_GT(summary->end, summary->start);
}

TEST_F(RecordingSummaryTest, of_another_file_is_an_error) {
  std::ofstream(path) << "not MCAP";
  EXPECT_FALSE(summarize_recording(path).ok());
  EXPECT_EQ(summarize_recording(folder / "nothing.mcap").error().code, ErrorCode::kNotFound);
}

}  // namespace
}  // namespace roomcast::recording
