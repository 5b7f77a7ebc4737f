// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/voices/speak.h"

#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/client/hub_fixture.h"
#include "roomcast/client/network_thread.h"

namespace roomcast::client {
namespace {

using namespace std::chrono_literals;

class Speak : public testing::Test {
 protected:
  Speak() { network.start(); }
  ~Speak() override {
    room.reset();
    network.finish([this] { hub.reset(); });
  }
  void join(bool lets_speak) {
    network.run([&] { hub->lets_speak = lets_speak; });
    auto opened = Subscriber::open({.hub_url = hub->url(), .room = {}, .name = "Ada", .log = {}});
    ASSERT_TRUE(opened.ok()) << opened.error().message;
    room = std::move(*opened);
  }
  std::vector<wire::AudioHeader> heard() {
    std::vector<wire::AudioHeader> voices;
    network.run([&] { voices = hub->voices; });
    return voices;
  }

  NetworkThread network;
  std::optional<FakeHub> hub{std::in_place, network.io()};
  std::unique_ptr<Subscriber> room;
  SpokenVoice voice;
  const std::vector<float> packet = std::vector<float>(voice::kPacketSamples, 0.1F);
};

TEST_F(Speak, the_hub_hears_what_is_said_and_that_a_pause_follows) {
  join(true);
  const HostTime give_up = SteadyClock().now() + 10s;
  while (heard().empty() && SteadyClock().now() < give_up) {  // until the hub's clock is known
    std::this_thread::sleep_for(20ms);
    ASSERT_TRUE(speak(*room, voice, packet, SteadyClock().now()).ok());
  }
  ASSERT_FALSE(heard().empty());
  pause_speaking(*room, voice);
  while (!heard().back().ends && SteadyClock().now() < give_up) std::this_thread::sleep_for(5ms);
  EXPECT_TRUE(heard().back().ends);
}

TEST_F(Speak, a_room_that_lets_nobody_speak_says_so) {
  join(false);
  EXPECT_EQ(speak(*room, voice, packet, SteadyClock().now()).error().message,
            "this room does not let you speak");
  EXPECT_FALSE(voice.pause()) << "nothing was said";
}

}  // namespace
}  // namespace roomcast::client
