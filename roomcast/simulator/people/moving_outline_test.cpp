// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/people/moving_outline.h"

#include <gtest/gtest.h>

#include "roomcast/simulator/people/moving_picture.h"
#include "roomcast/simulator/sensing/sensor_unit.h"
#include "roomcast/simulator/tracing/static_plate.h"

namespace roomcast::simulator {
namespace {

using Sees = MovingOutline::Sees;

/// The people of a room in front of a distant wall.
class Outline : public testing::Test {
 protected:
  Outline() {
    things_.move_to(std::chrono::milliseconds(2500));
    layer_.draw(things_, camera_);
    outline_.find(layer_, wall_m_);
  }
  [[nodiscard]] PlacedCamera placed(double scale) const {
    const SensorMount& stand = room_.sensor_mounts[0];
    return {
        resampled(make_unit({}, 1, 0).exact.depth, scale),
        world_from_optical_looking_at(stand.eye_m.cast<double>(), stand.target_m.cast<double>())};
  }

  Room room_ = build_room("studio", 1).value();
  MovingThings things_{room_};
  PlacedCamera camera_ = placed(1.0), fine_camera_ = placed(2.0);
  Image<float> wall_m_{camera_.width(), camera_.height(), 20.0F};
  MovingLayer layer_{camera_.width(), camera_.height()};
  MovingOutline outline_{camera_.width(), camera_.height()};
};

TEST_F(Outline, is_where_moving_and_still_meet) {
  const PixelBox& box = outline_.box();
  int moving = 0, both = 0;
  for (int y = box.top + 1; y + 1 < box.bottom; ++y) {
    for (int x = box.left + 1; x + 1 < box.right; ++x) {
      int in_front = 0;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) in_front += is_in_front(layer_, wall_m_, x + dx, y + dy);
      const Sees sees = outline_.at(x, y);
      EXPECT_EQ(sees == Sees::kStill, in_front == 0);
      if (in_front > 0 && in_front < 9) {
        EXPECT_EQ(sees, Sees::kMaybeBoth);
      }
      moving += sees == Sees::kMoving;
      both += sees == Sees::kMaybeBoth;
    }
  }
  EXPECT_GT(moving, 10000);
  EXPECT_GT(both, 2000);
  EXPECT_LT(both, moving / 2);
}

TEST_F(Outline, its_tiles_equal_a_full_drawing) {
  MovingLayer all(fine_camera_.width(), fine_camera_.height()), tiles = all;
  all.draw(things_, fine_camera_);
  tiles.draw(things_, fine_camera_, &outline_.fine_tiles());
  const PixelBox& box = outline_.box();
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) {
      if (outline_.at(x, y) != Sees::kMaybeBoth) continue;
      for (int i = 0; i < 4; ++i) {
        const int u = 2 * x + (i & 1), v = 2 * y + (i >> 1);
        ASSERT_EQ(tiles.z_m().at(u, v), all.z_m().at(u, v));
      }
    }
  }
}

TEST_F(Outline, is_empty_without_people_in_front) {
  wall_m_ = Image<float>(camera_.width(), camera_.height(), 0.1F);
  outline_.find(layer_, wall_m_);
  const PixelBox& box = outline_.box();
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) ASSERT_EQ(outline_.at(x, y), Sees::kStill);
  }
}

}  // namespace
}  // namespace roomcast::simulator
