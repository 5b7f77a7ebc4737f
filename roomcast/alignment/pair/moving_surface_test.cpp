// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/moving_surface.h"

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/walk_views_fixture.h"

namespace roomcast::alignment {
namespace {

TEST(MovingSurface, is_the_walker_and_faces_the_sensor) {
  const RigidTransform pose = corner_pose(2, 1.5);
  const auto view = walk_view({}, "a", pose);
  const auto surfaces = moving_surfaces(*view);
  ASSERT_EQ(surfaces.size(), std::size_t(kWalkInstants));
  std::size_t points = 0;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    EXPECT_EQ(surfaces[i].time_s, view->instants[i].time_s);
    const double x_m = -1.2 + 0.3 * static_cast<double>(i);  // of the walker, 0.3 m thick
    for (const Eigen::Vector2i& block : surfaces[i].blocks) {
      const SurfacePoint& point = surfaces[i].at.at(block.x(), block.y());
      const Eigen::Vector3d in_world = pose * point.point_m.cast<double>();
      EXPECT_NEAR(in_world.x(), x_m, 0.2);
      EXPECT_NEAR(in_world.z(), 1, 0.2);
      EXPECT_LT(point.normal.dot(point.point_m), 0);
      ++points;
    }
  }
  EXPECT_GT(points, 200u);
}

TEST(MovingSurface, nothing_where_nothing_moves) {
  SensorView view = *walk_view({}, "a", corner_pose(2, 1.5));
  for (DepthInstant& instant : view.instants)
    instant.moving = MaskImage(instant.moving.width(), instant.moving.height());
  for (const MovingSurface& surface : moving_surfaces(view)) EXPECT_TRUE(surface.blocks.empty());
}

}  // namespace
}  // namespace roomcast::alignment
