// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/view/surface_view.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace roomcast::render {
namespace {

using Eigen::Vector3d;

const RigidTransform kSomewhere =
    world_from_view_looking_at(Vector3d(1, 1.6, 2), Vector3d(4, 0.5, -3));

TEST(SurfaceView, the_matrix_of_a_transform_moves_points_as_it_does) {
  const Vector3d point(0.3, -2, 5);
  const Eigen::Vector3f moved =
      (matrix_from_transform(kSomewhere) * point.cast<float>().homogeneous()).hnormalized();
  EXPECT_LT((moved.cast<double>() - kSomewhere * point).norm(), 1e-6 * point.norm());
}

// A kilometre from the origin single precision resolves only 0.06 mm. Surfaces near the eye must
// stay precise.
TEST(SurfaceView, keeps_its_precision_far_from_the_origin) {
  RigidTransform far_away = kSomewhere;
  far_away.translation_m += Vector3d(1000.123, 0, -1000.456);
  ViewCamera camera;
  camera.world_from_view = far_away;
  const RigidTransform depth_in_view{Eigen::Matrix3d::Identity(), Vector3d(0.1, 0.2, -0.3)};
  const SurfaceView view = surface_view(SensorId{3}, far_away * depth_in_view, camera);
  EXPECT_EQ(view.sensor, SensorId{3});
  EXPECT_LT((view.view_from_depth[0] - matrix_from_transform(depth_in_view)).norm(), 1e-6);
}

}  // namespace
}  // namespace roomcast::render
