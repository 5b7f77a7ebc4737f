// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/plane_completion.h"

#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "roomcast/sensor/glossy_floor_fixture.h"

namespace roomcast::sensor {
namespace {

DepthImage completed(PlaneCompletion& completion, const GlossyFloor& room, int frames) {
  DepthImage depth_mm;
  for (int i = 0; i < frames; ++i) {
    depth_mm = room.depth_mm();
    completion.complete(depth_mm, room.color());
  }
  return depth_mm;
}

int holes(const DepthImage& depth_mm) {
  return static_cast<int>(
      std::count(depth_mm.data(), depth_mm.data() + GlossyFloor::kWidth * GlossyFloor::kHeight, 0));
}

TEST(PlaneCompletionTest, a_glossy_floor_is_filled_with_its_plane) {
  const GlossyFloor room;
  PlaneCompletion completion(room.calibration());
  ASSERT_GT(holes(room.depth_mm()), 12'000);
  const DepthImage filled = completed(completion, room, 10);
  EXPECT_LT(holes(filled), 300);
  for (int y = 0; y < GlossyFloor::kHeight; y += 5) {
    for (int x = 0; x < GlossyFloor::kWidth; x += 5) {
      if (filled.at(x, y) == 0) continue;
      EXPECT_NEAR(filled.at(x, y), 1000 * room.true_m(x, y), 40) << x << ", " << y;
    }
  }
}

TEST(PlaneCompletionTest, a_black_box_on_the_floor_does_not_become_floor) {
  const GlossyFloor room{.has_box = true};
  PlaneCompletion completion(room.calibration());
  const DepthImage filled = completed(completion, room, 60);
  for (int y = 140; y < 194; ++y) {
    for (int x = 180; x < 250; ++x) ASSERT_EQ(filled.at(x, y), 0) << x << ", " << y;
  }
  EXPECT_LT(holes(filled), 70 * 54 + 600);
}

TEST(PlaneCompletionTest, a_window_in_a_wall_is_filled_whatever_its_colours) {
  const GlossyFloor room{.has_window = true};
  PlaneCompletion completion(room.calibration());
  const DepthImage filled = completed(completion, room, 10);
  for (int y = 30; y < 60; ++y) {
    for (int x = 60; x < 120; ++x) ASSERT_NEAR(filled.at(x, y), 4000, 40) << x << ", " << y;
  }
}

TEST(PlaneCompletionTest, a_box_that_loses_its_readings_does_not_become_transparent) {
  GlossyFloor room{.has_box = true, .box_returns_light = true};
  PlaneCompletion completion(room.calibration());
  (void)completed(completion, room, 40);
  room.box_returns_light = false;
  const DepthImage filled = completed(completion, room, 60);
  for (int y = 144; y < 184; ++y) {
    for (int x = 184; x < 246; ++x) ASSERT_EQ(filled.at(x, y), 0) << x << ", " << y;
  }
}

TEST(PlaneCompletionTest, what_moves_over_the_floor_is_not_painted_on_it) {
  GlossyFloor room;
  PlaneCompletion completion(room.calibration());
  (void)completed(completion, room, 40);
  room.has_box = true;  // black, without readings, for the first time
  const DepthImage filled = completed(completion, room, 1);
  for (int y = 144; y < 184; ++y) {
    for (int x = 184; x < 246; ++x) {
      if (room.floor_m(y) <= GlossyFloor::kGloss_m) continue;
      ASSERT_EQ(filled.at(x, y), 0) << x << ", " << y;
    }
  }
}

TEST(PlaneCompletionTest, without_colour_or_planes_nothing_is_filled) {
  const GlossyFloor room;
  PlaneCompletion completion(room.calibration());
  DepthImage depth_mm = room.depth_mm();
  for (int i = 0; i < 20; ++i) completion.complete(depth_mm, {});
  EXPECT_EQ(depth_mm, room.depth_mm());
  DepthImage empty(GlossyFloor::kWidth, GlossyFloor::kHeight), other_size(80, 60);
  for (int i = 0; i < 20; ++i) completion.complete(empty, room.color());
  EXPECT_EQ(empty, DepthImage(GlossyFloor::kWidth, GlossyFloor::kHeight));
  completion.complete(other_size, room.color());
  EXPECT_EQ(completion.filled(), 0);
}

}  // namespace
}  // namespace roomcast::sensor
