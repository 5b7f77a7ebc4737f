// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/interference_meter.h"

#include <gtest/gtest.h>

#include "roomcast/sensor/disturbed_wall_fixture.h"

namespace roomcast::sensor {
namespace {

InterferenceFigures figures_after(const DisturbedWall& wall, unsigned frames) {
  InterferenceMeter meter(kWallFps);
  for (unsigned i = 0; i < frames; ++i) meter.add(wall.frame(i));
  return meter.figures();
}

TEST(InterferenceMeterTest, nothing_is_known_at_first) {
  EXPECT_FALSE(figures_after({}, 5).is_known);
}

TEST(InterferenceMeterTest, a_sensor_that_nothing_disturbs_has_no_interference) {
  const auto figures = figures_after({}, 90);
  EXPECT_TRUE(figures.is_known);
  EXPECT_LT(figures.flickering, 0.0005);
  EXPECT_LT(figures.noise_ratio, 1.15);
}

TEST(InterferenceMeterTest, patches_that_come_and_go_are_counted) {
  const double few = figures_after({.lost = 0.03}, 120).flickering;
  const double many = figures_after({.lost = 0.12}, 120).flickering;
  EXPECT_GT(few, 0.012);  // the corners of patches of 5 x 5 pixels do not count
  EXPECT_LT(few, 0.03);
  EXPECT_GT(many, 2.5 * few);
}

TEST(InterferenceMeterTest, readings_that_are_lost_one_by_one_are_weak_and_no_interference) {
  for (const double weak : {0.02, 0.1, 0.3, 0.5})
    EXPECT_LT(figures_after({.weak = weak}, 120).flickering, 0.002) << weak;
}

TEST(InterferenceMeterTest, a_burst_of_noise_is_measured_and_does_not_become_the_usual_noise) {
  InterferenceMeter meter(kWallFps);
  const DisturbedWall quiet, burst{.noise_mm = 9};
  for (unsigned i = 0; i < 90; ++i) meter.add(quiet.frame(i));
  for (unsigned i = 90; i < 120; ++i) meter.add(burst.frame(i));
  EXPECT_NEAR(meter.noise_ratio_now(), 3, 0.5F);
  for (unsigned i = 120; i < 130; ++i) meter.add(quiet.frame(i));
  EXPECT_LT(meter.noise_ratio_now(), 1.2F);
  EXPECT_GT(meter.figures().noise_ratio, 2.3);
}

TEST(InterferenceMeterTest, outlines_that_flicker_are_no_interference) {
  InterferenceMeter meter(kWallFps);
  for (unsigned i = 0; i < 90; ++i) {
    DepthImage frame = DisturbedWall().frame(i);
    for (int y = 50; y < 90; ++y) frame.at(i % 2 == 0 ? 59 : 90, y) = 0;
    meter.add(frame);
  }
  EXPECT_LT(meter.figures().flickering, 0.0005);
}

TEST(InterferenceMeterTest, a_sensor_that_is_carried_is_not_disturbed) {
  InterferenceMeter meter(kWallFps);
  for (unsigned i = 0; i < 90; ++i) {
    DepthImage frame = DisturbedWall().frame(i);
    for (std::size_t at = 0; at < frame.view().pixel_count(); ++at)
      frame.data()[at] = static_cast<std::uint16_t>(frame.data()[at] + 40 * i);
    meter.add(frame);
  }
  EXPECT_LT(meter.figures().flickering, 0.001);
  EXPECT_LT(meter.figures().noise_ratio, 1.5);
}

TEST(InterferenceMeterTest, another_size_begins_anew) {
  InterferenceMeter meter(kWallFps);
  for (unsigned i = 0; i < 60; ++i) meter.add(DisturbedWall{.lost = 0.1}.frame(i));
  meter.add(DisturbedWall{.width = 80, .height = 60}.frame(60));
  EXPECT_FALSE(meter.figures().is_known);
}

}  // namespace
}  // namespace roomcast::sensor
