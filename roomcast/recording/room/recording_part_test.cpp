// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/room/recording_part.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>

#include <gtest/gtest.h>

#include "roomcast/client/room/room_state.h"
#include "roomcast/core/little_endian.h"
#include "roomcast/core/temporary_folder.h"
#include "roomcast/recording/room/recording_fixture.h"
#include "roomcast/wire/control.h"

namespace roomcast::recording {
namespace {

using namespace std::chrono_literals;

struct PartRecord {
  bool past = false;
  std::uint64_t time_us = 0;
  std::span<const std::uint8_t> message;
};

struct ReadPart {
  std::vector<char> bytes;  // the records point into it
  std::uint64_t from_us = 0, until_us = 0;
  std::uint32_t next = 0, flags = 0;
  std::vector<PartRecord> records;
};

ReadPart read_part(const std::string& bytes) {
  ReadPart part{.bytes = {bytes.begin(), bytes.end()}, .records = {}};
  const auto* data = reinterpret_cast<const std::uint8_t*>(part.bytes.data());
  EXPECT_EQ(read_u32(data), kPartMagic);
  EXPECT_EQ(read_u16(data + 4), kPartVersion);
  EXPECT_EQ(read_u16(data + 6), kPartHeaderBytes);
  part.from_us = read_u64(data + 8);
  part.until_us = read_u64(data + 16);
  part.next = read_u32(data + 24);
  part.flags = read_u32(data + 28);
  for (std::size_t at = kPartHeaderBytes; at < part.bytes.size();) {
    const std::uint32_t length = read_u32(data + at);
    EXPECT_LE(at + kPartRecordHeaderBytes + length, part.bytes.size());
    part.records.push_back({.past = (read_u32(data + at + 4) & 1) != 0,
                            .time_us = read_u64(data + at + 8),
                            .message = {data + at + kPartRecordHeaderBytes, length}});
    at += kPartRecordHeaderBytes + length;
  }
  return part;
}

bool is_frame(const PartRecord& record) {
  return *wire::message_type(record.message) == wire::MessageType::kFrame;
}

wire::pb::Control control_of(const PartRecord& record) {
  return *wire::decode_control(record.message, wire::Sender::kHub);
}

wire::pb::Mark mark(std::uint32_t id) {
  wire::pb::Mark mark;
  mark.set_id(id);
  mark.set_kind(wire::pb::MARK_KIND_NOTE);
  for (const float metres : {1.0F, 0.5F, -2.0F}) mark.add_points(metres);
  mark.set_text("note");
  return mark;
}

class RecordingPartTest : public testing::Test {
 protected:
  PlayableRecording open() const { return *PlayableRecording::open(path); }

  /// `seq` of each sensor after all messages up to `until_us` of this part and those that follow.
  std::map<std::string, std::uint32_t> shown(const PlayableRecording& recording,
                                             nanoseconds moment) const {
    const SteadyClock clock;
    client::RoomState state(clock);
    const ReadPart part = read_part(recording.moment(moment));
    for (const PartRecord& record : part.records) {
      if (!record.past) continue;
      if (is_frame(record)) {
        EXPECT_NE(*state.frame(record.message), client::RoomState::FrameOutcome::kNeedsKey);
      } else if (const auto control = control_of(record); control.has_roster()) {
        EXPECT_TRUE(state.roster(control.roster()).ok());
      }
    }
    std::map<std::string, std::uint32_t> seqs;
    const auto snapshot = state.snapshot();
    for (const auto& sensor : snapshot->sensors)
      if (sensor.picture) seqs[sensor.name] = sensor.picture->seq;
    return seqs;
  }

  /// Three seconds: marks 1 and 2 from 1 s on, 2 and 3 from 2 s on, and a person.
  void record_marks_and_people() {
    const nanoseconds start = RecordingFixtureRoom::came(0);
    auto writer = RoomRecordingWriter::create(path, "lab");
    ASSERT_TRUE(writer->add_clock({RecordingFixtureRoom::kUnixMinusRoom, {}}, start).ok());
    ASSERT_TRUE(writer->add_roster(room.roster(), start).ok());
    wire::pb::Marks first, second;
    first.set_all(true);
    *first.add_marks() = mark(1);
    *first.add_marks() = mark(2);
    ASSERT_TRUE(writer->add_marks(first, start + 1s).ok());
    *second.add_marks() = mark(3);
    second.add_removed(1);
    ASSERT_TRUE(writer->add_marks(second, start + 2s).ok());
    wire::pb::ViewerPoses poses;
    auto& pose = *poses.add_poses();
    pose.set_viewer_id(7);
    pose.mutable_head()->set_x(1);
    pose.mutable_head()->set_qw(1);
    ASSERT_TRUE(writer->add_poses(poses, start + 2s).ok());
    ASSERT_TRUE(writer->add_roster(room.roster(), start + 3s).ok());
    ASSERT_TRUE(writer->finish().ok());
  }

  TemporaryFolder folder;
  std::filesystem::path path = folder / "room.mcap";
  RecordingFixtureRoom room;
};

TEST_F(RecordingPartTest, of_a_moment_shows_every_sensor_as_it_was) {
  room.record(path, 40);
  const auto recording = open();
  for (const int instant : {0, 4, 5, 28, 39}) {
    const auto seqs = shown(recording, instant * RecordingFixtureRoom::kPeriod);
    EXPECT_EQ(seqs.size(), 2u) << instant;
    for (const auto& [name, seq] : seqs) EXPECT_EQ(seq, instant) << name;
  }
}

TEST_F(RecordingPartTest, has_no_more_of_the_past_than_its_frames_need) {
  room.record(path, 40);
  const ReadPart part = read_part(open().moment(28 * RecordingFixtureRoom::kPeriod));
  std::size_t past_frames = 0;
  for (const PartRecord& record : part.records) past_frames += record.past && is_frame(record);
  EXPECT_LE(past_frames, 2u * RecordingFixtureRoom::kFramesPerKey);
  EXPECT_EQ(part.from_us, 2'800'000u);
}

TEST_F(RecordingPartTest, and_those_that_follow_have_every_frame_once) {
  const auto frames = room.record(path, 40);
  const auto recording = open();
  ReadPart part = read_part(recording.moment(0ns));
  std::vector<std::vector<std::uint8_t>> got;
  std::uint64_t time_us = 0;
  const auto take = [&] {
    for (const PartRecord& record : part.records) {
      EXPECT_GE(record.time_us, time_us);
      time_us = record.time_us;
      if (is_frame(record)) got.emplace_back(record.message.begin(), record.message.end());
    }
  };
  take();
  int parts = 1;
  for (; part.next != kNoPart; ++parts) {
    auto next = recording.part(part.next);
    ASSERT_TRUE(next.ok());
    part = read_part(*next);
    take();
  }
  EXPECT_EQ(got, frames);
  EXPECT_GE(parts, 3);
  EXPECT_EQ(part.until_us, 3'900'000u);
}

TEST_F(RecordingPartTest, has_voices_as_they_were_sent_and_none_of_the_past) {
  const std::vector<std::uint8_t> payload{0x78, 1, 2};
  const auto at = [](int n) { return RecordingFixtureRoom::came(0) + n * 20ms; };
  const auto said = [&](int n) {
    return RecordingFixtureRoom::voice(7, static_cast<std::uint32_t>(n),
                                       RecordingFixtureRoom::capture(0) + n * 20ms, payload);
  };
  {
    auto writer = RoomRecordingWriter::create(path, "lab");
    ASSERT_TRUE(writer->add_clock({RecordingFixtureRoom::kUnixMinusRoom, {}}, at(0)).ok());
    ASSERT_TRUE(writer->add_roster(room.roster(), at(0)).ok());
    for (int n = 0; n < 100; ++n) ASSERT_TRUE(writer->add_voice(said(n), at(n)).ok());
    ASSERT_TRUE(writer->finish().ok());
  }
  const auto recording = open();
  const std::string moment = recording.moment(1s);
  const ReadPart part = read_part(moment);
  int next = 51;
  for (const PartRecord& record : part.records) {
    if (*wire::message_type(record.message) != wire::MessageType::kAudio) continue;
    EXPECT_FALSE(record.past);
    EXPECT_TRUE(std::ranges::equal(record.message, said(next++)));
  }
  EXPECT_GT(next, 51);
}

TEST_F(RecordingPartTest, of_a_time_out_of_range_is_the_first_or_last) {
  room.record(path, 12);
  const auto recording = open();
  EXPECT_EQ(read_part(recording.moment(-5s)).from_us, 0u);
  EXPECT_EQ(read_part(recording.moment(nanoseconds::max())).from_us, 1'100'000u);
  EXPECT_EQ(read_part(recording.moment(1h)).next, kNoPart);
  EXPECT_EQ(recording.part(1000).error().code, ErrorCode::kNotFound);
  EXPECT_EQ(recording.part(kNoPart).error().code, ErrorCode::kNotFound);
}

TEST_F(RecordingPartTest, of_a_small_picture_is_the_last_key_frame_of_one_sensor) {
  room.record(path, 40);
  const auto recording = open();
  const auto seq_at = [&](const char* sensor, int instant) {
    const std::string bytes =
        recording.key_frame(sensor, instant * RecordingFixtureRoom::kPeriod + 1ms);
    const ReadPart part = read_part(bytes);
    EXPECT_EQ(part.next, kNoPart);
    if (part.records.size() != 1) return -1;
    const auto header = wire::parse_frame(part.records.front().message);
    EXPECT_TRUE(header->key);
    EXPECT_EQ(header->sensor, SensorId{10});
    return static_cast<int>(header->seq);
  };
  EXPECT_EQ(seq_at("s0", 28), 25);
  EXPECT_EQ(seq_at("s0", 4), 0);
  EXPECT_EQ(seq_at("s0", 1000), 35);
  EXPECT_EQ(seq_at("no such sensor", 28), -1);
}

TEST_F(RecordingPartTest, of_an_empty_recording_has_its_roster_at_most) {
  {
    auto writer = RoomRecordingWriter::create(path, "lab");
    ASSERT_TRUE(writer->finish().ok());
  }
  const ReadPart part = read_part(open().moment(1s));
  EXPECT_TRUE(part.records.empty());
  EXPECT_EQ(part.next, kNoPart);
  EXPECT_TRUE(read_part(open().key_frame("s0", 1s)).records.empty());
}

TEST_F(RecordingPartTest, says_where_the_file_is_damaged_and_goes_on_behind_it) {
  room.record(path, 40);
  {
    const auto sound = RoomRecording::open(path);
    const auto& chunk = sound->file().summary().chunks[1];
    std::FILE* file = std::fopen(path.c_str(), "r+b");
    std::fseek(file, static_cast<long>(chunk.offset + chunk.length / 2), SEEK_SET);
    std::fputs("damage", file);
    std::fclose(file);
  }
  const auto recording = open();
  const ReadPart part = read_part(*recording.part(0));
  EXPECT_EQ(part.flags & 1, 1u);
  EXPECT_EQ(read_part(*recording.part(part.next)).flags & 1, 0u);
  EXPECT_EQ(shown(recording, 39 * RecordingFixtureRoom::kPeriod).size(), 2u);
}

TEST_F(RecordingPartTest, has_marks_and_people_as_they_were) {
  record_marks_and_people();
  const auto recording = open();
  const auto ids = [&](nanoseconds moment) {
    std::vector<std::uint32_t> found;
    const ReadPart part = read_part(recording.moment(moment));
    for (const PartRecord& record : part.records) {
      const auto control = control_of(record);
      if (!record.past || !control.has_marks()) continue;
      EXPECT_TRUE(control.marks().all());
      for (const auto& each : control.marks().marks()) found.push_back(each.id());
    }
    return found;
  };
  EXPECT_EQ(ids(0s), std::vector<std::uint32_t>{});
  EXPECT_EQ(ids(1500ms), (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(ids(2500ms), (std::vector<std::uint32_t>{2, 3}));
  int poses = 0;
  const ReadPart part = read_part(recording.moment(2500ms));
  for (const PartRecord& record : part.records)
    poses += record.past && control_of(record).has_viewer_poses();
  EXPECT_EQ(poses, 1);
}

/// The page's tests read the same file. To write it anew: ROOMCAST_UPDATE_GOLDEN=1.
TEST_F(RecordingPartTest, is_what_the_page_reads) {
  record_marks_and_people();
  const std::string golden = std::string(ROOMCAST_SOURCE_DIR) + "/tests/golden/recording_part.bin";
  const std::string part = open().moment(2500ms);
  if (std::getenv("ROOMCAST_UPDATE_GOLDEN") != nullptr) std::ofstream(golden) << part;
  std::ifstream file(golden, std::ios::binary);
  EXPECT_EQ(part, std::string(std::istreambuf_iterator<char>(file), {}));
}

TEST_F(RecordingPartTest, splits_very_many_marks_into_messages_that_a_page_takes) {
  const nanoseconds start = RecordingFixtureRoom::came(0);
  {
    auto writer = RoomRecordingWriter::create(path, "lab");
    ASSERT_TRUE(writer->add_roster(room.roster(), start).ok());
    for (std::uint32_t id = 1; id <= 200; ++id) {
      wire::pb::Marks more;
      auto& sketch = *more.add_marks() = mark(id);
      sketch.set_kind(wire::pb::MARK_KIND_SKETCH);
      sketch.clear_text();
      for (int i = 0; i < 3 * 200; ++i) sketch.add_points(0.5F);
      ASSERT_TRUE(writer->add_marks(more, start).ok());
    }
    ASSERT_TRUE(writer->finish().ok());
  }
  int marks = 0, messages = 0;
  const ReadPart part = read_part(open().moment(0s));
  for (const PartRecord& record : part.records) {
    const auto control = control_of(record);  // checks its size
    if (!record.past || !control.has_marks()) continue;
    EXPECT_EQ(control.marks().all(), messages++ == 0);
    marks += control.marks().marks_size();
  }
  EXPECT_EQ(marks, 200);
  EXPECT_GT(messages, 2);
}

}  // namespace
}  // namespace roomcast::recording
