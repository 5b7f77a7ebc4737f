// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/room/room_recording.h"

#include <gtest/gtest.h>

#include "roomcast/client/room/room_state.h"
#include "roomcast/core/clock.h"
#include "roomcast/core/temporary_folder.h"
#include "roomcast/recording/room/recording_cursor.h"
#include "roomcast/recording/room/recording_fixture.h"
#include "roomcast/wire/pose_message.h"

namespace roomcast::recording {
namespace {

class RoomRecordingTest : public testing::Test {
 protected:
  Result<RoomRecording> open() const { return RoomRecording::open(path); }

  TemporaryFolder folder;
  std::filesystem::path path = folder / "room.mcap";
  RecordingFixtureRoom room;
};

TEST_F(RoomRecordingTest, holds_the_bytes_of_every_frame_in_their_order) {
  const auto frames = room.record(path, 12);
  const auto recording = open();
  ASSERT_TRUE(recording.ok()) << recording.error().message;
  RecordingCursor cursor(*recording);
  RecordedMessage message;
  std::size_t count = 0;
  while (*cursor.next(message)) {
    if (message.kind != MessageKind::kFrame) continue;
    ASSERT_LT(count, frames.size());
    EXPECT_TRUE(std::ranges::equal(message.message.data, frames[count]));
    EXPECT_EQ(message.message.publish_time,
              RecordingFixtureRoom::capture(static_cast<int>(count / 2)) +
                  RecordingFixtureRoom::kUnixMinusRoom);
    ++count;
  }
  EXPECT_EQ(count, frames.size());
}

TEST_F(RoomRecordingTest, knows_its_room_and_sensors) {
  room.record(path, 12);
  const auto recording = open();
  ASSERT_TRUE(recording.ok());
  EXPECT_EQ(recording->room(), "lab");
  ASSERT_EQ(recording->sensors().size(), 2u);
  EXPECT_EQ(recording->sensors()[1].name, "s1");
  EXPECT_EQ(recording->sensors()[1].frame_count, 12u);
  EXPECT_EQ(recording->sensor("s1"), &recording->sensors()[1]);
  EXPECT_EQ(recording->sensor("s2"), nullptr);
  EXPECT_EQ(recording->start(), RecordingFixtureRoom::came(0));
  EXPECT_EQ(recording->end(), RecordingFixtureRoom::came(11));
  EXPECT_EQ(recording->origin(),
            RecordingFixtureRoom::capture(0) + RecordingFixtureRoom::kUnixMinusRoom);
  EXPECT_FALSE(recording->damage().has_value());
}

TEST_F(RoomRecordingTest, frames_recorded_before_a_sensor_was_placed_have_its_pose_too) {
  room.record(path, 12, true, 8);
  const auto recording = open();
  ASSERT_EQ(recording->rosters().size(), 2u);
  const auto& entry = recording->roster_at(RecordingFixtureRoom::came(0)).sensors(1);
  EXPECT_EQ(entry.placement(), wire::pb::PLACEMENT_ALIGNED);
  EXPECT_EQ(wire::read_transform(entry.world_from_depth())->translation_m.x(), 0.5);
}

TEST_F(RoomRecordingTest, without_its_end_it_loses_no_more_than_the_open_chunk) {
  room.record(path, 30, false);
  const auto recording = open();
  ASSERT_TRUE(recording.ok());
  EXPECT_TRUE(recording->damage().has_value());
  const auto lost = RecordingFixtureRoom::came(29) - recording->end();
  EXPECT_LE(lost, nanoseconds(RoomRecordingWriter::kLongestChunk) + RecordingFixtureRoom::kPeriod);
  EXPECT_GE(recording->sensors()[0].frame_count, 24u);
}

TEST_F(RoomRecordingTest, decodes_from_the_key_frames_before_a_moment) {
  room.record(path, 40);
  const auto recording = open();
  const auto time = RecordingFixtureRoom::capture(28) + RecordingFixtureRoom::kUnixMinusRoom;
  RecordingCursor cursor(*recording, recording->chunk_to_decode_from(time, recording->sensors()));
  const SteadyClock clock;
  client::RoomState state(clock);
  ASSERT_TRUE(state.roster(recording->roster_at(time)).ok());
  RecordedMessage message;
  std::uint32_t first_seq = 0, decoded = 0;
  while (*cursor.next(message)) {
    if (message.kind != MessageKind::kFrame || message.message.publish_time > time) continue;
    if (*state.frame(message.message.data) == client::RoomState::FrameOutcome::kNeedsKey) continue;
    if (decoded++ == 0) first_seq = wire::parse_frame(message.message.data)->seq;
  }
  EXPECT_GE(first_seq, 20u) << "it did not start from the beginning";
  const auto shown = state.snapshot();
  for (const auto& sensor : shown->sensors) {
    EXPECT_EQ(sensor.picture->seq, 28u);
    EXPECT_EQ(sensor.picture->frame.depth_mm, RecordingFixtureRoom::depth(28));
  }
}

TEST_F(RoomRecordingTest, a_damaged_chunk_is_reported_and_the_next_one_is_read) {
  room.record(path, 40);
  const auto sound = open();
  const auto& chunk = sound->file().summary().chunks[1];
  {
    std::FILE* file = std::fopen(path.c_str(), "r+b");
    std::fseek(file, static_cast<long>(chunk.offset + chunk.length / 2), SEEK_SET);
    std::fputs("damage", file);
    std::fclose(file);
  }
  const auto recording = open();
  ASSERT_TRUE(recording.ok());
  RecordingCursor cursor(*recording);
  RecordedMessage message;
  int errors = 0;
  nanoseconds last{};
  for (;;) {
    const auto more = cursor.next(message);
    if (more.ok() && !*more) break;
    errors += !more.ok();
    if (more.ok()) last = message.message.log_time;
  }
  EXPECT_EQ(errors, 1);
  EXPECT_EQ(last, RecordingFixtureRoom::came(39));
}

TEST_F(RoomRecordingTest, other_files_are_refused_with_a_reason) {
  {
    auto writer = recording::mcap::Writer::create(path);
    ASSERT_TRUE(writer->finish().ok());
  }
  const auto recording = open();
  ASSERT_FALSE(recording.ok());
  EXPECT_EQ(recording.error().code, ErrorCode::kUnsupported);
  EXPECT_NE(recording.error().message.find("not made by roomcast"), std::string::npos);
}

TEST_F(RoomRecordingTest, frames_of_impossible_times_are_left_out_and_not_counted) {
  auto writer = RoomRecordingWriter::create(path, "lab");
  ASSERT_TRUE(writer->add_clock({RecordingFixtureRoom::kUnixMinusRoom, {}}, {}).ok());
  ASSERT_TRUE(writer->add_roster(room.roster(), RecordingFixtureRoom::came(0)).ok());
  auto frame = room.frame(0, 0);
  auto header = *wire::parse_frame(frame);
  for (const auto capture :
       {nanoseconds::max(), nanoseconds::min(), nanoseconds(std::int64_t{1} << 61)}) {
    header.capture_time = RoomTime(capture);
    wire::write_frame_header(header, std::span(frame).first<wire::kFrameHeaderBytes>());
    ASSERT_TRUE(writer->add_frame(frame, RecordingFixtureRoom::came(0)).ok());
  }
  EXPECT_EQ(writer->frames(), 0U);
}

TEST_F(RoomRecordingTest, that_ended_before_the_first_roster_is_empty) {
  {
    auto writer = RoomRecordingWriter::create(path, "lab");
    ASSERT_TRUE(writer->finish().ok());
  }
  const auto recording = open();
  ASSERT_TRUE(recording.ok()) << recording.error().message;
  EXPECT_EQ(recording->room(), "lab");
  EXPECT_TRUE(recording->sensors().empty());
  EXPECT_EQ(recording->end(), recording->start());
  EXPECT_TRUE(recording->roster_at(recording->start()).sensors().empty());
  RecordingCursor cursor(*recording);
  RecordedMessage message;
  EXPECT_FALSE(*cursor.next(message));
}

TEST_F(RoomRecordingTest, frames_of_sensors_that_no_roster_has_are_left_out) {
  auto writer = RoomRecordingWriter::create(path, "lab");
  ASSERT_TRUE(writer->add_frame(room.frame(0, 0), RecordingFixtureRoom::came(0)).ok());
  EXPECT_EQ(writer->frames(), 0u);
  ASSERT_TRUE(writer->add_roster(room.roster(), RecordingFixtureRoom::came(0)).ok());
  ASSERT_TRUE(writer->add_frame(room.frame(0, 1), RecordingFixtureRoom::came(1)).ok());
  EXPECT_EQ(writer->frames(), 1u);
}

}  // namespace
}  // namespace roomcast::recording
