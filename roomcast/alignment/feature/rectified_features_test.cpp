// SPDX-License-Identifier: Apache-2.0
// A printed wall, seen straight on from two distances.
#include "roomcast/alignment/feature/rectified_features.h"

#include <cmath>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/feature_comparison.h"
#include "roomcast/alignment/feature/wall_fixture.h"

namespace roomcast::alignment {
namespace {

FeatureSet rectified_wall(const PrintedWall& wall) {
  const SensorView view = wall_view(wall, 0);
  return rectified_features(view.picture, view.surface, view.planes);
}

TEST(RectifiedFeatures, lie_on_the_plane_where_their_pixels_see_it) {
  const SensorView view = wall_view({}, 0);
  const FeatureSet set = rectified_features(view.picture, view.surface, view.planes);
  ASSERT_GT(set.size(), 50u);
  ASSERT_EQ(set.features.size(), set.descriptors.size());
  for (const Feature& feature : set.features) {
    EXPECT_NEAR(feature.point_m.z(), 2, 0.001);  // depth readings are whole millimetres
    EXPECT_LT((view.picture.pixel_of(feature.point_m) - feature.pixel).norm(), 0.2);
  }
}

TEST(RectifiedFeatures, have_the_same_size_in_metres_from_any_distance) {
  const FeatureSet near = rectified_wall({.z_m = 1.5}), far = rectified_wall({.z_m = 2});
  const auto matches = compare_features(near, far, 0.4F).matches;
  std::size_t right = 0, alike = 0;
  for (const DescriptorMatch& match : matches) {
    const Feature &here = near.features[match.a], &there = far.features[match.b];
    // Both sensors look at the wall's middle, so x and y are the same.
    if ((here.point_m - there.point_m).head<2>().norm() > 0.02F) continue;
    ++right;
    alike += std::abs(std::log2(here.size_m / there.size_m)) < 0.5F;
  }
  ASSERT_GT(right, 20u);
  EXPECT_GT(alike, right * 9 / 10);
}

TEST(RectifiedFeatures, are_as_large_as_what_is_printed) {
  // The print's cells are 6 cm; the smallest of its blobs are one cell, the largest some.
  for (const Feature& feature : rectified_wall({}).features) {
    EXPECT_GT(feature.size_m, 0.005F);
    EXPECT_LT(feature.size_m, 1);
  }
}

TEST(RectifiedFeatures, without_planes_are_none) {
  const SensorView view = wall_view({}, 0);
  EXPECT_EQ(rectified_features(view.picture, view.surface, {}).size(), 0u);
}

TEST(RectifiedFeatures, of_planes_of_a_few_centimetres_are_none) {
  const SensorView view = wall_view({}, 0);
  Plane scrap = view.planes.at(0);
  std::erase_if(scrap.points_m, [](const Eigen::Vector3f& point) {
    return point.head<2>().cwiseAbs().maxCoeff() > 0.05F;
  });
  ASSERT_FALSE(scrap.points_m.empty());
  EXPECT_EQ(rectified_features(view.picture, view.surface, {&scrap, 1}).size(), 0u);
}

}  // namespace
}  // namespace roomcast::alignment
