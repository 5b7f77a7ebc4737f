// SPDX-License-Identifier: Apache-2.0
#include "bench/render/drawing_cost.h"
#include "roomcast/render/room_fixture.h"

namespace roomcast::bench {
namespace {

const CameraIntrinsics kLens = render::pinhole(64, 48, 60);

using DrawingCostTest = render::RoomTest;

TEST_F(DrawingCostTest, of_both_eyes_is_measured_both_ways) {
  add(render::kFirst, kLens, RigidTransform{}, render::wall(kLens, 2000, render::kRed));
  const auto cost =
      stereo_cost(*room_, render::eye_of(kLens, RigidTransform{}), render::RenderMode::kMesh, 3);
  ASSERT_TRUE(cost.ok()) << cost.error().message;
  EXPECT_GT(cost->at_once_cpu_ms, 0);
  EXPECT_GT(cost->one_by_one_cpu_ms, 0);
}

TEST_F(DrawingCostTest, of_an_invalid_view_is_an_error) {
  render::ViewCamera camera = render::eye_of(kLens, RigidTransform{});
  camera.near_m = 0;
  EXPECT_FALSE(stereo_cost(*room_, camera, render::RenderMode::kMesh, 1).ok());
}

}  // namespace
}  // namespace roomcast::bench
