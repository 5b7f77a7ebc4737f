// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/camera/device_clock.h"

#include <random>

#include <gtest/gtest.h>

namespace roomcast::source {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr nanoseconds kPeriod{33'333'333};
constexpr nanoseconds kOffset{seconds(1000)};

HostTime host(nanoseconds since_start) {
  return HostTime(kOffset + since_start);
}

TEST(DeviceClock, jitter_of_the_arrival_does_not_show_in_the_capture_times) {
  DeviceClock clock;
  std::minstd_rand random(1);
  std::uniform_int_distribution<std::int64_t> jitter_ns(0, 8'000'000);
  for (int i = 0; i < 600; ++i) {
    const nanoseconds taken = i * kPeriod;
    const HostTime found = clock.capture_time(taken, host(taken + nanoseconds(jitter_ns(random))));
    if (i > 60) {
      EXPECT_LT(std::chrono::abs(found - host(taken)), milliseconds(1));
    }
  }
}

TEST(DeviceClock, a_device_clock_that_runs_fast_is_followed) {
  DeviceClock clock;
  constexpr double kRate = 1 + 100e-6;
  HostTime found;
  nanoseconds taken{};
  for (int i = 0; i < 3000; ++i) {
    taken = i * kPeriod;
    const nanoseconds device(static_cast<std::int64_t>(double(taken.count()) * kRate));
    found = clock.capture_time(device, host(taken));
    EXPECT_LE(found, host(taken));
  }
  EXPECT_LT(host(taken) - found, milliseconds(2));
}

TEST(DeviceClock, a_device_that_starts_anew_is_believed_at_once) {
  DeviceClock clock;
  (void)clock.capture_time(seconds(500), host(seconds(1)));
  EXPECT_EQ(clock.capture_time(seconds(0), host(seconds(2))), host(seconds(2)));
  EXPECT_EQ(clock.capture_time(seconds(900), host(seconds(3))), host(seconds(3)));
}

TEST(TickCounter, wraps_around_without_a_leap) {
  TickCounter counter(32, 60e6);
  const nanoseconds before = counter.time(0xFFFF'FFF0);
  const nanoseconds after = counter.time(0x0000'0050);
  EXPECT_EQ(after - before, nanoseconds(1600));  // 96 ticks of 60 MHz
}

TEST(TickCounter, a_small_step_back_is_no_wrap_around) {
  TickCounter counter(32, 1e9);
  (void)counter.time(1000);
  EXPECT_EQ(counter.time(900), nanoseconds(900));
  EXPECT_EQ(counter.time(1100), nanoseconds(1100));
}

}  // namespace
}  // namespace roomcast::source
