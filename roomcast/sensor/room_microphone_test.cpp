// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/room_microphone.h"

#include <atomic>
#include <optional>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/client/hub_fixture.h"
#include "roomcast/client/network_thread.h"
#include "roomcast/core/interruptible_wait.h"

namespace roomcast::sensor {
namespace {

using namespace std::chrono_literals;

/// Gives blocks in real time until it is unplugged.
class FakeMicrophone final : public sound::Microphone {
 public:
  explicit FakeMicrophone(const std::atomic<bool>& is_plugged) : is_plugged_(is_plugged) {}
  Result<std::optional<Block>> next(const std::stop_token& stop) override {
    if (!is_plugged_) return unavailable("the microphone is gone");
    if (!wait_for(20ms, stop)) return std::optional<Block>();
    Block block;
    block.samples.fill(0.25F);
    block.first_sample = SteadyClock().now() - 20ms;
    return std::optional(block);
  }

 private:
  const std::atomic<bool>& is_plugged_;
};

class RoomMicrophoneTest : public testing::Test {
 protected:
  RoomMicrophoneTest() { network.start(); }
  ~RoomMicrophoneTest() override {
    microphone.reset();
    publisher.reset();
    network.finish([this] { hub.reset(); });
  }

  void join(bool lets_speak) {
    network.run([&] { hub->lets_speak = lets_speak; });
    client::PublisherOptions options;
    options.hub_url = hub->url();
    options.name = "left";
    options.calibration.depth = {.width = 64, .height = 48, .fx = 60, .fy = 60, .cx = 32, .cy = 24};
    options.calibration.color = options.calibration.depth;
    auto opened = client::Publisher::open(options);
    ASSERT_TRUE(opened.ok()) << opened.error().message;
    publisher = *std::move(opened);
    const auto open = [this]() -> Result<std::unique_ptr<sound::Microphone>> {
      if (!is_plugged) return unavailable("not there");
      return std::unique_ptr<sound::Microphone>(std::make_unique<FakeMicrophone>(is_plugged));
    };
    const LogSink log = [this](LogLevel, std::string_view) { ++logged; };
    microphone.emplace(*open(), open, *publisher, log);
  }
  std::vector<wire::AudioHeader> heard() {
    std::vector<wire::AudioHeader> voices;
    network.run([&] { voices = hub->voices; });
    return voices;
  }
  void say_frames_are(bool wanted) {
    network.run([&] {
      wire::pb::Control demand;
      demand.mutable_frame_demand()->set_wanted(wanted);
      hub->say(demand);
    });
  }

  client::NetworkThread network;
  std::optional<client::FakeHub> hub{std::in_place, network.io()};
  std::atomic<bool> is_plugged{true};
  std::unique_ptr<client::Publisher> publisher;
  std::optional<RoomMicrophone> microphone;
  std::atomic<int> logged{0};
};

TEST_F(RoomMicrophoneTest, the_hub_hears_it_and_that_it_pauses_while_nobody_is_there) {
  join(true);
  ASSERT_TRUE(client::wait_until_true([this] { return heard().size() > 3; }));
  EXPECT_NEAR(microphone->stats().loudness, 0.25, 1e-6);
  say_frames_are(false);
  ASSERT_TRUE(client::wait_until_true([this] { return heard().back().ends; }));
  const std::size_t until_then = heard().size();
  say_frames_are(true);
  ASSERT_TRUE(client::wait_until_true([&] { return heard().size() > until_then; }));
  EXPECT_EQ(heard()[until_then].seq, until_then) << "pauses are not counted";
}

TEST_F(RoomMicrophoneTest, a_room_that_forbids_it_is_told_of_once_and_hears_nothing) {
  join(false);
  ASSERT_TRUE(client::wait_until_true([this] { return logged > 0; }));
  std::this_thread::sleep_for(100ms);  // nothing more happens
  EXPECT_TRUE(heard().empty());
  EXPECT_EQ(logged, 1);
  EXPECT_FALSE(microphone->stats().is_permitted);
}

TEST_F(RoomMicrophoneTest, a_device_that_goes_away_is_heard_again_when_it_is_back) {
  join(true);
  ASSERT_TRUE(client::wait_until_true([this] { return !heard().empty(); }));
  is_plugged = false;
  ASSERT_TRUE(client::wait_until_true([this] { return !microphone->stats().is_connected; }));
  ASSERT_TRUE(client::wait_until_true([this] { return heard().back().ends; }));
  const std::size_t until_then = heard().size();
  is_plugged = true;
  EXPECT_TRUE(client::wait_until_true([&] { return heard().size() > until_then; }));
  EXPECT_TRUE(microphone->stats().is_connected);
}

}  // namespace
}  // namespace roomcast::sensor
