// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/instant_reporter.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/alignment/service/instant_store.h"

namespace roomcast::sensor {
namespace {

using namespace std::chrono_literals;

constexpr int kWidth = 128, kHeight = 96;

DepthImage wall() {
  return DepthImage(kWidth, kHeight, 3000);
}

/// The wall with a box before it.
DepthImage box_before_wall() {
  DepthImage picture = wall();
  for (int y = 16; y < 80; ++y) {
    for (int x = 32; x < 96; ++x) picture.at(x, y) = 2000;
  }
  return picture;
}

/// What is reported in ten seconds at 30 frames a second.
std::vector<wire::pb::DepthInstant> reported(InstantReporter& reporter, const DepthImage& picture) {
  std::vector<wire::pb::DepthInstant> messages;
  for (RoomTime time(1000s); time < RoomTime(1010s); time += 33ms) {
    if (auto message = reporter.add(picture, time)) messages.push_back(*std::move(message));
  }
  return messages;
}

TEST(InstantReporter, while_something_moves_it_reports_each_moment) {
  InstantReporter reporter;
  reporter.stand(wall());
  const auto messages = reported(reporter, box_before_wall());
  ASSERT_EQ(messages.size(), 25U);
  const CameraIntrinsics camera{.width = kWidth, .height = kHeight, .fx = 120, .fy = 120};
  const auto instant = alignment::instant_from_message(messages[0], camera);
  ASSERT_TRUE(instant.ok()) << instant.error().message;
  EXPECT_NEAR(instant->time_s, 1000, 0.001);
  EXPECT_EQ(instant->depth_mm.at(16, 12), 2000);
  EXPECT_EQ(instant->depth_mm.at(1, 1), 3000);
}

TEST(InstantReporter, while_nothing_moves_it_reports_few) {
  InstantReporter reporter;
  reporter.stand(wall());
  const auto messages = reported(reporter, wall());
  EXPECT_GE(messages.size(), 3U);
  EXPECT_LE(messages.size(), 4U);
}

TEST(InstantReporter, sensors_report_the_same_moments) {
  InstantReporter early, late;
  early.stand(wall());
  late.stand(wall());
  std::vector<std::uint64_t> times_ns[2];
  for (RoomTime time(1000s); time < RoomTime(1009s + 900ms); time += 33ms) {
    if (const auto message = early.add(box_before_wall(), time))
      times_ns[0].push_back(message->room_ns());
    if (const auto message = late.add(box_before_wall(), time + 10ms))
      times_ns[1].push_back(message->room_ns());
  }
  ASSERT_EQ(times_ns[0].size(), times_ns[1].size());
  for (std::size_t i = 0; i < times_ns[0].size(); ++i) {
    const double apart_s = 1e-9 * (double(times_ns[1][i]) - double(times_ns[0][i]));
    EXPECT_LT(std::abs(apart_s), 0.0335) << "more than one frame";
  }
}

TEST(InstantReporter, without_a_known_background_it_reports_nothing) {
  InstantReporter reporter;
  EXPECT_TRUE(reported(reporter, box_before_wall()).empty());
  reporter.stand(wall());
  reporter.stand({});  // the sensor was moved
  EXPECT_TRUE(reported(reporter, box_before_wall()).empty());
}

TEST(InstantReporter, pictures_of_another_size_are_not_reported) {
  InstantReporter reporter;
  reporter.stand(wall());
  EXPECT_TRUE(reported(reporter, DepthImage(kWidth / 2, kHeight, 2000)).empty());
}

}  // namespace
}  // namespace roomcast::sensor
