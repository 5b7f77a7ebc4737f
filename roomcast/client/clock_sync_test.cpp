// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/clock_sync.h"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/client/clocks_fixture.h"
#include "roomcast/client/ping_schedule.h"

namespace roomcast::client {
namespace {

using namespace std::chrono_literals;

HostTime host(nanoseconds t) {
  return HostTime(t);
}
RoomTime room(nanoseconds t) {
  return RoomTime(t);
}

TEST(ClockSync, knows_nothing_before_the_first_exchange) {
  EXPECT_FALSE(ClockSync().estimate().has_value());
}

TEST(ClockSync, an_even_way_there_and_back_gives_the_offset) {
  ClockSync sync;
  sync.add(host(100ms), room(5s + 105ms), host(110ms));
  const auto estimate = sync.estimate();
  ASSERT_TRUE(estimate);
  EXPECT_EQ(estimate->room_minus_host, 5s);
  EXPECT_EQ(estimate->error, 5ms);
  EXPECT_EQ(estimate->room_time(host(1s)), room(6s));
}

TEST(ClockSync, the_shortest_round_trip_is_believed) {
  ClockSync sync;
  sync.add(host(0ms), room(1s + 90ms), host(100ms));  // 40 ms off
  sync.add(host(200ms), room(1s + 201ms), host(202ms));
  sync.add(host(300ms), room(1s + 310ms), host(400ms));
  EXPECT_EQ(sync.estimate()->room_minus_host, 1s);
  EXPECT_EQ(sync.estimate()->error, 1ms + 19'800ns) << "and 100 ppm of the 198 ms since";
}

TEST(ClockSync, an_old_exchange_is_believed_less_and_less) {
  ClockSync sync;
  sync.add(host(0ms), room(1s), host(0ms));
  sync.add(host(9s), room(1s + 9s + 7ms), host(9s + 10ms));
  EXPECT_EQ(sync.estimate()->room_minus_host, 1s);
  EXPECT_EQ(sync.estimate()->error, 901us) << "100 ppm of the time since";
  sync.add(host(99s), room(1s + 99s + 7ms), host(99s + 10ms));
  EXPECT_EQ(sync.estimate()->room_minus_host, 1s + 2ms);
  EXPECT_EQ(sync.estimate()->error, 5ms);
}

TEST(ClockSync, an_answer_before_its_question_is_ignored) {
  ClockSync sync;
  sync.add(host(10ms), room(1s), host(5ms));
  EXPECT_FALSE(sync.estimate().has_value());
}

TEST(ClockSync, times_that_no_clock_shows_are_ignored) {
  ClockSync sync;
  sync.add(host(nanoseconds::min()), room(1s), host(5ms));
  sync.add(host(1ms), room(nanoseconds::min()), host(5ms));
  sync.add(host(1ms), room(nanoseconds::max()), host(5ms));
  EXPECT_FALSE(sync.estimate().has_value());
}

TEST(ClockSync, the_error_bound_holds_on_a_network_that_is_slow_one_way) {
  std::mt19937 random(1);
  std::exponential_distribution<double> queueing(1 / 20e6);  // 20 ms on average, each way
  ClockSync sync;
  const nanoseconds truth = 1234ms;
  for (int i = 0; i < 100; ++i) {
    const nanoseconds sent = i * 500ms;
    const nanoseconds there(static_cast<std::int64_t>(2e6 + queueing(random)));
    const nanoseconds back(static_cast<std::int64_t>(2e6 + queueing(random) / 4));
    sync.add(host(sent), room(sent + there + truth), host(sent + there + back));
    const auto estimate = sync.estimate();
    EXPECT_LE(std::chrono::abs(estimate->room_minus_host - truth), estimate->error);
  }
  EXPECT_LT(sync.estimate()->error, 10ms);
}

/// Pings for `seconds` at a sensor's rate and returns the time error at every frame.
std::vector<double> errors_s(ClockSync& sync, SimulatedClocks& clocks, double from_s,
                             double seconds) {
  PingSchedule pace(PingSchedule::kOfSensor, 3);
  std::vector<double> errors;
  for (double now_s = from_s; now_s < from_s + seconds;) {
    const double answered_s = clocks.ping(sync, now_s);
    now_s += std::chrono::duration<double>(pace.next()).count();
    const double shown_s = std::max(now_s, answered_s);
    errors.push_back(clocks.error_s(*sync.estimate(), shown_s));
  }
  return errors;
}

double percentile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

constexpr double kWanted_s = 50e-6;  // p95, with frames flowing

TEST(ClockSync, is_right_to_50_us_behind_frames_with_drift_and_outliers) {
  for (const double drift : {20e-6, -20e-6, 50e-6}) {
    SimulatedClocks clocks({}, 5.5, drift);
    ClockSync sync;
    errors_s(sync, clocks, 0, 5);
    EXPECT_LT(percentile(errors_s(sync, clocks, 5, 120), 0.95), kWanted_s) << "from the start";
    EXPECT_LT(percentile(errors_s(sync, clocks, 125, 120), 0.95), kWanted_s);
    EXPECT_NEAR(sync.estimate()->drift, drift, 1e-6);
  }
}

TEST(ClockSync, error_bound_holds_behind_frames_and_is_hardly_more_than_half_the_way) {
  SimulatedClocks clocks({}, -3.2, 20e-6);
  ClockSync sync;
  PingSchedule pace(PingSchedule::kOfSensor, 3);
  for (double now_s = 0; now_s < 100; now_s += std::chrono::duration<double>(pace.next()).count()) {
    clocks.ping(sync, now_s);
    const ClockEstimate estimate = *sync.estimate();
    const double error_s = std::chrono::duration<double>(estimate.error).count();
    const double at_s = std::chrono::duration<double>(estimate.at.time_since_epoch()).count();
    ASSERT_LE(clocks.error_s(estimate, at_s), error_s);
    if (now_s > 5) {
      ASSERT_LT(error_s, 0.0256);
    }
  }
}

TEST(ClockSync, pings_in_step_with_the_frames_would_all_be_wrong) {
  SimulatedClocks clocks({.outlier_share = 0}, 0, 0);
  ClockSync sync;
  for (int i = 0; i < 300; ++i) clocks.ping(sync, i * 3 / 30.0 + 0.001);
  EXPECT_GT(clocks.error_s(*sync.estimate(), 30), 0.003) << "why PingSchedule is random";
}

TEST(ClockSync, a_clock_that_was_set_is_noticed_within_a_second) {
  for (const double step_s : {3600.0, -3600.0, 0.01, -0.01}) {
    SimulatedClocks clocks({}, 0, 20e-6);
    ClockSync sync;
    errors_s(sync, clocks, 0, 90);
    clocks.step(step_s);
    errors_s(sync, clocks, 90, 1);
    EXPECT_LT(percentile(errors_s(sync, clocks, 91, 20), 0.95), 0.0005) << step_s;
    errors_s(sync, clocks, 111, 60);
    EXPECT_NEAR(sync.estimate()->drift, 20e-6, 1e-6) << "not bent by the step";
  }
}

TEST(ClockSync, one_lying_answer_changes_nothing) {
  SimulatedClocks clocks({}, 0, 0);
  ClockSync sync;
  errors_s(sync, clocks, 0, 10);
  sync.add(host(10s), room(3600s), host(10s + 50ms));
  EXPECT_LT(clocks.error_s(*sync.estimate(), 10.05), kWanted_s);
}

TEST(ClockSync, a_way_that_grows_longer_is_no_step) {
  SimulatedClocks near({}, 1, 20e-6), far({.one_way_s = 0.08}, 1, 20e-6);
  ClockSync sync;
  errors_s(sync, near, 0, 70);
  EXPECT_LT(percentile(errors_s(sync, far, 70, 5), 0.95), 0.0002);
  EXPECT_NEAR(sync.estimate()->drift, 20e-6, 1e-6) << "it did not start anew";
}

TEST(ClockSync, a_way_that_is_always_full_does_not_look_like_a_step) {
  SimulatedClocks clocks({.frame_on_the_way_s = 0.3}, 1, 0);  // all pings wait, for varying times
  ClockSync sync;
  errors_s(sync, clocks, 0, 60);
  const auto estimate = sync.estimate();
  EXPECT_LE(clocks.error_s(*estimate, 60), std::chrono::duration<double>(estimate->error).count());
}

}  // namespace
}  // namespace roomcast::client
