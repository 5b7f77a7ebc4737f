// SPDX-License-Identifier: Apache-2.0
#include "bench/real/motion_forecast.h"

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

CameraIntrinsics forecast_lens() {
  CameraIntrinsics lens;
  lens.width = 160;
  lens.height = 120;
  lens.fx = lens.fy = 150;
  lens.cx = 79.5;
  lens.cy = 59.5;
  return lens;
}

/// A board of 40x40 pixels at 1.5 m before a wall at 3 m, that moves by so many pixels from frame
/// to frame.
std::vector<DepthImage> moving_board(int step, int frames = 12) {
  const CameraIntrinsics lens = forecast_lens();
  std::vector<DepthImage> all;
  for (int i = 0; i < frames; ++i) {
    DepthImage frame(lens.width, lens.height, 3000);
    const int left = 10 + i * step;
    for (int y = 40; y < 80; ++y) {
      for (int x = left; x < left + 40; ++x) frame.at(x, y) = 1500;
    }
    all.push_back(frame);
  }
  return all;
}

TEST(MotionForecastTest, a_board_that_moves_evenly_is_where_its_motion_says) {
  const MotionForecast forecast = forecast_motion("s0", forecast_lens(), moving_board(6));
  EXPECT_GT(forecast.moving, 5000);
  EXPECT_NEAR(forecast.off_unmoved, 6.0 / 40, 0.03) << "the columns that it leaves";
  EXPECT_LT(forecast.off_moved, forecast.off_unmoved / 2) << "its borders are known to a pixel";
}

TEST(MotionForecastTest, a_board_that_turns_back_is_not) {
  std::vector<DepthImage> there_and_back = moving_board(6, 2);
  const DepthImage wall(forecast_lens().width, forecast_lens().height, 3000);
  there_and_back.insert(there_and_back.begin(), 4, wall);
  there_and_back.push_back(there_and_back[4]);
  const MotionForecast forecast = forecast_motion("s0", forecast_lens(), there_and_back);
  EXPECT_GT(forecast.off_moved, forecast.off_unmoved);
}

TEST(MotionForecastTest, what_stands_still_does_not_move) {
  EXPECT_EQ(forecast_motion("s0", forecast_lens(), moving_board(0)).moving, 0);
  EXPECT_EQ(forecast_motion("s0", forecast_lens(), moving_board(6, 1)).moving, 0);
}

}  // namespace
}  // namespace roomcast::bench
