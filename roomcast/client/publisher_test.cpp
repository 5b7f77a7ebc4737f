// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/publisher.h"

#include <future>
#include <thread>

#include <gtest/gtest.h>

#include "roomcast/client/hub_fixture.h"
#include "roomcast/client/network_thread.h"

namespace roomcast::client {
namespace {

using namespace std::chrono_literals;

constexpr codec::EncodedFrameInfo kKey{.key = true, .layer = 0}, kBase{.key = false, .layer = 0},
    kDroppable{.key = false, .layer = 1};

class PublisherTest : public testing::Test {
 protected:
  PublisherTest() {
    network.start();
    PublisherOptions options;
    options.hub_url = hub.url();
    options.name = "left";
    options.takes_views = true;
    options.calibration.depth = {.width = 64, .height = 48, .fx = 60, .fy = 60, .cx = 32, .cy = 24};
    options.calibration.color = options.calibration.depth;
    auto opened = Publisher::open(options);
    EXPECT_TRUE(opened.ok()) << opened.error().message;
    publisher = std::move(*opened);
  }
  ~PublisherTest() override {
    publisher.reset();
    network.finish([this] { hub.close(); });
  }

  /// Evaluates `question` about the hub on its own thread.
  template <class Question>
  auto ask_hub(Question question) {
    std::promise<decltype(question(*hub))> answer;
    boost::asio::post(network.io(), [&] { answer.set_value(question(*hub)); });
    return answer.get_future().get();
  }

  /// Returns when the publisher knows it.
  void say_frames_are(bool wanted) {
    ask_hub([wanted](FakeHub& h) {
      wire::pb::Control demand;
      demand.mutable_frame_demand()->set_wanted(wanted);
      h.say(demand);
      return 0;
    });
    const auto give_up = std::chrono::steady_clock::now() + 5s;
    while (publisher->frames_wanted() != wanted && std::chrono::steady_clock::now() < give_up)
      std::this_thread::yield();
    ASSERT_EQ(publisher->frames_wanted(), wanted);
  }

  Publisher::Turn wait_for_turn() {
    const auto give_up = std::chrono::steady_clock::now() + 5s;
    for (;;) {
      if (const auto turn = publisher->next_turn()) return *turn;
      if (std::chrono::steady_clock::now() > give_up) {
        ADD_FAILURE() << "no turn came in 5 s";
        return {};
      }
      std::this_thread::yield();
    }
  }

  std::optional<Publisher::Published> publish(const Publisher::Turn& turn,
                                              const codec::EncodedFrameInfo& info,
                                              std::size_t payload_bytes = 100) {
    auto message = Publisher::begin_frame();
    message.appendable().resize(message.appendable().size() + payload_bytes);
    return publisher->publish(turn, info, SteadyClock().now(), std::move(message));
  }

  std::vector<wire::FrameHeader> wait_for_frames(std::size_t count) {
    const auto give_up = std::chrono::steady_clock::now() + 5s;
    for (;;) {
      auto frames = ask_hub([](FakeHub& h) { return h.frames; });
      if (frames.size() >= count || std::chrono::steady_clock::now() > give_up) return frames;
    }
  }

  /// The hub, with a handle to close it while its thread still runs.
  struct Hub {
    explicit Hub(boost::asio::io_context& io) : fake(std::in_place, io) {}
    FakeHub& operator*() { return *fake; }
    FakeHub* operator->() { return &*fake; }
    [[nodiscard]] std::string url() const { return fake->url(); }
    void close() { fake.reset(); }
    std::optional<FakeHub> fake;
  };

  NetworkThread network;
  Hub hub{network.io()};
  std::unique_ptr<Publisher> publisher;
};

TEST_F(PublisherTest, a_stop_ends_the_wait_for_a_hub_that_does_not_answer) {
  ask_hub([](auto& fake) { return fake.lets_joins_wait = true; });
  PublisherOptions options;
  options.hub_url = hub.url();
  options.name = "right";
  options.calibration.depth = {.width = 64, .height = 48, .fx = 60, .fy = 60, .cx = 32, .cy = 24};
  options.calibration.color = options.calibration.depth;
  std::stop_source stop;
  options.stop = stop.get_token();
  const std::jthread stopper([&] {
    std::this_thread::sleep_for(50ms);
    stop.request_stop();
  });
  const auto opened = Publisher::open(options);
  ASSERT_FALSE(opened.ok());
  EXPECT_EQ(opened.error().code, ErrorCode::kClosed);
  EXPECT_NE(opened.error().message.find("stopped"), std::string::npos);
}

TEST_F(PublisherTest, the_first_frame_has_to_be_a_key_frame) {
  EXPECT_TRUE(wait_for_turn().want_key);
  EXPECT_FALSE(publish(wait_for_turn(), kBase).has_value());
  EXPECT_TRUE(wait_for_turn().want_key) << "a frame that was lost asks for the next key frame";
}

TEST_F(PublisherTest, frames_are_numbered_and_name_the_frame_they_need) {
  std::size_t sent = 0;
  for (const auto& info : {kKey, kDroppable, kBase, kDroppable}) {
    ASSERT_TRUE(publish(wait_for_turn(), info).has_value());
    ASSERT_EQ(wait_for_frames(++sent).size(), sent);  // a turn that is refused counts as well
  }
  const auto frames = wait_for_frames(4);
  ASSERT_EQ(frames.size(), 4u);
  std::vector<std::uint32_t> bases;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].seq, i);
    EXPECT_EQ(frames[i].sensor, SensorId{5});
    bases.push_back(frames[i].base_seq);
  }
  EXPECT_EQ(bases, (std::vector<std::uint32_t>{0, 0, 0, 2}));
  EXPECT_EQ(frames[3].layer, 1);
}

TEST_F(PublisherTest, capture_times_are_room_time) {
  ASSERT_TRUE(publish(wait_for_turn(), kKey).has_value());
  const auto frames = wait_for_frames(1);
  ASSERT_EQ(frames.size(), 1u);
  const auto off =
      frames[0].capture_time.time_since_epoch() - SteadyClock().now().time_since_epoch();
  EXPECT_LT(std::chrono::abs(off),
            5s);  // both clocks are the same here; the test machine may stall
  EXPECT_NE(frames[0].clock_error_us, wire::kClockErrorUnknown);
}

TEST_F(PublisherTest, a_key_request_reaches_the_encoder) {
  ASSERT_TRUE(publish(wait_for_turn(), kKey).has_value());
  EXPECT_FALSE(wait_for_turn().want_key);
  ask_hub([](FakeHub& h) {
    wire::pb::Control request;
    request.mutable_key_request()->set_sensor_id(5);
    h.say(request);
    return 0;
  });
  const auto give_up = std::chrono::steady_clock::now() + 5s;
  bool wanted = false;
  while (!wanted && std::chrono::steady_clock::now() < give_up) wanted = wait_for_turn().want_key;
  EXPECT_TRUE(wanted);
}

TEST_F(PublisherTest, frames_are_wanted_until_the_hub_says_otherwise) {
  EXPECT_TRUE(publisher->frames_wanted());
  say_frames_are(false);
  publisher->wait_until_wanted(1ms, {});
  EXPECT_FALSE(publisher->frames_wanted()) << "it waits no longer than it is told to";
  ask_hub([](FakeHub& h) {
    h.hang_up();
    return 0;
  });
  publisher->wait_until_wanted(10s, {});
  EXPECT_TRUE(publisher->frames_wanted()) << "without a connection nobody has said otherwise";
}

TEST_F(PublisherTest, who_begins_to_watch_gets_a_key_frame_at_once) {
  ASSERT_TRUE(publish(wait_for_turn(), kKey).has_value());
  say_frames_are(false);
  auto waiting = std::async(std::launch::async, [&] { publisher->wait_until_wanted(60s, {}); });
  ask_hub([](FakeHub& h) {
    wire::pb::Control demand;
    demand.mutable_frame_demand()->set_wanted(true);
    h.say(demand);
    return 0;
  });
  ASSERT_EQ(waiting.wait_for(5s), std::future_status::ready);
  EXPECT_TRUE(publisher->frames_wanted());
  EXPECT_TRUE(wait_for_turn().want_key);
}

TEST_F(PublisherTest, it_is_known_from_where_the_sensor_is_looked_at_while_there_is_a_connection) {
  EXPECT_TRUE(ask_hub([](FakeHub& h) { return h.heard[0].join().sensor().takes_views(); }));
  EXPECT_EQ(publisher->views(), nullptr);
  const auto say_cones = [&](int cones) {
    ask_hub([cones](FakeHub& h) {
      wire::pb::Control control;
      control.mutable_watched_from();
      for (int i = 0; i < cones; ++i)
        control.mutable_watched_from()->add_cones()->mutable_forward()->set_z(1);
      h.say(control);
      return 0;
    });
  };
  const auto views_come = [&](int cones) {
    const auto give_up = std::chrono::steady_clock::now() + 5s;
    for (;;) {
      const auto views = publisher->views();
      if ((views ? views->cones_size() : 0) == cones) return true;
      if (std::chrono::steady_clock::now() > give_up) return false;
      std::this_thread::yield();
    }
  };
  say_cones(2);
  EXPECT_TRUE(views_come(2));
  say_cones(0);
  EXPECT_TRUE(views_come(0));
  say_cones(1);
  EXPECT_TRUE(views_come(1));
  ask_hub([](FakeHub& h) {
    h.hang_up();
    return 0;
  });
  EXPECT_TRUE(views_come(0));
}

TEST_F(PublisherTest, a_stop_ends_the_wait_for_a_viewer) {
  say_frames_are(false);
  std::stop_source stop;
  auto waiting =
      std::async(std::launch::async, [&] { publisher->wait_until_wanted(60s, stop.get_token()); });
  stop.request_stop();
  EXPECT_EQ(waiting.wait_for(5s), std::future_status::ready);
}

TEST_F(PublisherTest, the_microphone_is_heard_where_the_room_permits_it) {
  EXPECT_FALSE(publisher->may_speak()) << "a hub that says nothing of it";
  publisher->say({1, 2, 3}, false, SteadyClock().now());
  ask_hub([](FakeHub& h) {
    h.lets_speak = true;
    h.hang_up();
    return 0;
  });
  const auto give_up = std::chrono::steady_clock::now() + 5s;
  const auto goes_on = [&] { return std::chrono::steady_clock::now() < give_up; };
  while (!publisher->may_speak() && goes_on()) std::this_thread::sleep_for(5ms);
  ASSERT_TRUE(publisher->may_speak());
  (void)wait_for_turn();  // room time is known
  publisher->say({1, 2, 3}, false, SteadyClock().now());
  publisher->say({1, 2, 3}, true, SteadyClock().now());
  std::vector<wire::AudioHeader> voices;
  while (voices.size() < 2 && goes_on()) voices = ask_hub([](FakeHub& h) { return h.voices; });
  ASSERT_EQ(voices.size(), 2u);
  EXPECT_EQ(voices[0].seq, 0u);
  EXPECT_EQ(voices[0].payload_length, 3u);
  EXPECT_TRUE(voices[1].ends);
  EXPECT_GE(publisher->control_bytes(), 2 * (wire::kAudioHeaderBytes + 3));
}

TEST_F(PublisherTest, while_frames_pile_up_no_turn_is_granted) {
  (void)wait_for_turn();  // the clock is known
  // The hub's thread is blocked, so nothing is read and the socket fills.
  std::promise<void> go_on;
  boost::asio::post(network.io(), [future = go_on.get_future().share()] { future.wait(); });
  constexpr std::size_t kMaxFramesInSockets = 100;  // of 1 MiB: more than both socket buffers take
  std::size_t sent = 0;
  const auto give_up = std::chrono::steady_clock::now() + 5s;
  auto last_sent = std::chrono::steady_clock::now();
  while (sent < kMaxFramesInSockets && std::chrono::steady_clock::now() < give_up &&
         std::chrono::steady_clock::now() - last_sent < 300ms) {
    const auto turn = publisher->next_turn();
    if (!turn) {
      std::this_thread::yield();
      continue;
    }
    ASSERT_TRUE(publish(*turn, kKey, 1u << 20).has_value());
    ++sent;
    last_sent = std::chrono::steady_clock::now();
  }
  EXPECT_GT(sent, 0u);
  EXPECT_LT(sent, kMaxFramesInSockets);
  EXPECT_GT(publisher->stats().frames_skipped, 0u);
  go_on.set_value();
  EXPECT_EQ(wait_for_frames(sent).size(), sent) << "what was published arrives";
  EXPECT_LT(wait_for_turn().rate_share, 1) << "and the next ones should be smaller";
}

TEST_F(PublisherTest, frames_queued_for_a_broken_connection_are_not_sent_over_the_next) {
  std::promise<void> go_on;
  boost::asio::post(network.io(), [this, future = go_on.get_future().share()] {
    hub->on_join = [this] { hub->frames.clear(); };
    future.wait();
    hub->hang_up();
  });
  // Fills the sockets until two frames wait in the publisher.
  auto last_sent = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - last_sent < 300ms) {
    const auto turn = publisher->next_turn();
    if (!turn) continue;
    ASSERT_TRUE(publish(*turn, kKey, 1u << 20).has_value());
    last_sent = std::chrono::steady_clock::now();
  }
  go_on.set_value();
  const auto give_up = std::chrono::steady_clock::now() + 5s;
  while (ask_hub([](FakeHub& h) { return h.joins; }) < 2 &&
         std::chrono::steady_clock::now() < give_up) {
  }
  ASSERT_TRUE(publish(wait_for_turn(), kKey).has_value());
  const auto frames = wait_for_frames(1);
  ASSERT_FALSE(frames.empty());
  EXPECT_EQ(frames[0].seq, 0u);
}

TEST_F(PublisherTest, frames_above_the_limit_are_not_sent) {
  EXPECT_FALSE(publish(wait_for_turn(), kKey, wire::kMaxFrameBytes).has_value());
  EXPECT_TRUE(publish(wait_for_turn(), kKey).has_value());
}

TEST_F(PublisherTest, a_frame_that_is_left_out_has_a_number_all_the_same) {
  ASSERT_TRUE(publish(wait_for_turn(), kKey).has_value());
  ASSERT_EQ(wait_for_frames(1).size(), 1u);
  EXPECT_FALSE(publish(wait_for_turn(), kKey, wire::kMaxFrameBytes).has_value());
  const auto sent = publish(wait_for_turn(), kKey);
  ASSERT_TRUE(sent.has_value());
  EXPECT_EQ(sent->seq, 2u);
}

TEST_F(PublisherTest, a_new_connection_begins_with_a_new_key_frame) {
  const auto old_turn = wait_for_turn();
  ASSERT_TRUE(publish(old_turn, kKey).has_value());
  ask_hub([](FakeHub& h) {
    h.hang_up();
    return 0;
  });
  const auto give_up = std::chrono::steady_clock::now() + 5s;
  while (ask_hub([](FakeHub& h) { return h.joins; }) < 2 &&
         std::chrono::steady_clock::now() < give_up) {
  }
  const auto turn = wait_for_turn();
  EXPECT_NE(turn.session, old_turn.session);
  EXPECT_TRUE(turn.want_key);
  EXPECT_FALSE(publish(old_turn, kBase).has_value()) << "encoded for a connection that is gone";
  const auto sent = publish(turn, kKey);
  ASSERT_TRUE(sent.has_value());
  EXPECT_EQ(sent->seq, 0u);
}

}  // namespace
}  // namespace roomcast::client
