// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/interference_filter.h"

#include <cmath>

#include <gtest/gtest.h>

#include "roomcast/sensor/disturbed_wall_fixture.h"

namespace roomcast::sensor {
namespace {

/// A filter that has seen the wall for some seconds.
InterferenceFilter filter_of(const DisturbedWall& wall, unsigned frames = 120) {
  InterferenceFilter filter(kWallFps);
  for (unsigned i = 0; i < frames; ++i) {
    DepthImage frame = wall.frame(i);
    filter.filter(frame);
  }
  return filter;
}

int missing(const DepthImage& frame) {
  int count = 0;
  for (std::size_t i = 0; i < frame.view().pixel_count(); ++i) count += frame.data()[i] == 0;
  return count;
}

double rms_mm(const DepthImage& frame, const DisturbedWall& wall) {
  double squares = 0, count = 0;
  for (int y = 1; y < frame.height() - 1; ++y) {
    for (int x = 1; x < frame.width() - 1; ++x) {
      if (frame.at(x, y) == 0) continue;
      squares += std::pow(frame.at(x, y) + 0.5 - wall.true_mm(x, y), 2);
      ++count;
    }
  }
  return std::sqrt(squares / count);
}

TEST(InterferenceFilterTest, undisturbed_frames_pass_unchanged) {
  const DisturbedWall wall;
  InterferenceFilter filter(kWallFps);
  for (unsigned i = 0; i < 120; ++i) {
    DepthImage frame = wall.frame(i);
    filter.filter(frame);
    ASSERT_EQ(frame, wall.frame(i));
  }
  EXPECT_FALSE(filter.is_active());
}

TEST(InterferenceFilterTest, missing_readings_of_a_still_surface_are_held) {
  const DisturbedWall wall{.lost = 0.1};
  InterferenceFilter filter = filter_of(wall);
  DepthImage frame = wall.frame(500);
  const int before = missing(frame);
  filter.filter(frame);
  EXPECT_LT(missing(frame), before / 5);
  EXPECT_LT(rms_mm(frame, wall), 4);
}

TEST(InterferenceFilterTest, a_reading_that_is_off_for_one_frame_is_replaced) {
  const DisturbedWall wall{.lost = 0.02, .off = 0.01};
  InterferenceFilter filter = filter_of(wall);
  DepthImage frame = wall.frame(500);
  const double before = rms_mm(frame, wall);
  filter.filter(frame);
  EXPECT_GT(before, 40);
  EXPECT_LT(rms_mm(frame, wall), 0.3 * before);
}

TEST(InterferenceFilterTest, a_burst_of_noise_is_reduced) {
  const DisturbedWall quiet, burst{.noise_mm = 12};
  InterferenceFilter filter = filter_of(quiet);
  DepthImage frame;
  for (unsigned i = 500; i < 504; ++i) {
    frame = burst.frame(i);
    filter.filter(frame);
  }
  EXPECT_LT(rms_mm(frame, quiet), 4);
}

/// A thing that comes before the wall, 40 x 40 pixels.
void put(DepthImage& frame, int left, std::uint16_t depth_mm) {
  for (int y = 5; y < 45; ++y) {
    for (int x = left; x < left + 40; ++x) frame.at(x, y) = depth_mm;
  }
}

TEST(InterferenceFilterTest, what_moves_is_left_alone) {
  const DisturbedWall wall{.lost = 0.05};
  InterferenceFilter filter = filter_of(wall);
  for (unsigned i = 0; i < 20; ++i) {
    DepthImage frame = wall.frame(500 + i);
    put(frame, 20 + 4 * static_cast<int>(i), 1200);
    filter.filter(frame);
    for (int y = 6; y < 44; ++y) {
      for (int x = 21; x < 59; ++x)
        ASSERT_EQ(frame.at(x + 4 * static_cast<int>(i), y), 1200) << "frame " << i;
    }
  }
}

TEST(InterferenceFilterTest, the_wall_does_not_show_through_a_thing_that_returns_no_light) {
  const DisturbedWall wall{.lost = 0.05};
  InterferenceFilter filter = filter_of(wall);
  for (unsigned i = 0; i < 20; ++i) {
    DepthImage frame = wall.frame(500 + i);
    put(frame, 100, 0);
    filter.filter(frame);
    int held = 0;
    for (int y = 5; y < 45; ++y) {
      for (int x = 100; x < 140; ++x) held += frame.at(x, y) != 0;
    }
    EXPECT_LT(held, 240) << "frame " << i;  // of 1600: a rim where it covers less than half a block
  }
}

}  // namespace
}  // namespace roomcast::sensor
