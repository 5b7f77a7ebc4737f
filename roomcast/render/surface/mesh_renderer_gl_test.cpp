// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "roomcast/render/room_fixture.h"
#include "roomcast/render/surface/mesh_renderer.h"

namespace roomcast::render {
namespace {

using Eigen::Vector3d;

const CameraIntrinsics kLens = pinhole(64, 48, 60);
const Vector3d kEye(0, 1.5, 0), kAhead(0, 1.5, -2);
const RigidTransform kPose = world_from_optical_looking_at(kEye, kAhead);

class MeshTest : public RoomTest {
 protected:
  Picture draw_from(const Vector3d& eye, int finer = 1) {
    const CameraIntrinsics lens = pinhole(160 * finer, 120 * finer, 60 * finer);
    return draw(eye_of(lens, world_from_optical_looking_at(eye, kAhead)), RenderMode::kMesh);
  }
};

std::ptrdiff_t pixels_drawn(const Picture& picture) {
  const std::int32_t* first = picture.sensors.data();
  const auto all = static_cast<std::ptrdiff_t>(picture.sensors.view().pixel_count());
  return all - std::count(first, first + all, kDrawnByNoSensor);
}

// Foreground at 1 m in the left half of the picture, wall at 3 m in the right half, seen from far
// to the right. There is only air between the foreground's edge (x = 0, z = -1) and the wall's (x =
// 0, z = -3).
TEST_F(MeshTest, no_rubber_sheet_joins_foreground_and_background) {
  SensorPictures pictures = wall(kLens, 3000, kBlue);
  fill_box<std::uint16_t>(pictures.depth_mm, 0, 0, 32, 48, 1000);
  fill_box(pictures.color, 0, 0, 32, 48, kRed);
  add(kFirst, kLens, kPose, pictures);
  const Picture picture = draw_from(Vector3d(2, 1.5, 0), 2);

  const int row = 120;  // the eye's height
  int air = 0, red = 0, blue = 0;
  for (int x = 0; x < 320; ++x) {
    const Rgb8 color = picture.color.at(x, row);
    if (color == kNothing) ++air;
    if (color == kRed) ++red;
    if (color == kBlue) ++blue;
  }
  EXPECT_GT(red, 10);
  EXPECT_GT(blue, 10);
  EXPECT_GT(air, 10);
  EXPECT_EQ(red + blue + air, 320) << "a mixture of both colours was drawn";
}

TEST_F(MeshTest, a_slanted_wall_has_no_holes) {
  SensorPictures pictures = wall(kLens, 0, kRed);
  for (int x = 0; x < kLens.width; ++x) {  // depth grows by 2 % per pixel, from 1 m to 3.5 m
    const double depth_mm = 1000 * std::pow(1.02, x);
    fill_box(pictures.depth_mm, x, 0, x + 1, kLens.height, static_cast<std::uint16_t>(depth_mm));
  }
  add(kFirst, kLens, kPose, pictures);
  const Picture picture = draw(eye_of(kLens, kPose), RenderMode::kMesh);
  for (int y = 1; y < kLens.height - 1; ++y) {
    for (int x = 1; x < kLens.width - 1; ++x) ASSERT_EQ(picture.color.at(x, y), kRed);
  }
}

TEST_F(MeshTest, a_surface_is_open_from_behind) {
  add(kFirst, kLens, kPose, wall(kLens, 2000, kRed));
  EXPECT_GT(pixels_drawn(draw_from(kEye)), 1000);
  EXPECT_EQ(pixels_drawn(draw_from(Vector3d(0, 1.5, -4))), 0);
}

TEST_F(MeshTest, a_coarser_grid_covers_the_same_wall) {
  add(kFirst, kLens, kPose, wall(kLens, 2000, kRed));
  const std::ptrdiff_t fine = pixels_drawn(draw_from(kEye));
  options_.mesh.grid_step = 4;
  ASSERT_TRUE(room_->set_options(options_).ok());
  const std::ptrdiff_t coarse = pixels_drawn(draw_from(kEye));
  EXPECT_EQ(fine, 63 * 47);
  EXPECT_EQ(coarse,
            60 * 44);  // an incomplete last cell at the right and the bottom is not drawn
}

TEST_F(MeshTest, color_is_interpolated_between_depth_pixels) {
  SensorPictures pictures = wall(kLens, 1000, Rgb8{0, 0, 0});
  fill_box(pictures.color, 32, 0, 64, 48, Rgb8{200, 200, 200});
  add(kFirst, kLens, kPose, pictures);
  const Picture picture = draw(eye_of(pinhole(256, 192, 480), kPose), RenderMode::kMesh);
  // Vertices are 8 pixels apart: the step from black to white is between columns 123.5 and 131.5.
  EXPECT_EQ(picture.color.at(122, 96).r, 0);
  EXPECT_NEAR(picture.color.at(127, 96).r, 200 * 3.5 / 8, 2);
  EXPECT_NEAR(picture.color.at(128, 96).r, 200 * 4.5 / 8, 2);
  EXPECT_EQ(picture.color.at(133, 96).r, 200);
}

}  // namespace
}  // namespace roomcast::render
