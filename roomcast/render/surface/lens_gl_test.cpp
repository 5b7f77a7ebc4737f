// SPDX-License-Identifier: Apache-2.0
// Checks that surfaces are drawn where the camera model projects them, for a distorting lens and
// any two poses.
#include <cmath>

#include "roomcast/render/room_fixture.h"

namespace roomcast::render {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// The lens of a Kinect v2 at a quarter of its resolution.
CameraIntrinsics distorting_lens() {
  CameraIntrinsics lens = pinhole(128, 106, 91);
  lens.cx += 1.7;
  lens.cy -= 2.3;
  lens.k1 = 0.09;
  lens.k2 = -0.27;
  lens.k3 = 0.10;
  lens.p1 = -0.002;
  lens.p2 = 0.001;
  return lens;
}

const RigidTransform kSensorPose =
    world_from_optical_looking_at(Vector3d(0.5, 1.9, 0.2), Vector3d(2, 0.9, -2));

std::optional<Vector2d> middle_of_drawn(const Image<std::int32_t>& sensors) {
  Vector2d sum = Vector2d::Zero();
  int count = 0;
  for (int y = 0; y < sensors.height(); ++y) {
    for (int x = 0; x < sensors.width(); ++x) {
      if (sensors.at(x, y) == kDrawnByNoSensor) continue;
      sum += Vector2d(x, y);
      ++count;
    }
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

class LensTest : public RoomTest, public ::testing::WithParamInterface<RenderMode> {
 protected:
  // Draws one spot of 3x3 depth pixels, seen by a pinhole eye, and compares its centre with the
  // camera model.
  void expect_spot_where_projected(const CameraIntrinsics& lens, int x, int y, double z_m,
                                   const CameraIntrinsics& eye, const RigidTransform& eye_pose) {
    SensorPictures pictures = wall(lens, 0, kRed);
    fill_box(pictures.depth_mm, x - 1, y - 1, x + 2, y + 2, static_cast<std::uint16_t>(1000 * z_m));
    add(kFirst, lens, kSensorPose, pictures);
    const std::optional<Vector3d> in_sensor = unproject(lens, Vector2d(x, y), z_m);
    ASSERT_TRUE(in_sensor.has_value());
    const std::optional<Vector2d> expected =
        project(eye, eye_pose.inverse() * (kSensorPose * *in_sensor));
    ASSERT_TRUE(expected.has_value());

    const Picture picture = draw(eye_of(eye, eye_pose), GetParam());
    const std::optional<Vector2d> drawn = middle_of_drawn(picture.sensors);
    ASSERT_TRUE(drawn.has_value()) << "nothing drawn for " << x << "," << y;
    constexpr double kWithinPx = 1;  // points and triangles snap to whole pixels
    EXPECT_LT((*drawn - *expected).norm(), kWithinPx)
        << x << "," << y << " drawn at " << drawn->transpose() << ", expected "
        << expected->transpose();
  }
};
INSTANTIATE_TEST_SUITE_P(Modes, LensTest,
                         ::testing::Values(RenderMode::kSplats, RenderMode::kMesh,
                                           RenderMode::kAdaptive, RenderMode::kBlend),
                         [](const auto& mode) { return std::string(name_of(mode.param)); });

TEST_P(LensTest, a_distorted_pixel_lands_where_the_camera_model_says) {
  const CameraIntrinsics lens = distorting_lens(), eye = pinhole(200, 160, 91);
  for (const auto& [x, y] : {std::pair(64, 53), {4, 4}, {123, 5}, {6, 100}, {121, 101}, {30, 70}}) {
    expect_spot_where_projected(lens, x, y, 2.0, eye, kSensorPose);
  }
}

TEST_P(LensTest, an_eye_elsewhere_sees_it_where_the_camera_model_says) {
  const CameraIntrinsics lens = distorting_lens(), eye = pinhole(240, 180, 110);
  const RigidTransform eye_pose =
      world_from_optical_looking_at(Vector3d(1.2, 1.4, 0.9), Vector3d(1.9, 1.0, -1.8));
  for (const auto& [x, y] : {std::pair(64, 53), {20, 20}, {110, 20}, {20, 90}, {110, 90}}) {
    expect_spot_where_projected(lens, x, y, 2.5, eye, eye_pose);
  }
}

TEST_P(LensTest, pixels_that_no_ray_reaches_draw_nothing) {
  CameraIntrinsics folding = pinhole(64, 48, 20);
  folding.k1 = -0.4;
  const Image<Eigen::Vector2f> rays = ray_table(folding);
  SensorPictures pictures = wall(folding, 0, kRed);
  int without_ray = 0;
  for (int y = 0; y < folding.height; ++y) {
    for (int x = 0; x < folding.width; ++x) {
      if (rays.at(x, y).allFinite()) continue;
      pictures.depth_mm.at(x, y) = 2000;
      ++without_ray;
    }
  }
  ASSERT_GT(without_ray, 10) << "the lens should fold";
  add(kFirst, folding, kSensorPose, pictures);
  const Picture picture = draw(eye_of(pinhole(128, 96, 10), kSensorPose), GetParam());
  EXPECT_FALSE(middle_of_drawn(picture.sensors).has_value());
}

}  // namespace
}  // namespace roomcast::render
