// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/room_fixture.h"
#include "roomcast/render/surface/floor_grid.h"

namespace roomcast::render {
namespace {

using Eigen::Vector3d;

class FloorGridTest : public RoomTest {
 protected:
  void show_floor() {
    options_.floor_grid = true;
    ASSERT_TRUE(room_->set_options(options_).ok());
  }
};

const CameraIntrinsics kEye = pinhole(200, 200, 100);

TEST_F(FloorGridTest, lines_lie_on_whole_metres_of_the_floor) {
  show_floor();
  // Looks straight down from 1 m: 100 pixels per metre, the picture's top towards -z.
  const RigidTransform down =
      world_from_optical_looking_at(Vector3d(0.2, 1, 0.3), Vector3d(0.2, 0, 0.3));
  const ColorImage picture = draw(eye_of(kEye, down), RenderMode::kMesh).color;
  const int line_x = 79, line_z = 69;  // x = 0 is 20 pixels left of the middle, z = 0 is 30 above
  EXPECT_GT(picture.at(line_x, 120).g, kNothing.g + 20);
  EXPECT_GT(picture.at(130, line_z).g, kNothing.g + 20);
  EXPECT_EQ(picture.at(130, 120), kNothing);
}

TEST_F(FloorGridTest, it_belongs_to_no_sensor_and_lies_behind_everything) {
  show_floor();
  const RigidTransform pose =
      world_from_optical_looking_at(Vector3d(0, 1, 0), Vector3d(0.5, 0, -1));
  const Picture empty = draw(eye_of(kEye, pose), RenderMode::kMesh);
  EXPECT_NE(empty.color, ColorImage(200, 200, kNothing));
  EXPECT_EQ(empty.sensors, Image<std::int32_t>(200, 200, kDrawnByNoSensor));

  const CameraIntrinsics lens = pinhole(64, 64, 20);  // wider than the eye's field of view
  add(kFirst, lens, pose, wall(lens, 8000, kRed));    // mostly below the floor
  EXPECT_EQ(draw(eye_of(kEye, pose), RenderMode::kMesh).color, ColorImage(200, 200, kRed));
}

TEST_F(FloorGridTest, nothing_is_drawn_above_the_horizon_or_when_switched_off) {
  const RigidTransform ahead =
      world_from_optical_looking_at(Vector3d(0, 1.6, 0), Vector3d(0, 1.6, -3));
  EXPECT_EQ(draw(eye_of(kEye, ahead), RenderMode::kMesh).color, ColorImage(200, 200, kNothing));
  show_floor();
  const ColorImage picture = draw(eye_of(kEye, ahead), RenderMode::kMesh).color;
  for (int x = 0; x < 200; ++x) ASSERT_EQ(picture.at(x, 95), kNothing);
}

}  // namespace
}  // namespace roomcast::render
