// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/timer.h"

#include <optional>
#include <thread>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/post.hpp>
#include <gtest/gtest.h>

namespace roomcast::net {
namespace {

using namespace std::chrono_literals;

/// Two timers that are due at the same instant: the handlers of both are queued before either runs.
/// The one that was set first is called first.
class TwoDueTimers : public testing::Test {
 protected:
  boost::asio::io_context io;
  Timer first{io};
  std::optional<Timer> second{io};
  int calls = 0;
};

TEST_F(TwoDueTimers, cancel_reaches_an_action_that_is_due_already) {
  first.once(-2ms, [this] { second->cancel(); });
  second->once(-1ms, [this] { ++calls; });
  io.run();
  EXPECT_EQ(calls, 0);
}

TEST_F(TwoDueTimers, a_repeated_action_that_is_due_already_does_not_go_on) {
  first.once(-2ms, [this] { second->stop(); });
  second->repeat(0ms, [this] {
    if (++calls == 10) second->stop();  // so that a failure ends, too
  });
  io.run();
  EXPECT_EQ(calls, 0);
}

TEST_F(TwoDueTimers, a_timer_that_is_gone_calls_nothing) {
  first.once(-2ms, [this] { second.reset(); });
  second->once(-1ms, [this] { ++calls; });
  io.run();
  EXPECT_EQ(calls, 0);
}

TEST_F(TwoDueTimers, a_new_order_replaces_one_that_is_due_already) {
  first.once(-2ms, [this] { second->once(0ms, [this] { calls += 10; }); });
  second->once(-1ms, [this] { ++calls; });
  io.run();
  EXPECT_EQ(calls, 10);
}

TEST(Timer, repeats_until_its_action_cancels_it) {
  boost::asio::io_context io;
  Timer timer(io);
  int calls = 0;
  timer.repeat(1us, [&] {
    if (++calls == 5) timer.cancel();
  });
  io.run();
  EXPECT_EQ(calls, 5);
}

TEST(Timer, may_be_destroyed_by_its_action) {
  boost::asio::io_context io;
  std::optional<Timer> timer(io);
  int calls = 0;
  timer->repeat(1us, [&] {
    ++calls;
    timer.reset();
  });
  io.run();
  EXPECT_EQ(calls, 1);
}

TEST(Timer, can_be_set_after_cancel_but_not_after_stop) {
  boost::asio::io_context io;
  Timer timer(io);
  int calls = 0;
  timer.cancel();
  timer.once(0ms, [&] { ++calls; });
  io.run();
  EXPECT_EQ(calls, 1);
  timer.stop();
  timer.once(0ms, [&] { ++calls; });
  timer.repeat(0ms, [&] { ++calls; });
  io.restart();
  io.run();
  EXPECT_EQ(calls, 1);
}

/// A loop whose repeated timer is stopped by another thread's last task ends: ten thousand times.
TEST(Timer, ten_thousand_starts_and_stops_end) {
  for (int round = 0; round < 10'000; ++round) {
    boost::asio::io_context io{1};
    std::optional guard(boost::asio::make_work_guard(io));
    Timer timer(io);
    timer.repeat(0us, [] {});
    std::jthread loop([&] { io.run(); });
    boost::asio::post(io, [&] {
      timer.stop();
      guard.reset();
    });
  }
}

}  // namespace
}  // namespace roomcast::net
