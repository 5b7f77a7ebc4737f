// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/adaptive_renderer.h"
#include "roomcast/render/room_fixture.h"

namespace roomcast::render {
namespace {

using Eigen::Vector3d;

const CameraIntrinsics kAdaptiveRendererLens = pinhole(64, 48, 60);
const RigidTransform kAdaptiveRendererPose =
    world_from_optical_looking_at(Vector3d(0, 1.5, 0), Vector3d(0, 1.5, -2));
constexpr int kMiddleX = 32, kMiddleY = 24;

class AdaptiveTest : public RoomTest {
 protected:
  Rgb8 middle() {
    return draw(eye_of(kAdaptiveRendererLens, kAdaptiveRendererPose), RenderMode::kAdaptive)
        .color.at(kMiddleX, kMiddleY);
  }
};

TEST_F(AdaptiveTest, the_nearest_surface_wins_whoever_saw_it) {
  add(kFirst, kAdaptiveRendererLens, kAdaptiveRendererPose,
      wall(kAdaptiveRendererLens, 2500, kBlue));
  add(kSecond, kAdaptiveRendererLens, kAdaptiveRendererPose,
      wall(kAdaptiveRendererLens, 2000, kRed));
  EXPECT_EQ(middle(), kRed);
  add(kFirst, kAdaptiveRendererLens, kAdaptiveRendererPose,
      wall(kAdaptiveRendererLens, 1500, kBlue));
  EXPECT_EQ(middle(), kBlue);
}

TEST_F(AdaptiveTest, a_surface_without_a_colour_stands_back_behind_its_colored_twin) {
  SensorPictures grey = wall(kAdaptiveRendererLens, 2000, kBlue);
  grey.seen = MaskImage(kAdaptiveRendererLens.width, kAdaptiveRendererLens.height, 0);
  add(kFirst, kAdaptiveRendererLens, kAdaptiveRendererPose, grey);
  const Rgb8 alone = middle();
  EXPECT_EQ(alone.r, alone.b) << "not the blue that nobody saw";
  add(kSecond, kAdaptiveRendererLens, kAdaptiveRendererPose,
      wall(kAdaptiveRendererLens, 2010, kRed));
  EXPECT_EQ(middle(), kRed);
  add(kSecond, kAdaptiveRendererLens, kAdaptiveRendererPose,
      wall(kAdaptiveRendererLens, 2200, kRed));
  EXPECT_EQ(middle(), alone) << "20 cm are another surface";
}

TEST_F(AdaptiveTest, its_depth_is_that_of_the_surface) {
  add(kFirst, kAdaptiveRendererLens, kAdaptiveRendererPose,
      wall(kAdaptiveRendererLens, 2000, kRed));
  const ViewCamera camera = eye_of(kAdaptiveRendererLens, kAdaptiveRendererPose);
  Result<OffscreenTarget> target = OffscreenTarget::create(camera.width, camera.height);
  ASSERT_TRUE(target.ok());
  ASSERT_TRUE(room_->draw(camera, *target, RenderMode::kAdaptive).ok());
  EXPECT_NEAR(target->read_depth_m(camera).at(kMiddleX, kMiddleY), 2, 2e-3);
}

}  // namespace
}  // namespace roomcast::render
