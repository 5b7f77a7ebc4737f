// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/sender/rate_control.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace roomcast::sensor {
namespace {

constexpr double kBytesPerSecond = 100'000;

/// An encoder whose frames are of the wanted size, give or take `error`, within what its
/// quantiser allows.
struct Encoder {
  double error = 0.3, least = 0, most = 1e9;
  std::minstd_rand random{7};

  codec::EncodedFrameInfo info = {};
  std::size_t encode(const RateControl::Plan& plan, bool key) {
    std::uniform_real_distribution<double> factor(1 - error, 1 + error);
    const double wanted = key ? plan.target.key_bytes : plan.target.bytes;
    info.key = key;
    info.quantizer = wanted < least ? 60 : wanted > most ? 4 : 30;
    return static_cast<std::size_t>(std::clamp(wanted, least, most) * factor(random));
  }
};

struct Sent {
  double at_s;
  double bytes;
  bool key;
};

class RateControlTest : public testing::Test {
 protected:
  /// A source of `fps` for so long; the first frame is a key frame.
  void run(double seconds, double fps, Encoder& encoder) {
    const int frames = static_cast<int>(seconds * fps);
    for (int i = 0; i < frames; ++i) {
      now_s += 1 / fps;
      const auto plan = control.next_frame(time(now_s), control_bytes);
      if (!plan) continue;
      const bool key = sent.empty() || plan->wants_key;
      const std::size_t bytes = encoder.encode(*plan, key);
      control.sent(bytes, encoder.info);
      sent.push_back({now_s, static_cast<double>(bytes), key});
      longest_wait_s = std::max(longest_wait_s, control.waiting_s());
    }
  }
  static HostTime time(double s) {
    return HostTime(nanoseconds(static_cast<std::int64_t>(s * 1e9)) + std::chrono::hours(1));
  }
  [[nodiscard]] double rate_since(double begin_s) const {
    double bytes = 0;
    for (const Sent& frame : sent) bytes += frame.at_s > begin_s ? frame.bytes : 0;
    return bytes / (now_s - begin_s);
  }

  RateControl control{{.bytes_per_s = kBytesPerSecond, .fps = 30}};
  std::vector<Sent> sent;
  std::uint64_t control_bytes = 0;
  double now_s = 0, longest_wait_s = 0;
};

TEST_F(RateControlTest, holds_the_rate_with_frames_of_uneven_sizes) {
  Encoder encoder;
  run(20, 30, encoder);
  EXPECT_NEAR(rate_since(5) / kBytesPerSecond, 1, 0.02);
  EXPECT_LT(longest_wait_s, 0.45);
}

TEST_F(RateControlTest, a_key_frame_takes_a_bounded_time_of_the_line) {
  Encoder encoder{.error = 0};
  run(1, 30, encoder);
  ASSERT_TRUE(sent.front().key);
  EXPECT_NEAR(sent.front().bytes / kBytesPerSecond, 0.3, 0.05);
  EXPECT_GT(sent[1].at_s - sent[0].at_s, 0.15);  // the line is busy
}

TEST_F(RateControlTest, key_frames_that_nobody_asked_for_are_few) {
  Encoder encoder;
  run(120, 15, encoder);
  double key_bytes = 0, bytes = 0;
  for (std::size_t i = 1; i < sent.size(); ++i) {
    bytes += sent[i].bytes;
    key_bytes += sent[i].key ? sent[i].bytes : 0;
  }
  EXPECT_GT(key_bytes, 0);
  EXPECT_LT(key_bytes / bytes, 0.015);
}

TEST_F(RateControlTest, sends_fewer_frames_when_the_coarsest_are_too_large) {
  Encoder encoder{.error = 0.1, .least = 7'000};  // 210 kB/s at 30 frames/s
  run(10, 30, encoder);
  EXPECT_EQ(control.divisor(), 4);
  EXPECT_NEAR(rate_since(5) / kBytesPerSecond, 1, 0.05);
  Encoder calm{.error = 0.1};
  calm.least = 0;
  run(2, 30, calm);
  EXPECT_EQ(control.divisor(), 4) << "it waits before it sends more frames again";
}

TEST_F(RateControlTest, the_frame_rate_returns_when_frames_are_fine_again) {
  Encoder encoder{.error = 0.1, .least = 7'000};
  run(10, 30, encoder);
  ASSERT_GT(control.divisor(), 1);
  Encoder calm{.error = 0.1};
  run(15, 30, calm);
  EXPECT_EQ(control.divisor(), 1);
}

TEST_F(RateControlTest, the_frame_rate_returns_at_once_on_a_faster_line) {
  Encoder encoder{.error = 0.1, .least = 7'000};
  run(10, 30, encoder);
  ASSERT_EQ(control.divisor(), 4);
  control.follow_line(4 * kBytesPerSecond, 0);
  run(0.5, 30, encoder);
  EXPECT_EQ(control.divisor(), 1);
}

TEST_F(RateControlTest, other_messages_count) {
  Encoder encoder;
  run(5, 30, encoder);
  const double before_s = now_s;
  control_bytes += 50'000;  // half a second of the line
  run(2, 30, encoder);
  const auto next = std::ranges::find_if(sent, [&](const Sent& s) { return s.at_s > before_s; });
  ASSERT_NE(next, sent.end());
  EXPECT_GT(next->at_s - before_s, 0.4);
}

TEST_F(RateControlTest, follows_a_line_that_changes) {
  Encoder encoder{.error = 0};
  double waiting = 0;
  const auto bytes_in = [&](double seconds, double bytes_per_s) {
    double bytes = 0;
    for (int i = 0; i < static_cast<int>(30 * seconds); ++i) {
      now_s += 1.0 / 30;
      waiting = std::max(0.0, waiting - bytes_per_s / 30);
      control.follow_line(bytes_per_s, waiting);
      const auto plan = control.next_frame(time(now_s), 0);
      if (!plan) continue;
      const auto size = encoder.encode(*plan, false);
      control.sent(size, encoder.info);
      waiting += static_cast<double>(size);
      bytes += static_cast<double>(size);
    }
    return bytes;
  };
  (void)bytes_in(2, kBytesPerSecond);
  EXPECT_NEAR(bytes_in(4, kBytesPerSecond) / 4, kBytesPerSecond, 0.02 * kBytesPerSecond);
  (void)bytes_in(1, kBytesPerSecond / 4);
  EXPECT_NEAR(bytes_in(4, kBytesPerSecond / 4) / 4, kBytesPerSecond / 4, 0.02 * kBytesPerSecond);
  waiting = kBytesPerSecond;
  EXPECT_EQ(bytes_in(0.3, kBytesPerSecond / 4), 0) << "the line is full: frames wait";
  waiting = 0;
  EXPECT_GT(bytes_in(0.3, kBytesPerSecond), 0) << "by what really waits, not by what was sent";
}

TEST_F(RateControlTest, learns_the_rate_at_which_frames_really_come) {
  Encoder encoder;
  run(20, 9, encoder);  // announced: 30
  EXPECT_NEAR(rate_since(8) / kBytesPerSecond, 1, 0.03);
}

TEST_F(RateControlTest, frames_that_have_no_more_to_say_leave_the_line_idle) {
  Encoder encoder{.error = 0, .most = 1'000};
  run(5, 30, encoder);
  EXPECT_NEAR(rate_since(2), 30'000, 1'500);
  EXPECT_GE(control.waiting_s(), -0.11) << "what was not used is not saved for long";
}

TEST_F(RateControlTest, a_clock_that_stands_or_goes_back_does_no_harm) {
  Encoder encoder;
  run(2, 30, encoder);
  for (int i = 0; i < 100; ++i) {
    if (const auto plan = control.next_frame(time(now_s - i), 0))
      control.sent(encoder.encode(*plan, false), encoder.info);
  }
  EXPECT_LT(control.waiting_s(), 0.5);
}

}  // namespace
}  // namespace roomcast::sensor
