// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "roomcast/render/room_fixture.h"
#include "roomcast/render/surface/point_renderer.h"

namespace roomcast::render {
namespace {

using Eigen::Vector3d;

const CameraIntrinsics kPointRendererLens = pinhole(64, 48, 60);
const Vector3d kPointRendererEye(0, 1.5, 0), kPointRendererAhead(0, 1.5, -2);
const RigidTransform kPointRendererPose =
    world_from_optical_looking_at(kPointRendererEye, kPointRendererAhead);

using PointTest = RoomTest;

// Number of drawn pixels in the middle row.
int width_drawn(const Picture& picture) {
  int count = 0;
  for (int x = 0; x < picture.color.width(); ++x) {
    if (picture.color.at(x, picture.color.height() / 2) != kNothing) ++count;
  }
  return count;
}

// OpenGL drops a point whose centre is outside the picture even if its square reaches into it.
void expect_red_but_at_the_border(const Picture& picture, int point_px) {
  for (int y = point_px; y < picture.color.height() - point_px; ++y) {
    for (int x = point_px; x < picture.color.width() - point_px; ++x) {
      ASSERT_EQ(picture.color.at(x, y), kRed) << x << "," << y << " of points " << point_px;
    }
  }
}

TEST_F(PointTest, a_wall_has_no_holes_when_one_goes_nearer) {
  add(kFirst, kPointRendererLens, kPointRendererPose, wall(kPointRendererLens, 2000, kRed));
  for (const double distance_m : {1.5, 1.0, 0.4}) {
    const RigidTransform nearer = world_from_optical_looking_at(
        kPointRendererAhead + Vector3d(0, 0, distance_m), kPointRendererAhead);
    const Picture picture = draw(eye_of(kPointRendererLens, nearer), RenderMode::kSplats);
    expect_red_but_at_the_border(picture, static_cast<int>(std::ceil(2 / distance_m)));
  }
}

TEST_F(PointTest, a_wall_seen_at_45_degrees_has_no_holes) {
  add(kFirst, kPointRendererLens, kPointRendererPose, wall(kPointRendererLens, 2000, kRed));
  const RigidTransform aside =
      world_from_optical_looking_at(kPointRendererAhead + Vector3d(1, 0, 1), kPointRendererAhead);
  const Picture picture = draw(eye_of(pinhole(32, 24, 60), aside), RenderMode::kSplats);
  expect_red_but_at_the_border(picture, 2);
}

// The sensor sees the wall at 50 degrees: its points are 1.6 times farther apart than on a wall
// that faces the sensor.
TEST_F(PointTest, a_wall_that_its_sensor_sees_at_a_slant_has_no_holes) {
  SensorPictures pictures = wall(kPointRendererLens, 0, kRed);
  constexpr double kStep = 1.02;
  for (int x = 0; x < kPointRendererLens.width; ++x) {
    const double depth_mm = 1000 * std::pow(kStep, x);
    fill_box(pictures.depth_mm, x, 0, x + 1, kPointRendererLens.height,
             static_cast<std::uint16_t>(depth_mm));
  }
  add(kFirst, kPointRendererLens, kPointRendererPose, pictures);
  const double middle_m = std::pow(kStep, kPointRendererLens.cx);
  const Vector3d middle = kPointRendererEye - Vector3d(0, 0, middle_m);
  const Vector3d normal = Vector3d((kStep - 1) * kPointRendererLens.fx, 0, 1).normalized();
  const RigidTransform facing = world_from_optical_looking_at(middle + middle_m * normal, middle);
  const Picture picture =
      draw(eye_of(pinhole(64, 48, 4 * kPointRendererLens.fx), facing), RenderMode::kSplats);
  EXPECT_EQ(picture.color, ColorImage(64, 48, kRed));
}

TEST_F(PointTest, a_lone_reading_is_drawn_only_when_it_has_a_color) {
  SensorPictures pictures = wall(kPointRendererLens, 3000, kRed);
  pictures.depth_mm.at(20, 24) = 1000;
  pictures.seen.at(20, 24) = 0;
  pictures.depth_mm.at(40, 24) = 1000;
  pictures.color.at(40, 24) = kBlue;
  add(kFirst, kPointRendererLens, kPointRendererPose, pictures);
  const ColorImage picture =
      draw(eye_of(kPointRendererLens, kPointRendererPose), RenderMode::kSplats).color;
  EXPECT_EQ(picture.at(20, 24), kNothing);
  EXPECT_EQ(picture.at(40, 24), kBlue);
}

TEST_F(PointTest, a_point_is_as_large_as_its_depth_pixel_on_the_surface) {
  SensorPictures pictures = wall(kPointRendererLens, 0, kRed);
  pictures.depth_mm.at(32, 24) = 2000;
  add(kFirst, kPointRendererLens, kPointRendererPose, pictures);
  const CameraIntrinsics fine = pinhole(640, 480, 600);  // ten pixels for each of the sensor's
  const double overlap = 1.2;
  EXPECT_NEAR(width_drawn(draw(eye_of(fine, kPointRendererPose), RenderMode::kSplats)),
              10 * overlap, 1);

  const RigidTransform back =
      world_from_optical_looking_at(Vector3d(0, 1.5, 2), kPointRendererAhead);
  EXPECT_NEAR(width_drawn(draw(eye_of(fine, back), RenderMode::kSplats)), 5 * overlap, 1);
}

}  // namespace
}  // namespace roomcast::render
