// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/hub_link.h"

#include <gtest/gtest.h>

#include "roomcast/client/hub_fixture.h"

namespace roomcast::client {
namespace {

using namespace std::chrono_literals;

class Heard final : public HubLinkEvents {
 public:
  void on_welcome(const wire::pb::Welcome& welcome) override { welcomes.push_back(welcome); }
  void on_control(const wire::pb::Control& message) override { controls.push_back(message); }
  void on_frame(net::MessageBuffer message) override { frame_sizes.push_back(message.size()); }
  net::FramedMessagePtr next_frame() override { return std::exchange(frame, nullptr); }
  void on_clock(const ClockEstimate& estimate) override { clock = estimate; }
  void on_down(const Error& reason, bool final) override {
    down.push_back(reason.message);
    is_final = final;
  }

  std::vector<wire::pb::Welcome> welcomes;
  std::vector<wire::pb::Control> controls;
  std::vector<std::size_t> frame_sizes;
  net::FramedMessagePtr frame;
  std::optional<ClockEstimate> clock;
  std::vector<std::string> down;
  bool is_final = false;
};

wire::pb::Join viewers_join() {
  wire::pb::Join join;
  join.set_name("left");
  join.mutable_viewer();
  return join;
}

class HubLinkTest : public testing::Test {
 protected:
  static wire::pb::Join join() { return viewers_join(); }

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

  /// Answers every request with 404, like a proxy whose hub is down.
  std::unique_ptr<net::HttpServer> web_server(std::uint16_t port) {
    net::HttpServerOptions options;
    options.port = port;
    options.websocket_path = "/elsewhere";
    options.on_get = [](std::string_view, std::string_view) { return std::nullopt; };
    return std::move(*net::HttpServer::listen(io, std::move(options)));
  }

  boost::asio::io_context io;
  std::optional<FakeHub> hub{std::in_place, io};
  Heard heard;
  HubLink link{io, *net::parse_hub_urls(hub->url()), join(), heard};
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

/// A hub whose event loop has stopped: its connections stay open, and nothing arrives.
TEST(HubLink, a_hub_that_falls_silent_is_given_up_and_tried_again) {
  boost::asio::io_context hub_io, io;
  FakeHub hub(hub_io);
  Heard heard;
  wire::pb::Join join;
  join.mutable_viewer();
  HubLink link(io, *net::parse_hub_urls(hub.url()), join, heard,
               HubLink::Options{
                   .timings = net::ConnectionTimings{.ping_after = 20ms, .give_up_after = 60ms}});
  link.start();
  const auto both_run_until_welcome = [&](std::size_t number) {
    const auto give_up = std::chrono::steady_clock::now() + 5s;
    while (heard.welcomes.size() < number && std::chrono::steady_clock::now() < give_up) {
      hub_io.run_one_for(1ms);
      io.run_one_for(1ms);
    }
    ASSERT_EQ(heard.welcomes.size(), number);
  };
  both_run_until_welcome(1);
  while (heard.down.empty()) ASSERT_GT(io.run_one_for(5s), 0u);
  EXPECT_FALSE(heard.is_final);
  EXPECT_NE(heard.down[0].find("ended"), std::string::npos) << heard.down[0];
  both_run_until_welcome(2);
}

TEST_F(HubLinkTest, other_servers_are_not_tried_again) {
  const std::uint16_t port = hub->port();
  hub.reset();
  const auto web = web_server(port);
  link.start();
  run_until([&] { return !heard.down.empty(); });
  EXPECT_TRUE(heard.is_final);
}

TEST_F(HubLinkTest, a_proxy_is_tried_until_its_hub_is_back) {
  welcomed();
  const std::uint16_t port = hub->port();
  hub->hang_up();
  run_until([&] { return heard.down.size() == 1; });
  hub.reset();
  auto proxy = web_server(port);
  run_until([&] { return heard.down.size() == 2; });
  EXPECT_FALSE(heard.is_final);
  proxy.reset();
  hub.emplace(io, port);
  run_until([&] { return heard.welcomes.size() == 2; });
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

TEST_F(HubLinkTest, gives_up_when_it_is_refused_on_joining) {
  hub->refuse_joins_with = wire::pb::ERROR_MALFORMED;
  link.start();
  run_until([&] { return !heard.down.empty(); });
  EXPECT_TRUE(heard.is_final);
}

TEST_F(HubLinkTest, tries_again_after_a_fault_that_need_not_come_again) {
  welcomed();
  hub->refuse(wire::pb::ERROR_MALFORMED, "this frame was captured in the future");
  run_until([&] { return heard.welcomes.size() == 2; });
  EXPECT_FALSE(heard.is_final);
}

TEST_F(HubLinkTest, goes_on_at_the_next_hub_at_once_when_one_is_gone) {
  FakeHub next(io);
  Heard heard_of_either;
  HubLink either(io, *net::parse_hub_urls(hub->url() + "," + next.url()), join(), heard_of_either);
  either.start();
  run_until([&] { return heard_of_either.welcomes.size() == 1; });
  EXPECT_TRUE(next.heard.empty());
  hub->hang_up();
  run_until([&] { return heard_of_either.welcomes.size() == 2; });
  EXPECT_FALSE(next.heard.empty());
  EXPECT_EQ(heard_of_either.down.size(), 1u);
}

TEST_F(HubLinkTest, goes_on_where_a_busy_hub_sends_it_and_says_that_it_was_sent) {
  FakeHub next(io);
  hub->lets_joins_wait = true;
  link.start();
  run_until([&] { return hub->heard.size() == 1; });
  EXPECT_FALSE(hub->heard.at(0).join().redirected());
  wire::pb::Control others;
  others.mutable_other_hubs()->add_urls(next.url());
  hub->say(others);
  hub->refuse(wire::pb::ERROR_BUSY, "this hub is busy");
  run_until([&] { return heard.welcomes.size() == 1; });
  EXPECT_TRUE(heard.down.empty());
  ASSERT_FALSE(next.heard.empty());
  EXPECT_TRUE(next.heard.at(0).join().redirected());
  next.hang_up();
  hub->lets_joins_wait = false;
  run_until([&] { return heard.welcomes.size() == 2; });
  EXPECT_FALSE(hub->heard.back().join().redirected()) << "it comes anew";
}

TEST_F(HubLinkTest, a_hub_that_answers_no_join_is_left_after_a_while) {
  hub->lets_joins_wait = true;
  Heard impatient;
  HubLink::Options options;
  options.timings = net::ConnectionTimings{.ping_after = 100ms, .give_up_after = 300ms};
  HubLink waiting(io, *net::parse_hub_urls(hub->url()), join(), impatient, options);
  waiting.start();
  run_until([&] { return impatient.down.size() == 1; });
  EXPECT_NE(impatient.down[0].find("does not answer"), std::string::npos);
  hub->lets_joins_wait = false;
  run_until([&] { return impatient.welcomes.size() == 1; });
}

TEST_F(HubLinkTest, goes_on_at_a_hub_that_its_hub_has_named) {
  FakeHub next(io);
  welcomed();
  wire::pb::Control others;
  others.mutable_other_hubs()->add_urls(next.url());
  hub->say(others);
  wire::pb::Control last;
  last.mutable_roster();
  hub->say(last);
  run_until([&] { return heard.controls.size() == 1; });
  hub->hang_up();
  run_until([&] { return heard.welcomes.size() == 2; });
  EXPECT_FALSE(next.heard.empty());
}

/// A hub that names another one and then hangs.
class HubThatHangs : public testing::Test {
 protected:
  explicit HubThatHangs(std::chrono::nanoseconds far_away = {}) {
    hangs.far_away = far_away;
    hangs.on_join = [this] {
      wire::pb::Control others;
      others.mutable_other_hubs()->add_urls(next.url());
      hangs.say(others);
    };
    link.start();
    run_both_until([this] { return heard.clock.has_value(); });
  }

  /// Waits until the client is at the other hub. Returns a lower bound of the time without
  /// messages.
  std::chrono::nanoseconds wait_until_left() {
    const auto begin = std::chrono::steady_clock::now();
    wire::pb::Control last;
    last.mutable_roster();
    hangs.say(last);
    run_both_until([this] { return !heard.controls.empty(); });
    while (heard.welcomes.size() < 2 && io.run_one_until(begin + 5s) > 0) {
    }
    EXPECT_EQ(heard.welcomes.size(), 2u);
    EXPECT_EQ(next.joins, 1);
    return std::chrono::steady_clock::now() - begin;
  }

  template <class Done>
  void run_both_until(Done done) {
    while (!done()) {
      hub_io.run_one_for(1ms);
      io.run_one_for(1ms);
    }
  }

  boost::asio::io_context hub_io, io;
  FakeHub hangs{hub_io}, next{io};
  Heard heard;
  HubLink link{io, *net::parse_hub_urls(hangs.url()), viewers_join(), heard};
};

/// The client learns of the other hub while it is connected; the shorter timeout applies from then
/// on.
TEST_F(HubThatHangs, is_left_soon) {
  static_assert(HubLink::kTimings.give_up_after > 5s);
  wait_until_left();
}

class HubThatHangsFarAway : public HubThatHangs {
 protected:
  HubThatHangsFarAway() : HubThatHangs(600ms) {}
};

TEST_F(HubThatHangsFarAway, is_given_the_time_that_its_answers_take) {
  EXPECT_GE(wait_until_left(), HubLink::kTimingsWithOthers.give_up_after + 600ms);
}

TEST_F(HubLinkTest, where_the_next_hub_does_not_know_us_it_comes_back_to_the_first) {
  FakeHub stranger(io);
  stranger.refuse_joins_with = wire::pb::ERROR_TOKEN_INVALID;
  Heard heard_of_either;
  HubLink either(io, *net::parse_hub_urls(hub->url() + "," + stranger.url()), join(),
                 heard_of_either);
  either.start();
  run_until([&] { return heard_of_either.welcomes.size() == 1; });
  hub->hang_up();
  run_until([&] { return heard_of_either.welcomes.size() == 2; });
  EXPECT_FALSE(heard_of_either.is_final);
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
}  // namespace roomcast::client
