// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/hub_link.h"

#include <gtest/gtest.h>

#include "roomcast/client/fake_hub.h"

namespace roomcast {
namespace {

using namespace std::chrono_literals;

class Heard final : public HubLinkEvents {
 public:
  void on_welcome(const wire::pb::Welcome& welcome) override { welcomes.push_back(welcome); }
  void on_control(const wire::pb::Control& message) override { controls.push_back(message); }
  void on_frame(net::MessageBuffer message) override { frame_sizes.push_back(message.size()); }
  net::SealedMessagePtr next_frame() override { return std::exchange(frame, nullptr); }
  void on_clock(const ClockEstimate& estimate) override { clock = estimate; }
  void on_down(const Error& reason, bool final) override {
    down.push_back(reason.message);
    is_final = final;
  }

  std::vector<wire::pb::Welcome> welcomes;
  std::vector<wire::pb::Control> controls;
  std::vector<std::size_t> frame_sizes;
  net::SealedMessagePtr frame;
  std::optional<ClockEstimate> clock;
  std::vector<std::string> down;
  bool is_final = false;
};

class HubLinkTest : public testing::Test {
 protected:
  static wire::pb::Join join() {
    wire::pb::Join join;
    join.set_name("left");
    join.mutable_viewer();
    return join;
  }

  template <class Done>
  void run_until(Done done) {
    const auto give_up = std::chrono::steady_clock::now() + 5s;
    while (!done() && io.run_one_until(give_up) > 0) {
    }
    ASSERT_TRUE(done());
  }

  void welcomed() {
    link.start();
    run_until([&] { return heard.welcomes.size() == 1; });
  }

  boost::asio::io_context io;
  std::optional<FakeHub> hub{std::in_place, io};
  Heard heard;
  HubLink link{io, *net::parse_hub_url(hub->url()), join(), heard};
};

TEST_F(HubLinkTest, joins_first) {
  welcomed();
  ASSERT_FALSE(hub->heard.empty());
  EXPECT_EQ(hub->heard[0].join().name(), "left");
  EXPECT_EQ(heard.welcomes[0].room(), "lab");
}

TEST_F(HubLinkTest, learns_room_time_to_within_its_bound) {
  hub->clock_ahead = 1h;
  welcomed();
  run_until([&] { return heard.clock.has_value(); });
  EXPECT_LE(std::chrono::abs(heard.clock->room_minus_host - 1h), heard.clock->error);
}

TEST_F(HubLinkTest, passes_messages_both_ways) {
  welcomed();
  wire::pb::Control roster;
  roster.mutable_roster()->set_revision(3);
  hub->say(roster);
  run_until([&] { return heard.controls.size() == 1; });
  EXPECT_EQ(heard.controls[0].roster().revision(), 3u);
  wire::pb::Control request;
  request.mutable_key_request()->set_sensor_id(2);
  link.send(request);
  run_until([&] { return hub->heard.size() == 2; });
  EXPECT_EQ(hub->heard[1].key_request().sensor_id(), 2u);
}

TEST_F(HubLinkTest, comes_back_when_the_connection_breaks) {
  welcomed();
  hub->hang_up();
  run_until([&] { return heard.welcomes.size() == 2; });
  EXPECT_EQ(heard.down.size(), 1u);
  EXPECT_NE(heard.down[0].find("the hub stops"), std::string::npos);
  EXPECT_FALSE(heard.is_final);
}

TEST_F(HubLinkTest, waits_for_a_hub_that_is_not_there_yet) {
  const std::uint16_t port = hub->port();
  hub.reset();
  link.start();
  run_until([&] { return heard.down.size() == 2; });
  hub.emplace(io, port);
  run_until([&] { return heard.welcomes.size() == 1; });
}

TEST_F(HubLinkTest, gives_up_when_the_hub_says_that_trying_again_is_useless) {
  welcomed();
  hub->refuse(wire::pb::ERROR_REPLACED, "somebody else is left now");
  run_until([&] { return !heard.down.empty(); });
  EXPECT_TRUE(heard.is_final);
  EXPECT_EQ(heard.down[0], "the hub says: somebody else is left now");
}

TEST_F(HubLinkTest, tries_again_when_the_room_was_only_full) {
  welcomed();
  hub->refuse(wire::pb::ERROR_ROOM_FULL, "full");
  run_until([&] { return heard.welcomes.size() == 2; });
  EXPECT_FALSE(heard.is_final);
}

TEST_F(HubLinkTest, stops_in_good_order_and_without_work_left) {
  welcomed();
  link.stop();
  hub.reset();
  EXPECT_GT(io.run_for(5s), 0u);
  EXPECT_TRUE(io.stopped());
  EXPECT_TRUE(heard.down.empty()) << "who leaves is not told so";
}

}  // namespace
}  // namespace roomcast
