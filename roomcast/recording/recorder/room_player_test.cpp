// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/recorder/room_player.h"

#include <future>
#include <thread>

#include <gtest/gtest.h>

#include "roomcast/client/hub_fixture.h"
#include "roomcast/client/network_thread.h"
#include "roomcast/core/temporary_folder.h"
#include "roomcast/recording/room/recording_fixture.h"

namespace roomcast::recording {
namespace {

using recording::RecordingFixtureRoom;
using recording::RoomRecording;

class RoomPlayerTest : public testing::Test {
 protected:
  RoomPlayerTest() { network.start(); }
  ~RoomPlayerTest() override {
    player.reset();
    network.finish([this] { hub.reset(); });
  }

  void record(int instants) {
    RecordingFixtureRoom(1).record(path, instants);
    recording.emplace(std::move(*RoomRecording::open(path)));
  }
  Status open(double from_s = 0, double speed = 10, bool loop = false) {
    auto opened = RoomPlayer::open(*recording, {.hub_url = hub->url(),
                                                .room = {},
                                                .credential = {.token = "sesame", .code = {}},
                                                .from_s = from_s,
                                                .speed = speed,
                                                .loop = loop,
                                                .log = {}});
    if (!opened) return opened.error();
    player = std::move(*opened);
    return {};
  }
  std::vector<wire::FrameHeader> received() {
    std::promise<std::vector<wire::FrameHeader>> frames;
    boost::asio::post(network.io(), [&] { frames.set_value(hub->frames); });
    return frames.get_future().get();
  }

  client::NetworkThread network;
  std::optional<client::FakeHub> hub{std::in_place, network.io()};
  TemporaryFolder folder;
  std::filesystem::path path = folder / "room.mcap";
  std::optional<RoomRecording> recording;
  std::unique_ptr<RoomPlayer> player;
};

TEST_F(RoomPlayerTest, sends_its_token_for_every_sensor) {
  record(12);
  ASSERT_TRUE(open().ok());
  std::promise<std::vector<wire::pb::Control>> heard;
  boost::asio::post(network.io(), [&] { heard.set_value(hub->heard); });
  const auto messages = heard.get_future().get();
  ASSERT_FALSE(messages.empty());
  for (const auto& control : messages) EXPECT_EQ(control.join().token(), "sesame");
}

TEST_F(RoomPlayerTest, sends_every_frame_at_the_recorded_distances) {
  record(12);
  ASSERT_TRUE(open().ok());
  ASSERT_TRUE(player->run({}).ok());
  player.reset();
  const auto frames = received();
  ASSERT_EQ(frames.size(), 12u);
  for (std::size_t i = 1; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].seq, i);
    EXPECT_EQ(frames[i].key, i % RecordingFixtureRoom::kFramesPerKey == 0);
    const auto distance = frames[i].capture_time - frames[i - 1].capture_time;
    EXPECT_NEAR(static_cast<double>(distance.count()), RecordingFixtureRoom::kPeriod.count() / 10.0,
                1e6);
  }
}

TEST_F(RoomPlayerTest, begins_with_the_key_frame_before_the_given_time) {
  record(40);
  ASSERT_TRUE(open(3.2).ok());
  ASSERT_TRUE(player->run({}).ok());
  player.reset();
  const auto frames = received();
  EXPECT_TRUE(frames.at(0).key);
  EXPECT_GE(frames.size(), 10u);  // 30 to 39
  EXPECT_LE(frames.size(), 20u);
}

TEST_F(RoomPlayerTest, starts_again_at_the_end_until_it_is_stopped) {
  record(6);
  ASSERT_TRUE(open(0, 10, true).ok());
  std::jthread thread([this](const std::stop_token& stop) { (void)player->run(stop); });
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  while (player->progress().frames_sent < 14 && std::chrono::steady_clock::now() < give_up)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  thread.request_stop();
  thread.join();
  EXPECT_GE(player->progress().frames_sent, 14u);
}

TEST_F(RoomPlayerTest, refuses_a_speed_that_makes_no_sense) {
  record(2);
  for (const double speed : {0.0, -1.0, 11.0, std::nan("")}) {
    const auto status = open(0, speed);
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.error().code, ErrorCode::kInvalidArgument);
  }
}

}  // namespace
}  // namespace roomcast::recording
