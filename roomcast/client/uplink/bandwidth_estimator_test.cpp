// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/uplink/bandwidth_estimator.h"

#include <algorithm>
#include <chrono>
#include <deque>

#include <gtest/gtest.h>

namespace roomcast::client {
namespace {

using namespace std::chrono_literals;

constexpr double kMbit = 1e6 / 8;  // bytes/s
constexpr double kPaceMargin = 1.15;

/// A sender of 15 frames/s that uses the estimate, on a line: what waits leaves at the pace,
/// through a queue of the line's own, and is acknowledged a round trip later.
class BandwidthEstimatorTest : public testing::Test {
 protected:
  static constexpr double kStep_s = 0.002;
  static constexpr int kStepsPerReading = 10, kStepsPerFrame = 33;

  void run(double seconds) {
    const auto steps = static_cast<int>(seconds / kStep_s);
    for (int i = 0; i < steps; ++i) step();
  }

  void step() {
    ++steps_;
    const double rate = estimator.bytes_per_s();
    if (steps_ % kStepsPerFrame == 0 && waiting_ < rate / 15)
      waiting_ += std::min(rate, wanted) * kStepsPerFrame * kStep_s;
    const double window = 2 * std::max(capacity, kMbit / 4) * (round_trip_s + 0.02);
    const double sent =
        std::clamp(std::min(kPaceMargin * rate * kStep_s, window - in_flight()), 0.0, waiting_);
    waiting_ -= sent;
    queued_ += sent;
    lose(queued_ - capacity * longest_queue_s);
    const double served = std::min(queued_, capacity * kStep_s);
    const double carried = (is_losing ? 0.2 : 1.0) * served;
    queued_ -= served;
    queued_ += served - carried;
    lose(served - carried);
    sent_ += sent;
    travelling_.push_back({steps_ + static_cast<int>(round_trip_s / kStep_s), carried});
    while (!travelling_.empty() && travelling_.front().arrives_at <= steps_) {
      delivered_ += travelling_.front().bytes;
      travelling_.pop_front();
    }
    if (steps_ % kStepsPerReading == 0) read();
    highest = std::max(highest, estimator.bytes_per_s());
    lowest = std::min(lowest, estimator.bytes_per_s());
  }

  /// The line loses so many bytes of its queue; the sender sends them again.
  void lose(double bytes) {
    if (bytes <= 0) return;
    queued_ -= bytes;
    sent_ -= bytes;
    waiting_ += bytes;
    lost_ += bytes;
  }

  [[nodiscard]] double in_flight() const { return sent_ - delivered_; }
  [[nodiscard]] double mbit() const { return estimator.bytes_per_s() / kMbit; }
  void forget_extremes() { highest = lowest = estimator.bytes_per_s(); }

  void read() {
    const double queue_s = capacity > 0 ? queued_ / capacity : 0;
    estimator.add(
        {.time = HostTime(1h) + nanoseconds(static_cast<std::int64_t>(steps_ * kStep_s * 1e9)),
         .delivered_bytes = static_cast<std::uint64_t>(delivered_),
         .is_waiting = waiting_ > 1,
         .round_trip = nanoseconds(static_cast<std::int64_t>((round_trip_s + queue_s) * 1e9)),
         .bbr_bytes_per_s = 0,
         .is_probing_round_trip = is_probing,
         .resent_packets = static_cast<std::uint64_t>(lost_ / 1448)});
  }

  BandwidthEstimator estimator;
  double capacity = 8 * kMbit;  // of the line
  double round_trip_s = 0.03;
  double wanted = 1e9;  // rate that the sender's pictures take at their best
  bool is_probing = false;
  double longest_queue_s = 1;
  bool is_losing = false;  // the line loses most packets
  double highest = 0, lowest = 1e12;

 private:
  struct Travelling {
    int arrives_at;
    double bytes;
  };
  int steps_ = 0;
  double waiting_ = 0, queued_ = 0, sent_ = 0, delivered_ = 0, lost_ = 0;
  std::deque<Travelling> travelling_;
};

TEST_F(BandwidthEstimatorTest, finds_the_rate_of_a_line_in_two_seconds) {
  run(2);
  EXPECT_GT(mbit(), 0.8 * 8);
  run(2);
  forget_extremes();
  run(20);
  EXPECT_LT(highest, 1.1 * capacity);
  EXPECT_GT(lowest, 0.8 * capacity) << "it does not oscillate";
}

TEST_F(BandwidthEstimatorTest, finds_slow_and_fast_lines_too) {
  for (const double line : {0.3, 1.0, 3.0, 30.0}) {
    estimator = {};
    capacity = line * kMbit;
    run(8);
    EXPECT_LT(mbit(), 1.1 * line);
    EXPECT_GT(mbit(), 0.75 * line);
  }
}

TEST_F(BandwidthEstimatorTest, follows_a_line_that_becomes_slower_and_faster) {
  run(5);
  capacity = 2 * kMbit;
  run(0.8);
  EXPECT_LT(mbit(), 2.05);
  EXPECT_GT(mbit(), 1.0);
  run(5);
  EXPECT_GT(mbit(), 1.6);
  capacity = 8 * kMbit;
  run(3);
  EXPECT_GT(mbit(), 0.8 * 8);
}

TEST_F(BandwidthEstimatorTest, a_long_way_changes_nothing) {
  round_trip_s = 0.2;
  run(6);
  forget_extremes();
  run(20);
  EXPECT_LT(highest, 1.25 * capacity) << "it learns late what is too much";
  EXPECT_GT(lowest, 0.6 * capacity);
}

TEST_F(BandwidthEstimatorTest, an_interruption_is_no_slower_line) {
  run(5);
  for (const double seconds : {0.3, 1.0}) {
    const double before = estimator.bytes_per_s();
    capacity = 0;
    run(seconds);
    EXPECT_NEAR(estimator.bytes_per_s(), before, 0.03 * before) << "nothing can be learnt";
    capacity = 8 * kMbit;
    run(1);
    EXPECT_GT(mbit(), 0.7 * 8);
  }
}

TEST_F(BandwidthEstimatorTest, bursts_of_losses_are_no_slower_line) {
  run(10);
  forget_extremes();
  for (int burst = 0; burst < 20; ++burst) {
    is_losing = true;
    run(0.1);
    is_losing = false;
    run(0.3);
  }
  EXPECT_GT(lowest, 0.6 * capacity) << "cuts add up";
}

TEST_F(BandwidthEstimatorTest, a_slower_line_whose_queue_overflows_is_one) {
  longest_queue_s = 0.05;
  run(5);
  capacity = 2 * kMbit;
  run(1.5);
  EXPECT_LT(mbit(), 2.3);
  EXPECT_GT(mbit(), 1.0);
}

TEST_F(BandwidthEstimatorTest, holds_while_the_kernel_probes_the_round_trip) {
  run(5);
  const double before = estimator.bytes_per_s();
  is_probing = true;
  capacity = 0.5 * kMbit;
  run(0.2);
  EXPECT_EQ(estimator.bytes_per_s(), before);
}

TEST_F(BandwidthEstimatorTest, a_rate_that_is_not_used_is_not_raised_and_ages) {
  run(3);
  wanted = 1 * kMbit;
  forget_extremes();
  run(4);
  EXPECT_LE(highest, 1.1 * 8 * kMbit);
  EXPECT_LT(mbit(), 6);
  run(60);
  EXPECT_GT(mbit(), 1) << "but not below what is used";
}

TEST_F(BandwidthEstimatorTest, readings_that_stand_still_or_go_back_do_no_harm) {
  run(3);
  const double before = estimator.bytes_per_s();
  for (int i = 0; i < 100; ++i) estimator.add({.time = HostTime(1min), .is_waiting = true});
  EXPECT_LE(estimator.bytes_per_s(), before * 1.01);
  EXPECT_GE(estimator.bytes_per_s(), BandwidthEstimator::kMin);
}

}  // namespace
}  // namespace roomcast::client
