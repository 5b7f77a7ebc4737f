// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/calibration/view_collector.h"

#include <optional>

#include <gtest/gtest.h>

#include "roomcast/alignment/calibration/views_fixture.h"

namespace roomcast::alignment::calibration {
namespace {

using Verdict = ViewCollector::Verdict;

TEST(WayOfCorners, needs_four_that_both_hold) {
  const std::vector<SeenCorner> a = {{0, {0, 0}}, {1, {1, 0}}, {2, {2, 0}}, {3, {3, 0}}};
  std::vector<SeenCorner> b = a;
  for (SeenCorner& corner : b) corner.pixel.y() += 3;
  EXPECT_DOUBLE_EQ(*way_px(a, b), 3);
  b.pop_back();
  EXPECT_FALSE(way_px(a, b));
}

TEST(ViewCollector, takes_a_board_once_it_is_held_still_somewhere_new) {
  const CharucoBoard board;
  SensorFixture sensor(kinect_fixture(), board);
  ViewCollector collector(board);
  source::CapturedFrame nothing;
  nothing.color.resize(640, 480);
  EXPECT_EQ(collector.add(nothing), Verdict::kNoBoard);
  const auto poses = held_about(board, 2);
  const source::CapturedFrame here = sensor.see(poses[0]), there = sensor.see(poses[1]);
  EXPECT_EQ(collector.add(here), Verdict::kMoving);
  EXPECT_EQ(collector.add(here), Verdict::kTaken);
  EXPECT_EQ(collector.add(here), Verdict::kSeenBefore);
  EXPECT_EQ(collector.add(there), Verdict::kMoving);
  EXPECT_EQ(collector.add(there), Verdict::kTaken);
  EXPECT_EQ(collector.views().size(), 2U);
}

}  // namespace
}  // namespace roomcast::alignment::calibration
