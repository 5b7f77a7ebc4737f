// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/view/flat_normals.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

const Plane kWall{{0, 0, -1}, 2, {}};  // two metres ahead

SurfacePoint point(float z_m, float tilt_rad) {
  return {{0.1F, 0.2F, z_m}, {std::sin(tilt_rad), 0, -std::cos(tilt_rad)}};
}

/// A surface whose picture is one row of these points.
DepthSurface surface_of(const std::vector<SurfacePoint>& points) {
  DepthSurface surface{{}, Lens(CameraIntrinsics{}), {}, {}, {}, points};
  surface.at.resize(static_cast<int>(points.size()), 1);
  for (std::size_t i = 0; i < points.size(); ++i) surface.at.at(static_cast<int>(i), 0) = points[i];
  return surface;
}

/// The normal of a point after flattening; the same in the picture and among the samples.
Eigen::Vector3f flattened(const SurfacePoint& point) {
  DepthSurface surface = surface_of({point});
  flatten_normals(std::vector{kWall}, surface);
  EXPECT_EQ(surface.at.at(0, 0).normal, surface.samples[0].normal);
  EXPECT_EQ(surface.samples[0].point_m, point.point_m) << "what was measured stays";
  return surface.samples[0].normal;
}

TEST(FlatNormals, what_lies_on_a_plane_is_as_flat_as_the_plane) {
  EXPECT_EQ(flattened(point(2, 0.15F)), kWall.normal);
  EXPECT_EQ(flattened(point(2.015F, -0.1F)), kWall.normal);
}

TEST(FlatNormals, what_lies_before_a_plane_or_is_tilted_stays_as_it_is) {
  for (const SurfacePoint& other : {point(1.9F, 0.1F), point(2, 0.3F), point(2, 1.5F)})
    EXPECT_EQ(flattened(other), other.normal);
}

TEST(FlatNormals, where_the_surface_is_not_smooth_there_is_no_normal) {
  EXPECT_TRUE(flattened({{0, 0, 2}, Eigen::Vector3f::Zero()}).isZero());
}

}  // namespace
}  // namespace roomcast::alignment
