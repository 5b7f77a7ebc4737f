// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/service/instant_store.h"

#include <gtest/gtest.h>

#include "roomcast/alignment/service/instant_schedule.h"

namespace roomcast::alignment {
namespace {

constexpr int kBlocks = 24;
constexpr double kInterval_s = 0.4;

/// A wall 3 m away; from the nth instant on a box stands before it, further right each time.
DepthInstant nth_instant(int nth) {
  DepthInstant instant{1000 + kInterval_s * nth, DepthImage(kBlocks, kBlocks, 3000), {}};
  for (int y = 4; y < 20; ++y) {
    for (int x = nth % 18; x < nth % 18 + 6; ++x) instant.depth_mm.at(x, y) = 2000;
  }
  return instant;
}

DepthInstant still_instant(int nth) {
  return {1000 + kInterval_s * nth, DepthImage(kBlocks, kBlocks, 3000), {}};
}

TEST(InstantStore, counts_the_moments_at_which_two_sensors_see_motion) {
  InstantStore store;
  for (int i = 0; i < 12; ++i) store.add("left", nth_instant(i), 1);
  EXPECT_EQ(store.shared_moments(), 0U) << "nobody else saw it";
  for (int i = 0; i < 12; ++i) store.add("still", still_instant(i), 1);
  EXPECT_EQ(store.shared_moments(), 0U);
  for (int i = 4; i < 12; ++i) store.add("right", nth_instant(i), 1);
  EXPECT_GE(store.shared_moments(), 6U);
  EXPECT_LE(store.shared_moments(), 8U);
}

TEST(InstantStore, keeps_the_newest_instants_and_what_was_counted) {
  InstantStore store;
  constexpr int kMany = 3 * int{InstantStore::kMaxInstants};
  for (int i = 0; i < kMany; ++i) {
    store.add("left", nth_instant(i), 1);
    store.add("right", nth_instant(i), 1);
    if (i % 20 == 19) (void)store.shared_moments();
  }
  EXPECT_EQ(store.of("left", 1).size(), InstantStore::kMaxInstants);
  EXPECT_EQ(store.of("left", 1).back().time_s, nth_instant(kMany - 1).time_s);
  EXPECT_GT(store.shared_moments(), InstantStore::kMaxInstants);
}

TEST(InstantStore, converts_readings_to_the_factor_that_is_asked_for) {
  InstantStore store;
  store.add("left", still_instant(0), 1);
  DepthInstant scaled = still_instant(1);
  scaled.depth_mm = DepthImage(kBlocks, kBlocks, 3120);
  store.add("left", scaled, 1.04);
  for (const DepthInstant& instant : store.of("left", 1.04))
    EXPECT_EQ(instant.depth_mm.at(5, 5), 3120);
  for (const DepthInstant& instant : store.of("left", 1))
    EXPECT_EQ(instant.depth_mm.at(5, 5), 3000);
}

TEST(InstantStore, forgets_a_sensor_that_was_moved) {
  InstantStore store;
  for (int i = 0; i < 12; ++i) {
    store.add("left", nth_instant(i), 1);
    store.add("right", nth_instant(i), 1);
  }
  EXPECT_GT(store.shared_moments(), 0U);
  store.forget("left");
  EXPECT_TRUE(store.of("left", 1).empty());
  EXPECT_EQ(store.shared_moments(), 0U) << "they were of its former pose";
}

TEST(InstantMessage, keeps_time_and_depth) {
  const CameraIntrinsics camera{.width = 4 * kBlocks, .height = 4 * kBlocks, .fx = 60, .fy = 60};
  const auto message = message_from_instant(nth_instant(3));
  ASSERT_TRUE(message.ok()) << message.error().message;
  const auto read = instant_from_message(*message, camera);
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_NEAR(read->time_s, nth_instant(3).time_s, 1e-6);
  EXPECT_EQ(read->depth_mm.at(5, 10), 2000);
}

TEST(InstantMessage, bytes_that_are_no_picture_are_refused) {
  const CameraIntrinsics camera{.width = 4 * kBlocks, .height = 4 * kBlocks, .fx = 60, .fy = 60};
  wire::pb::DepthInstant message;
  message.set_depth("nonsense");
  EXPECT_FALSE(instant_from_message(message, camera).ok());
  const auto other = *message_from_instant(still_instant(0));
  const CameraIntrinsics larger{.width = 320, .height = 240, .fx = 60, .fy = 60};
  EXPECT_FALSE(instant_from_message(other, larger).ok());
}

TEST(InstantSchedule, moments_follow_one_another) {
  EXPECT_EQ(moment_of(0.39), 0);
  EXPECT_EQ(moment_of(0.41), 1);
  EXPECT_EQ(moment_of(1000.01) - moment_of(999.99), 1);
}

}  // namespace
}  // namespace roomcast::alignment
