// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/tracing/multipath.h"

#include <gtest/gtest.h>

#include "roomcast/source/simulator/sensing/sensor_unit.h"
#include "roomcast/source/simulator/tracing/static_plate.h"

namespace roomcast::sim {
namespace {

/// Detours of a room looked at from the origin towards -z.
Image<float> detours(const Room& room, int threads = 0) {
  const auto rays = RayScene::build(room.mesh).value();
  const CameraIntrinsics lens = make_unit({}, 1, 0).exact.depth;
  const RigidTransform pose = world_from_optical_looking_at({0, 1, 0}, {0, 1, -3});
  const PlacedCamera camera(lens, pose), fine(resampled(lens, 2.0), pose);
  return trace_depth_plate(room, *rays, camera, fine, true, threads).detour_m;
}

Room wall_at_3_m() {
  Room room;
  const auto grey = room.add(painted(Pattern::kPlain, 0x808080, 0x808080, 0x808080, 1, 0.6F));
  add_quad(room.mesh, grey, Eigen::Affine3f::Identity(), {-8, -7, -3}, {16, 0, 0}, {0, 16, 0});
  return room;
}

TEST(Multipath, a_wall_alone_has_none) {
  const Image<float> detour_m = detours(wall_at_3_m());
  for (std::size_t i = 0; i < detour_m.view().pixel_count(); ++i)
    EXPECT_EQ(detour_m.data()[i], 0.0F);
}

TEST(Multipath, a_corner_appears_too_far_and_more_so_the_brighter_its_walls) {
  const auto corner = [](float infrared) {
    Room room = wall_at_3_m();
    const auto side = room.add(painted(Pattern::kPlain, 0x808080, 0x808080, 0x808080, 1, infrared));
    add_quad(room.mesh, side, Eigen::Affine3f::Identity(), {0.5F, -7, -3}, {0, 0, 4}, {0, 16, 0});
    return detours(room);
  };
  const Image<float> bright = corner(0.6F), dark = corner(0.1F);
  // On the far wall 20 cm beside the corner.
  const int near_x = 252 + static_cast<int>(364.0 * 0.3 / 3.0);
  const float near_m = bright.at(near_x, 206);
  EXPECT_GT(near_m, 0.003F);
  EXPECT_LT(near_m, 0.15F);
  EXPECT_NEAR(dark.at(near_x, 206) / near_m, 1.0F / 6.0F, 0.06F);
}

TEST(Multipath, does_not_depend_on_the_number_of_threads) {
  const Room room = build_room("office", 1).value();
  EXPECT_EQ(detours(room, 1), detours(room, 3));
}

}  // namespace
}  // namespace roomcast::sim
