// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/recorder/recorder.h"

#include <csignal>
#include <cstdlib>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "roomcast/client/hub_fixture.h"
#include "roomcast/client/network_thread.h"
#include "roomcast/core/temporary_folder.h"
#include "roomcast/recording/room/recording_cursor.h"
#include "roomcast/recording/room/recording_fixture.h"

namespace roomcast::recording {
namespace {

using namespace std::chrono_literals;
using recording::RecordingFixtureRoom;
using recording::RoomRecording;

class RecorderTest : public testing::Test {
 protected:
  RecorderTest() { network.start(); }
  ~RecorderTest() override {
    recorder.reset();
    network.finish([this] { hub.reset(); });
  }

  Status open(RecorderOptions options = {}) {
    options.hub_url = hub->url();
    options.path = path;
    auto opened = Recorder::open(std::move(options));
    if (!opened) return opened.error();
    recorder = std::move(*opened);
    return {};
  }

  template <class Action>
  void on_hub(Action action) {
    network.run([&] { action(*hub); });
  }

  void say_roster() {
    wire::pb::Control control;
    *control.mutable_roster() = room.roster();
    on_hub([&](client::FakeHub& h) { h.say(control); });
  }
  std::vector<std::uint8_t> say_frame(int sensor, int instant) {
    auto bytes = room.frame(sensor, instant);
    on_hub([&](client::FakeHub& h) { h.say(net::frame_message(net::MessageBuffer(bytes))); });
    return bytes;
  }
  bool joined_again() {
    return within_5_s([&] {
      int joins = 0;
      on_hub([&](client::FakeHub& h) { joins = h.joins; });
      return joins == 2;
    });
  }
  template <class Done>
  bool within_5_s(Done done) {
    const auto give_up = std::chrono::steady_clock::now() + 5s;
    while (!done() && std::chrono::steady_clock::now() < give_up) std::this_thread::sleep_for(1ms);
    return done();
  }

  client::NetworkThread network;
  std::optional<client::FakeHub> hub{std::in_place, network.io()};
  recording::RecordingFixtureRoom room;
  TemporaryFolder folder;
  std::filesystem::path path = folder / "room.mcap";
  std::unique_ptr<Recorder> recorder;
};

TEST_F(RecorderTest, keeps_the_same_bytes) {
  ASSERT_TRUE(open().ok());
  EXPECT_EQ(recorder->room(), "lab");
  say_roster();
  std::vector<std::vector<std::uint8_t>> said;
  for (int instant = 0; instant < 10; ++instant) {
    for (int sensor = 0; sensor < 2; ++sensor) said.push_back(say_frame(sensor, instant));
  }
  EXPECT_TRUE(within_5_s([&] { return recorder->stats().frames == said.size(); }));
  ASSERT_TRUE(recorder->finish().ok());
  const auto file = RoomRecording::open(path);
  ASSERT_TRUE(file.ok()) << file.error().message;
  EXPECT_FALSE(file->damage().has_value());
  recording::RecordingCursor cursor(*file);
  recording::RecordedMessage message;
  std::size_t count = 0;
  while (*cursor.next(message)) {
    if (message.kind != recording::MessageKind::kFrame) continue;
    EXPECT_TRUE(std::ranges::equal(message.message.data, said[count++]));
  }
  EXPECT_EQ(count, said.size());
  EXPECT_TRUE(file->may_be_exported());
}

TEST_F(RecorderTest, keeps_the_marks_of_the_room) {
  ASSERT_TRUE(open().ok());
  say_roster();
  wire::pb::Control said;
  said.mutable_marks()->set_all(true);
  auto& mark = *said.mutable_marks()->add_marks();
  mark.set_kind(wire::pb::MARK_KIND_NOTE);
  for (const float metres : {1.f, 0.f, -2.f}) mark.add_points(metres);
  mark.set_text("mind the step");
  on_hub([&](client::FakeHub& h) { h.say(said); });
  say_frame(0, 0);
  EXPECT_TRUE(within_5_s([&] { return recorder->stats().frames == 1; }));
  ASSERT_TRUE(recorder->finish().ok());
  const auto file = RoomRecording::open(path);
  ASSERT_TRUE(file.ok());
  recording::RecordingCursor cursor(*file);
  recording::RecordedMessage message;
  std::vector<std::string> kept;
  while (*cursor.next(message)) {
    if (message.kind != recording::MessageKind::kMarks) continue;
    kept.emplace_back(message.message.data.begin(), message.message.data.end());
  }
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_EQ(kept[0], said.marks().SerializeAsString());
}

TEST_F(RecorderTest, keeps_voices_unless_they_are_not_wanted) {
  for (const bool wanted : {true, false}) {
    path = folder / (wanted ? "with.mcap" : "without.mcap");
    RecorderOptions options;
    options.voices = wanted;
    ASSERT_TRUE(open(std::move(options)).ok());
    on_hub([&](client::FakeHub& h) { EXPECT_EQ(h.heard.back().join().viewer().hears(), wanted); });
    say_roster();
    const std::vector<std::uint8_t> payload{0x78, 1, 2};
    const auto said = RecordingFixtureRoom::voice(7, 3, RecordingFixtureRoom::capture(0), payload);
    on_hub([&](client::FakeHub& h) { h.say(net::frame_message(net::MessageBuffer(said))); });
    say_frame(0, wanted ? 0 : 5);
    EXPECT_TRUE(within_5_s([&] { return recorder->stats().frames == 1; }));
    EXPECT_EQ(recorder->stats().voice_packets, wanted ? 1u : 0u);
    ASSERT_TRUE(recorder->finish().ok());
    recorder.reset();
    const auto file = RoomRecording::open(path);
    ASSERT_TRUE(file.ok());
    recording::RecordingCursor cursor(*file);
    recording::RecordedMessage message;
    std::vector<std::vector<std::uint8_t>> kept;
    while (*cursor.next(message)) {
      if (message.kind != recording::MessageKind::kVoice) continue;
      kept.emplace_back(message.message.data.begin(), message.message.data.end());
    }
    EXPECT_EQ(kept.size(), wanted ? 1u : 0u);
    if (wanted) {
      EXPECT_EQ(kept.front(), said);
    }
  }
}

/// Nobody knows whether the hub has answered at the moment of the request.
TEST_F(RecorderTest, that_is_stopped_while_it_opens_leaves_a_whole_file_or_none) {
  int opened = 0;
  for (int n = 0; n < 100; ++n) {
    path = folder / (std::to_string(n) + ".mcap");
    std::stop_source stop;
    const std::jthread stopping([&](const std::stop_token& ended) {
      while (!std::filesystem::exists(path) && !ended.stop_requested()) std::this_thread::yield();
      stop.request_stop();
    });
    RecorderOptions options;
    options.stop = stop.get_token();
    const Status status = open(std::move(options));
    EXPECT_EQ(status.ok(), std::filesystem::exists(path)) << n;
    if (!status) continue;
    ++opened;
    EXPECT_TRUE(recorder->finish().ok());
    const auto file = RoomRecording::open(path);
    ASSERT_TRUE(file.ok()) << file.error().message;
    EXPECT_FALSE(file->damage().has_value());
  }
  EXPECT_GT(opened, 0);
}

TEST_F(RecorderTest, a_single_frame_is_on_disk_within_a_second) {
  ASSERT_TRUE(open().ok());
  say_roster();
  say_frame(0, 0);
  EXPECT_TRUE(within_5_s([&] {
    const auto file = RoomRecording::open(path);
    return file.ok() && !file->sensors().empty() && file->sensors()[0].frame_count == 1;
  }));
}

/// How often to begin and end a recording. Many: ROOMCAST_RECORDINGS=10000 roomcast_recorder_test
int rounds_wanted() {
  const char* const wanted = std::getenv("ROOMCAST_RECORDINGS");
  return wanted == nullptr ? 100 : std::atoi(wanted);
}

/// The chunk is looked at all the time, so finish() often meets a timer that is due already.
TEST_F(RecorderTest, finish_ends_although_a_timer_is_due) {
  RecorderOptions options;
  options.look_after_chunk = nanoseconds(0);
  for (int round = 0; round < rounds_wanted(); ++round) {
    ASSERT_TRUE(open(options).ok());
    ASSERT_TRUE(recorder->finish().ok());
    std::filesystem::remove(path);
  }
}

TEST_F(RecorderTest, finish_ends_in_the_midst_of_frames) {
  for (int round = 0; round < rounds_wanted(); ++round) {
    ASSERT_TRUE(open().ok());
    say_roster();
    say_frame(0, 0);
    ASSERT_TRUE(within_5_s([&] { return recorder->stats().frames > 0; }));
    for (int instant = 1; instant < round % 5; ++instant) say_frame(round % 2, instant);
    ASSERT_TRUE(recorder->finish().ok());
    const auto file = RoomRecording::open(path);
    ASSERT_TRUE(file.ok()) << file.error().message;
    EXPECT_FALSE(file->damage().has_value());
    std::filesystem::remove(path);
  }
}

TEST_F(RecorderTest, says_that_it_records) {
  ASSERT_TRUE(open().ok());
  on_hub([](client::FakeHub& h) { EXPECT_TRUE(h.heard.at(0).join().viewer().records()); });
}

TEST_F(RecorderTest, sends_its_token_and_joins_as_an_aligner_too_where_bundles_are_kept) {
  RecorderOptions options;
  options.credential.token = "sesame";
  options.bundles = true;
  ASSERT_TRUE(open(std::move(options)).ok());
  std::vector<wire::pb::Control> heard;
  EXPECT_TRUE(within_5_s([&] {
    on_hub([&](client::FakeHub& h) { heard = h.heard; });
    return heard.size() == 2;
  }));
  for (const auto& control : heard) EXPECT_EQ(control.join().token(), "sesame");
  EXPECT_NE(heard.at(0).join().has_aligner(), heard.at(1).join().has_aligner());
}

TEST_F(RecorderTest, overwrites_nothing) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  std::fclose(file);
  const auto status = open();
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.error().message.find("nothing is overwritten"), std::string::npos);
}

TEST_F(RecorderTest, a_refusal_leaves_no_file) {
  on_hub([](client::FakeHub& h) { h.refuse_joins_with = wire::pb::ERROR_NO_SUCH_ROOM; });
  ASSERT_FALSE(open().ok());
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(RecorderTest, a_token_that_no_hub_can_read_leaves_no_file) {
  RecorderOptions options;
  options.credential.token = "\xff";
  EXPECT_EQ(open(options).error().code, ErrorCode::kMalformed);
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(RecorderTest, goes_on_when_the_hub_comes_back) {
  ASSERT_TRUE(open().ok());
  say_roster();
  say_frame(0, 0);
  EXPECT_TRUE(within_5_s([&] { return recorder->stats().frames == 1; }));
  on_hub([](client::FakeHub& h) { h.hang_up(); });
  EXPECT_TRUE(joined_again());
  say_roster();
  say_frame(0, 5);
  EXPECT_TRUE(within_5_s([&] { return recorder->stats().frames == 2; }));
  EXPECT_FALSE(recorder->failure().has_value());
}

TEST_F(RecorderTest, a_full_disk_ends_the_recording_with_a_sentence_and_the_file_can_be_read) {
  ASSERT_TRUE(open().ok());
  say_roster();
  say_frame(0, 0);
  EXPECT_TRUE(within_5_s([&] { return std::filesystem::file_size(path) > 1000; }));
  // A limit on the file size simulates a full disk.
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{std::filesystem::file_size(path) + 100, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &limit);
  for (int instant = 1; instant < 5; ++instant) say_frame(0, instant);
  EXPECT_TRUE(within_5_s([&] { return recorder->failure().has_value(); }));
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(recorder->failure()->message.find("cannot write to " + path.string()),
            std::string::npos);
  EXPECT_FALSE(recorder->finish().ok());
  const auto file = RoomRecording::open(path);
  ASSERT_TRUE(file.ok());
  EXPECT_EQ(file->sensors()[0].frame_count, 1u);
  EXPECT_EQ(recorder->stats().frames, 1u) << "those that did not fit are not counted";
}

TEST_F(RecorderTest, a_room_that_does_not_let_viewers_record_is_not_kept) {
  on_hub([](client::FakeHub& h) { h.lets_record = false; });
  const auto status = open();
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().message, "this room does not let viewers record");
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(RecorderTest, a_recording_ends_when_the_hub_withdraws_the_right_to_record) {
  ASSERT_TRUE(open().ok());
  on_hub([](client::FakeHub& h) {
    h.lets_record = false;
    h.hang_up();
  });
  ASSERT_TRUE(within_5_s([&] { return recorder->failure().has_value(); }));
  EXPECT_EQ(recorder->failure()->message, "this room does not let viewers record");
}

TEST_F(RecorderTest, the_file_states_a_later_ban_on_export_too) {
  ASSERT_TRUE(open().ok());
  say_roster();
  say_frame(0, 0);
  on_hub([](client::FakeHub& h) {
    h.lets_export = false;
    h.hang_up();
  });
  EXPECT_TRUE(joined_again());
  say_roster();
  say_frame(0, 5);
  EXPECT_TRUE(within_5_s([&] { return recorder->stats().frames == 2; }));
  ASSERT_TRUE(recorder->finish().ok());
  const auto file = RoomRecording::open(path);
  ASSERT_TRUE(file.ok()) << file.error().message;
  EXPECT_FALSE(file->may_be_exported());
  EXPECT_EQ(file->room(), "lab");
}

}  // namespace
}  // namespace roomcast::recording
