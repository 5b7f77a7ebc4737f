// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/voices/voice_export.h"

#include <fstream>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/recording/room/recording_fixture.h"
#include "roomcast/recording/voices/voice_fixture.h"

namespace roomcast::recording {
namespace {

using namespace std::chrono_literals;

constexpr std::uint32_t kAda = 3, kBob = 8;
// The recording of these tests begins with its first message, which is at once.
constexpr nanoseconds kStart = RecordingFixtureRoom::kUnixMinusRoom + 5s;

class VoiceExportTest : public testing::Test {
 protected:
  VoiceExportTest() : writer(*RoomRecordingWriter::create(path, "lab")) {
    EXPECT_TRUE(writer.add_clock({RecordingFixtureRoom::kUnixMinusRoom, {}}, kStart).ok());
    wire::pb::Roster roster = room.roster();
    add(roster, kAda, "Ada/..");
    add(roster, kBob, "Bob");
    EXPECT_TRUE(writer.add_roster(roster, kStart).ok());
  }
  static void add(wire::pb::Roster& roster, std::uint32_t id, const std::string& name) {
    auto& viewer = *roster.add_viewers();
    viewer.set_id(id);
    viewer.set_name(name);
  }

  void stand(std::uint32_t viewer, float x, nanoseconds at) {
    wire::pb::ViewerPoses poses;
    auto& pose = *poses.add_poses();
    pose.set_viewer_id(viewer);
    pose.mutable_head()->set_x(x);
    pose.mutable_head()->set_qw(1);
    EXPECT_TRUE(writer.add_poses(poses, kStart + at).ok());
  }
  /// A tone of 440 Hz, from `at` on.
  void say(std::uint32_t viewer, nanoseconds at, nanoseconds length, float loudness = 0.4F) {
    VoiceFixture voice(VoiceFixture::tone(loudness));
    for (nanoseconds t = at; t < at + length; t += 20ms) {
      const auto packet = RecordingFixtureRoom::voice(viewer, seq_++, 5s + t, voice.next_packet(),
                                                      t + 20ms >= at + length);
      EXPECT_TRUE(writer.add_voice(packet, kStart + t + 30ms).ok());
    }
  }
  void end(nanoseconds at) {
    EXPECT_TRUE(writer.add_roster(room.roster(), kStart + at).ok());
    EXPECT_TRUE(writer.finish().ok());
  }
  Result<VoiceExport> write(VoiceExportOptions options = {}) {
    options.out = folder / "voices";
    auto recording = RoomRecording::open(path);
    if (!recording) return recording.error();
    return export_voices(*recording, options);
  }
  ReadWav wav(const std::string& name) const { return read_wav(folder / "voices" / name); }

  TemporaryFolder folder;
  std::filesystem::path path = folder / "room.mcap";
  RecordingFixtureRoom room;
  RoomRecordingWriter writer;
  std::uint32_t seq_ = 0;
};

TEST_F(VoiceExportTest, everybody_is_heard_when_they_spoke) {
  say(kAda, 1s, 1s);
  say(kBob, 3s, 500ms, 0.2F);
  end(5s);
  const auto done = write({.out = {}, .per_person = true});
  ASSERT_TRUE(done.ok()) << done.error().message;
  EXPECT_DOUBLE_EQ(done->seconds, 5);
  const ReadWav all = wav("voices.wav");
  EXPECT_EQ(all.channels, 1);
  EXPECT_EQ(all.length(), 5u * voice::kVoiceRate_hz);
  EXPECT_EQ(all.loudness(0, 0.98), 0);
  EXPECT_NEAR(all.loudness(1.1, 1.9), 0.4 / std::sqrt(2), 0.03);
  EXPECT_EQ(all.loudness(2.02, 2.98), 0);
  EXPECT_NEAR(all.loudness(3.1, 3.4), 0.2 / std::sqrt(2), 0.02);
  EXPECT_EQ(wav("Ada-...wav").loudness(3, 4), 0) << "a name that is no path";
  EXPECT_EQ(wav("Bob.wav").loudness(1, 2), 0);
  EXPECT_EQ(wav("Bob.wav").length(), all.length());
  ASSERT_EQ(done->people.size(), 2u);
  EXPECT_EQ(done->people[0].person, "Ada/..");
  EXPECT_NEAR(done->people[0].first_s, 1, 0.01);
  EXPECT_NEAR(done->people[0].last_s, 2, 0.01);
  EXPECT_NEAR(done->people[0].speech_s, 1, 0.01);
  std::ifstream list(folder / "voices" / "voices.csv");
  std::string line;
  std::getline(list, line);
  std::getline(list, line);
  EXPECT_TRUE(line.starts_with("\"Ada-...wav\",\"Ada/..\",3,0.99")) << line;
}

TEST_F(VoiceExportTest, a_sensors_microphone_is_heard_under_its_name_from_where_it_stands) {
  const std::uint32_t left = wire::speaker_of(SensorId{10}).value;   // at x = 0
  const std::uint32_t right = wire::speaker_of(SensorId{11}).value;  // at x = 0.5
  say(left, 1s, 1s);
  say(right, 3s, 1s);
  say(wire::speaker_of(SensorId{77}).value, 4500ms, 100ms);
  end(5s);
  VoiceExportOptions options{.out = {}, .per_person = true};
  options.listener = [](nanoseconds) {
    return RigidTransform{Eigen::Matrix3d::Identity(), {0.25, 1.5, 0}};
  };
  const auto done = write(options);
  ASSERT_TRUE(done.ok()) << done.error().message;
  ASSERT_EQ(done->people.size(), 3u);
  EXPECT_EQ(done->people[0].person, "s0");
  EXPECT_EQ(done->people[1].person, "s1");
  EXPECT_EQ(done->people[2].person, "sensor 77");
  EXPECT_GT(wav("s0.wav").loudness(1.1, 1.9), 0.2);
  const ReadWav all = wav("voices.wav");
  EXPECT_GT(all.loudness(1.1, 1.9, 0), 2 * all.loudness(1.1, 1.9, 1)) << "it stands on the left";
  EXPECT_GT(all.loudness(3.1, 3.9, 1), 2 * all.loudness(3.1, 3.9, 0));
}

TEST_F(VoiceExportTest, a_click_is_where_it_was_made_to_a_millisecond) {
  VoiceFixture voice(
      [](std::int64_t sample) { return sample >= 4800 && sample < 4824 ? 0.8F : 0; });
  for (int n = 0; n < 20; ++n) {
    const auto packet = RecordingFixtureRoom::voice(kAda, static_cast<std::uint32_t>(n),
                                                    6s + n * 20ms, voice.next_packet());
    ASSERT_TRUE(writer.add_voice(packet, kStart + 1s + n * 20ms).ok());
  }
  end(2s);
  ASSERT_TRUE(write().ok());
  const ReadWav all = wav("voices.wav");
  const auto loudest =
      std::ranges::max_element(all.samples, {}, [](float s) { return std::abs(s); });
  EXPECT_NEAR(static_cast<double>(loudest - all.samples.begin()) / voice::kVoiceRate_hz, 1.1,
              0.001);
}

TEST_F(VoiceExportTest, a_part_of_it_begins_and_ends_where_it_was_asked) {
  say(kAda, 1s, 1s);
  end(5s);
  ASSERT_TRUE(write({.out = {}, .from = 1500ms, .to = 3s}).ok());
  const ReadWav all = wav("voices.wav");
  EXPECT_EQ(all.length(), 3u * voice::kVoiceRate_hz / 2);
  EXPECT_GT(all.loudness(0, 0.4), 0.2);
  EXPECT_EQ(all.loudness(0.52, 1.5), 0);
}

TEST_F(VoiceExportTest, in_stereo_people_are_where_they_stand) {
  stand(kAda, 2, 500ms);
  stand(kBob, -2, 500ms);
  say(kAda, 1s, 500ms);
  say(kBob, 2s, 500ms);
  end(3s);
  ASSERT_TRUE(write({.out = {}, .listener = [](nanoseconds) { return RigidTransform(); }}).ok());
  const ReadWav all = wav("voices.wav");
  EXPECT_EQ(all.channels, 2);
  EXPECT_EQ(all.length(), 3u * voice::kVoiceRate_hz);
  EXPECT_GT(all.loudness(1.1, 1.4, 1), 20 * all.loudness(1.1, 1.4, 0)) << "Ada: right";
  EXPECT_GT(all.loudness(2.1, 2.4, 0), 20 * all.loudness(2.1, 2.4, 1)) << "Bob: left";
}

TEST_F(VoiceExportTest, people_of_one_name_have_their_own_files) {
  wire::pb::Roster roster = room.roster();
  add(roster, 20, "Cy");
  add(roster, 21, "Cy");
  add(roster, 22, "");
  ASSERT_TRUE(writer.add_roster(roster, kStart + 1ms).ok());
  say(20, 1s, 100ms);
  say(21, 1s, 100ms);
  say(22, 1s, 100ms);
  end(2s);
  ASSERT_TRUE(write({.out = {}, .per_person = true}).ok());
  for (const char* name : {"Cy.wav", "Cy-2.wav", "viewer 22.wav"})
    EXPECT_GT(wav(name).loudness(1, 1.1), 0.1) << name;
}

TEST_F(VoiceExportTest, without_voices_says_so_and_leaves_no_file) {
  end(2s);
  const auto done = write();
  EXPECT_EQ(done.error().code, ErrorCode::kNotFound);
  EXPECT_TRUE(std::filesystem::is_empty(folder / "voices"));
}

TEST_F(VoiceExportTest, a_room_that_may_not_be_exported_is_not) {
  say(kAda, 1s, 100ms);
  ASSERT_TRUE(writer.forbid_export().ok());
  end(2s);
  EXPECT_EQ(write().error().code, ErrorCode::kUnavailable);
}

TEST_F(VoiceExportTest, what_cannot_be_right_is_left_out) {
  const std::vector<std::uint8_t> noise{0x78, 1, 2, 3};
  const auto hour_ahead = RecordingFixtureRoom::voice(kAda, 1, 5s + 1h, noise);
  ASSERT_TRUE(writer.add_voice(hour_ahead, kStart + 1s).ok());
  say(kBob, 1s, 100ms);
  end(2s);
  const auto done = write();
  ASSERT_TRUE(done.ok());
  EXPECT_EQ(done->people.size(), 1u);
  EXPECT_EQ(wav("voices.wav").length(), 2u * voice::kVoiceRate_hz);
}

TEST_F(VoiceExportTest, a_damaged_part_is_left_out_and_counted) {
  for (int n = 0; n < 6; ++n) say(kAda, n * 1s, 1s);
  end(7s);
  {
    const auto sound = RoomRecording::open(path);
    const auto& chunk = sound->file().summary().chunks[4];
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(static_cast<std::streamoff>(chunk.offset + chunk.length / 2));
    file << "damage";
  }
  const auto done = write();
  ASSERT_TRUE(done.ok()) << done.error().message;
  EXPECT_EQ(done->damaged_parts, 1u);
  EXPECT_GT(wav("voices.wav").loudness(0.1, 0.9), 0.2);
  EXPECT_GT(wav("voices.wav").loudness(5.1, 5.9), 0.2);
}

}  // namespace
}  // namespace roomcast::recording
