// SPDX-License-Identifier: Apache-2.0
#include "roomcast/model/spread_color.h"

#include <gtest/gtest.h>

#include "roomcast/model/volume_mesh.h"

namespace roomcast::model {
namespace {

/// A strip of `length` squares along x.
RoomMesh strip(std::uint32_t length) {
  RoomMesh mesh;
  for (std::uint32_t i = 0; i <= length; ++i) {
    mesh.points_m.emplace_back(float(i), 0.0F, 0.0F);
    mesh.points_m.emplace_back(float(i), 0.0F, 1.0F);
    if (i == length) break;
    const std::uint32_t at = 2 * i;
    mesh.triangles.push_back({at, at + 1, at + 2});
    mesh.triangles.push_back({at + 2, at + 1, at + 3});
  }
  mesh.colors.assign(mesh.points_m.size(), kNoColor);
  return mesh;
}

TEST(SpreadColor, bare_points_take_the_colours_around_them_and_others_keep_theirs) {
  RoomMesh mesh = strip(20);
  constexpr Rgb8 kRed = {200, 20, 20}, kBlue = {20, 20, 200};
  mesh.colors[0] = mesh.colors[1] = kRed;
  mesh.colors[40] = mesh.colors[41] = kBlue;
  spread_color(mesh);
  EXPECT_EQ(mesh.colors[0], kRed);
  EXPECT_EQ(mesh.colors[41], kBlue);
  EXPECT_EQ(mesh.colors[2].g, 20);
  EXPECT_GT(mesh.colors[4].r, mesh.colors[4].b);
  EXPECT_LT(mesh.colors[38].r, mesh.colors[38].b);
}

TEST(SpreadColor, without_any_colour_all_stays_as_it_is) {
  RoomMesh mesh = strip(3);
  spread_color(mesh);
  EXPECT_EQ(mesh.colors[0], kNoColor);
  RoomMesh both = strip(3);
  both.colors[0] = {1, 2, 3};
  both.points_m.emplace_back(9.0F, 9.0F, 9.0F);
  both.colors.push_back(kNoColor);
  spread_color(both);
  EXPECT_EQ(both.colors[7], (Rgb8{1, 2, 3}));
  EXPECT_EQ(both.colors.back(), kNoColor) << "it hangs together with nothing";
}

}  // namespace
}  // namespace roomcast::model
