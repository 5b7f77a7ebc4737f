// SPDX-License-Identifier: Apache-2.0
// Tests drawing where readings of a remembered wall are missing.
#include "roomcast/render/blend/depth_completion.h"
#include "roomcast/render/room_fixture.h"

namespace roomcast::render {
namespace {

using Eigen::Vector3d;

const CameraIntrinsics kDepthCompletionLens = pinhole(64, 48, 60);
const RigidTransform kDepthCompletionPose =
    world_from_optical_looking_at(Vector3d(0, 1.5, 0), Vector3d(0, 1.5, -3));
constexpr Rgb8 kWall = {190, 180, 170}, kDark = {20, 22, 25};
constexpr int kDepthCompletionMiddleX = 32, kDepthCompletionMiddleY = 24;

class DepthCompletionTest : public RoomTest {
 protected:
  void SetUp() override {
    RoomTest::SetUp();
    for (int i = 0; i < 40; ++i)
      add(kFirst, kDepthCompletionLens, kDepthCompletionPose,
          wall(kDepthCompletionLens, 3000, kWall));
  }

  /// The wall with a box in the middle without readings, in which the colour camera sees `seen`.
  static SensorPictures without_readings(Rgb8 seen, int half_px = 10) {
    SensorPictures pictures = wall(kDepthCompletionLens, 3000, kWall);
    const int x0 = kDepthCompletionMiddleX - half_px, x1 = kDepthCompletionMiddleX + half_px;
    const int y0 = kDepthCompletionMiddleY - half_px, y1 = kDepthCompletionMiddleY + half_px;
    fill_box<std::uint16_t>(pictures.depth_mm, x0, y0, x1, y1, 0);
    fill_box<std::uint8_t>(pictures.seen, x0, y0, x1, y1, 0);
    fill_box(pictures.color, x0, y0, x1, y1, seen);
    return pictures;
  }
  Rgb8 middle(const SensorPictures& pictures, RenderMode mode = RenderMode::kBlend) {
    add(kFirst, kDepthCompletionLens, kDepthCompletionPose, pictures);
    return draw(eye_of(kDepthCompletionLens, kDepthCompletionPose), mode)
        .color.at(kDepthCompletionMiddleX, kDepthCompletionMiddleY);
  }
  double middle_m(const SensorPictures& pictures) {
    add(kFirst, kDepthCompletionLens, kDepthCompletionPose, pictures);
    const ViewCamera eye = eye_of(kDepthCompletionLens, kDepthCompletionPose);
    const auto target = OffscreenTarget::create(eye.width, eye.height);
    EXPECT_TRUE(room_->draw(eye, *target, RenderMode::kBlend).ok());
    return target->read_depth_m(eye).at(kDepthCompletionMiddleX, kDepthCompletionMiddleY);
  }
};

TEST_F(DepthCompletionTest, a_dark_thing_is_dark_and_not_the_wall_behind_it) {
  const Rgb8 shown = middle(without_readings(kDark));
  EXPECT_LT(shown.r, 60);
  EXPECT_LT(middle(without_readings(kDark), RenderMode::kAdaptive).r, 60);
}

TEST_F(DepthCompletionTest, the_wall_is_there_without_its_readings) {
  const Rgb8 shown = middle(without_readings(kWall));
  EXPECT_NEAR(shown.r, kWall.r, 2);
}

TEST_F(DepthCompletionTest, a_shadow_or_another_exposure_makes_no_thing_of_it) {
  for (const double light : {0.82, 1.2}) {
    const auto lit = [light](std::uint8_t level) {
      return static_cast<std::uint8_t>(light * level);
    };
    const Rgb8 shown = middle(without_readings({lit(kWall.r), lit(kWall.g), lit(kWall.b)}));
    EXPECT_NEAR(shown.r, kWall.r, 2) << light;
  }
}

TEST_F(DepthCompletionTest, a_few_pixels_are_no_thing) {
  EXPECT_GT(middle(without_readings(kDark, 1)).r, (kDark.r + kWall.r) / 2);
}

TEST_F(DepthCompletionTest, a_thing_hangs_on_the_wall_or_is_as_near_as_its_frame) {
  SensorPictures pictures = without_readings(kDark);
  EXPECT_NEAR(middle_m(pictures), 3, 0.05);
  SensorPictures framed = wall(kDepthCompletionLens, 3000, kWall);
  fill_box<std::uint16_t>(framed.depth_mm, 20, 12, 44, 36, 1800);
  fill_box<std::uint16_t>(framed.depth_mm, 23, 15, 41, 33, 0);
  fill_box<std::uint8_t>(framed.seen, 23, 15, 41, 33, 0);
  fill_box(framed.color, 23, 15, 41, 33, kDark);
  EXPECT_NEAR(middle_m(framed), 1.8, 0.05);
}

TEST_F(DepthCompletionTest, where_readings_always_came_and_went_the_wall_stays) {
  for (int i = 0; i < 60; ++i) {
    add(kFirst, kDepthCompletionLens, kDepthCompletionPose,
        i % 2 == 0 ? without_readings(kWall) : wall(kDepthCompletionLens, 3000, kWall));
  }
  EXPECT_NEAR(middle(without_readings(kDark)).r, kWall.r, 2);
}

}  // namespace
}  // namespace roomcast::render
