// SPDX-License-Identifier: Apache-2.0
// Senders that share one line, each with its own BandwidthEstimator.
#include <algorithm>
#include <chrono>
#include <deque>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/client/uplink/bandwidth_estimator.h"

namespace roomcast::client {
namespace {

using namespace std::chrono_literals;

constexpr double kMbitPerS = 1e6 / 8;  // bytes/s

/// A line with a queue of 100 ms, and senders of 15 frames/s that use their estimates. What does
/// not fit the queue is lost and sent again.
class SharedLine {
 public:
  explicit SharedLine(std::size_t senders) : senders_(senders) {
    for (std::size_t i = 0; i < senders; ++i)
      senders_[i].next_frame_s = kFrame_s * static_cast<double>(i) / static_cast<double>(senders);
  }

  double capacity = 8 * kMbitPerS;

  void delay(std::size_t sender, double seconds) { senders_[sender].next_frame_s += seconds; }

  void run(double seconds) {
    carried_ = queue_s_ = 0;
    const auto steps = static_cast<int>(seconds / kStep_s);
    for (int i = 0; i < steps; ++i) step();
    carried_ /= seconds;
    queue_s_ /= steps;
  }

  /// Of the last run: the share of the line that was used, and the mean time in its queue.
  [[nodiscard]] double used() const { return carried_ / capacity; }
  [[nodiscard]] double queue_s() const { return queue_s_; }
  [[nodiscard]] double rate(std::size_t sender) const {
    return senders_[sender].estimator.bytes_per_s();
  }

 private:
  static constexpr double kStep_s = 0.002, kFrame_s = 1.0 / 15, kRoundTrip_s = 0.03;
  static constexpr double kMaxQueue_s = 0.1, kPaceMargin = 1.5;  // the latter as UplinkMonitor's
  static constexpr int kStepsPerReading = 10;

  struct Sender {
    BandwidthEstimator estimator;
    double waiting = 0, delivered = 0, lost = 0, next_frame_s = 0;
    std::deque<std::pair<double, double>> acknowledged;  // when, bytes
  };

  void step() {
    time_s_ += kStep_s;
    ++steps_;
    for (std::size_t i = 0; i < senders_.size(); ++i) send(i);
    serve();
    for (std::size_t i = 0; i < senders_.size(); ++i) read(senders_[i], static_cast<int>(3 * i));
    queue_s_ += queued_ / capacity;
  }

  void send(std::size_t number) {
    Sender& sender = senders_[number];
    const double rate = sender.estimator.bytes_per_s();
    if (time_s_ >= sender.next_frame_s) {
      sender.next_frame_s += kFrame_s;
      if (sender.waiting < rate * kFrame_s) sender.waiting += rate * kFrame_s;
    }
    const double sent = std::min(sender.estimator.pace(kPaceMargin) * kStep_s, sender.waiting);
    const double taken = std::clamp(capacity * kMaxQueue_s - queued_, 0.0, sent);
    sender.waiting -= taken;
    sender.lost += sent - taken;
    queue_.push_back({number, taken});
    queued_ += taken;
  }

  void serve() {
    for (double left = capacity * kStep_s; left > 0 && !queue_.empty();) {
      auto& [number, bytes] = queue_.front();
      const double served = std::min(left, bytes);
      senders_[number].acknowledged.emplace_back(time_s_ + kRoundTrip_s, served);
      left -= served;
      bytes -= served;
      queued_ -= served;
      carried_ += served;
      if (bytes <= 0) queue_.pop_front();
    }
  }

  void read(Sender& sender, int offset) {
    while (!sender.acknowledged.empty() && sender.acknowledged.front().first <= time_s_) {
      sender.delivered += sender.acknowledged.front().second;
      sender.acknowledged.pop_front();
    }
    if ((steps_ + offset) % kStepsPerReading != 0) return;
    const std::chrono::duration<double> now(time_s_), round_trip(kRoundTrip_s + queued_ / capacity);
    sender.estimator.add({.time = HostTime(1h) + std::chrono::duration_cast<nanoseconds>(now),
                          .delivered_bytes = static_cast<std::uint64_t>(sender.delivered),
                          .is_waiting = sender.waiting > 1,
                          .round_trip = std::chrono::duration_cast<nanoseconds>(round_trip),
                          .resent_packets = static_cast<std::uint64_t>(sender.lost / 1448)});
  }

  std::vector<Sender> senders_;
  std::deque<std::pair<std::size_t, double>> queue_;  // whose, bytes
  double queued_ = 0, time_s_ = 0, carried_ = 0, queue_s_ = 0;
  int steps_ = 0;
};

TEST(SharedLine, senders_use_it_without_a_queue_that_stands) {
  for (const double mbit : {1.0, 2.0, 8.0}) {
    SharedLine line(3);
    line.capacity = mbit * kMbitPerS;
    line.run(10);
    line.run(20);
    EXPECT_GT(line.used(), 0.85) << mbit;
    EXPECT_LT(line.queue_s(), mbit < 4 ? 0.06 : 0.035) << mbit;
  }
}

TEST(SharedLine, its_queue_leaves_after_it_became_slower) {
  SharedLine line(3);
  line.run(10);
  line.capacity = 2 * kMbitPerS;
  line.run(2);
  line.run(10);
  EXPECT_GT(line.used(), 0.85);
  EXPECT_LT(line.queue_s(), 0.06);
}

TEST(SharedLine, one_who_comes_later_gets_a_share) {
  SharedLine line(2);
  line.delay(1, 10);
  line.run(10);
  EXPECT_GT(line.rate(0), 5 * line.rate(1));
  line.run(60);
  EXPECT_LT(line.rate(0), 2 * line.rate(1));
  EXPECT_LT(line.rate(1), 2 * line.rate(0));
}

}  // namespace
}  // namespace roomcast::client
