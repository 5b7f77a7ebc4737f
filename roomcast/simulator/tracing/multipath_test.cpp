// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/tracing/multipath.h"

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include <gtest/gtest.h>

#include "roomcast/simulator/sensing/sensor_unit.h"
#include "roomcast/simulator/tracing/static_plate.h"

namespace roomcast::simulator {
namespace {

/// A camera 1 m above the origin, facing -z.
PlacedCamera camera_in_corner(double scale) {
  const CameraIntrinsics lens = make_unit({}, 1, 0).exact.depth;
  return {resampled(lens, scale), world_from_optical_looking_at({0, 1, 0}, {0, 1, -3})};
}

Image<float> detours(const Room& room, int threads = 0) {
  const auto rays = RayScene::build(room.mesh).value();
  return trace_depth_plate(room, *rays, camera_in_corner(1.0), camera_in_corner(2.0), true, threads)
      .detour_m;
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

constexpr float kSide_x = 0.5F, kSideDepth_m = 4.0F;

Room corner(float infrared) {
  Room room = wall_at_3_m();
  const auto side = room.add(painted(Pattern::kPlain, 0x808080, 0x808080, 0x808080, 1, infrared));
  add_quad(room.mesh, side, Eigen::Affine3f::Identity(), {kSide_x, -7, -3}, {0, 0, kSideDepth_m},
           {0, 16, 0});
  return room;
}

/// Excess distance of a point of the far wall: sums light over squares of the side wall instead of
/// over rays from the point.
float summed_detour_m(const PlacedCamera& camera, const Eigen::Vector3f& point_m, float infrared) {
  constexpr float kSquare_m = 0.02F;
  constexpr float kTurn = 2.0F * std::numbers::pi_v<float>;
  const float direct_way = (point_m - camera.eye_m()).norm();
  const float direct = -(point_m - camera.eye_m()).z() / std::pow(direct_way, 3.0F);
  const std::array half_waves_m = {1.875F, 1.25F};
  std::array<std::complex<float>, 2> light = {direct, direct};
  for (float z = -3.0F + 0.5F * kSquare_m; z < kSideDepth_m - 3.0F; z += kSquare_m) {
    for (float y = -7.0F + 0.5F * kSquare_m; y < 9.0F; y += kSquare_m) {
      const Eigen::Vector3f from_eye = Eigen::Vector3f(kSide_x, y, z) - camera.eye_m();
      const auto pixel = camera.pixel_of(camera.axes().transpose() * from_eye);
      if (!pixel || pixel->x() < 0 || pixel->y() < 0 || pixel->x() > 511 || pixel->y() > 423)
        continue;
      const float way = from_eye.norm();
      const float lit = from_eye.x() / (way * way * way);
      const Eigen::Vector3f on = point_m - Eigen::Vector3f(kSide_x, y, z);
      const float across = on.norm();
      const float arriving = -on.x() * -on.z() / std::pow(across, 4.0F);
      const float share =
          infrared / std::numbers::pi_v<float> * lit * arriving * kSquare_m * kSquare_m;
      for (std::size_t f = 0; f < 2; ++f)
        light[f] += std::polar(share, kTurn * 0.5F * (way + across - direct_way) / half_waves_m[f]);
    }
  }
  float sum_m = 0.0F;
  for (std::size_t f = 0; f < 2; ++f) sum_m += 0.5F * std::arg(light[f]) / kTurn * half_waves_m[f];
  return sum_m / direct_way * 3.0F;
}

TEST(Multipath, a_corner_bends_by_the_summed_light_of_its_other_wall) {
  const PlacedCamera camera = camera_in_corner(1.0);
  const Image<float> detour_m = detours(corner(0.6F));
  float most_m = 0.0F;
  for (const float beside_m : {0.1F, 0.2F, 0.3F, 0.5F, 0.8F}) {
    const Eigen::Vector3f point_m(kSide_x - beside_m, 1.0F, -3.0F);
    const auto pixel = camera.pixel_of(camera.axes().transpose() * (point_m - camera.eye_m()));
    const float traced_m = detour_m.at(static_cast<int>(std::lround(pixel->x())),
                                       static_cast<int>(std::lround(pixel->y())));
    const float summed_m = summed_detour_m(camera, point_m, 0.6F);
    EXPECT_NEAR(traced_m, summed_m, 0.2F * summed_m + 0.001F) << beside_m;
    most_m = std::max(most_m, traced_m);
  }
  // A few millimetres to a few centimetres, as real time-of-flight cameras show in corners.
  EXPECT_GT(most_m, 0.004F);
  EXPECT_LT(most_m, 0.06F);
}

TEST(Multipath, a_corner_appears_the_farther_the_brighter_its_other_wall) {
  const Image<float> bright = detours(corner(0.6F)), dark = detours(corner(0.1F));
  const int beside_x = 252 + static_cast<int>(364.0 * 0.3 / 3.0);
  EXPECT_GT(bright.at(beside_x, 206), 0.003F);
  EXPECT_NEAR(dark.at(beside_x, 206) / bright.at(beside_x, 206), 1.0F / 6.0F, 0.06F);
}

TEST(Multipath, does_not_depend_on_the_number_of_threads) {
  const Room room = build_room("office", 1).value();
  EXPECT_EQ(detours(room, 1), detours(room, 3));
}

}  // namespace
}  // namespace roomcast::simulator
