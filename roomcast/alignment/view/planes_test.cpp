// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/view/planes.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

/// `count` samples of a plane, in rows of ten, 5 cm apart, around its point nearest the camera.
std::vector<SurfacePoint> sampled_plane(const Eigen::Vector3f& normal, float distance_m,
                                        std::size_t count) {
  const Eigen::Vector3f across = normal.unitOrthogonal(), along = normal.cross(across);
  std::vector<SurfacePoint> samples;
  for (std::size_t i = 0; i < count; ++i) {
    const float x = 0.05F * static_cast<float>(i % 10), y = 0.05F * static_cast<float>(i / 10);
    samples.push_back({-distance_m * normal + x * across + y * along, normal});
  }
  return samples;
}

std::vector<SurfacePoint> samples_of_both(std::vector<SurfacePoint> one,
                                          const std::vector<SurfacePoint>& other) {
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

const Eigen::Vector3f kTowardsCamera = -Eigen::Vector3f::UnitZ();
const Eigen::Vector3f kUpInPicture = -Eigen::Vector3f::UnitY();

TEST(FoundPlanes, come_with_normal_distance_and_points_the_largest_first) {
  const auto planes = find_planes(samples_of_both(sampled_plane(kUpInPicture, 1.5F, 200),
                                                  sampled_plane(kTowardsCamera, 2, 500)));
  ASSERT_EQ(planes.size(), 2u);
  EXPECT_LT((planes[0].normal - kTowardsCamera).norm(), 1e-4F);
  EXPECT_NEAR(planes[0].offset_m, 2, 1e-4);
  EXPECT_EQ(planes[0].points_m.size(), 500u);
  EXPECT_LT((planes[1].normal - kUpInPicture).norm(), 1e-4F);
  EXPECT_NEAR(planes[1].offset_m, 1.5, 1e-4);
  EXPECT_EQ(planes[1].points_m.size(), 200u);
  EXPECT_NEAR(planes[0].height_m({0.3F, 0.1F, 1.4F}), 0.6F, 1e-4F);  // in front of the wall
}

TEST(FoundPlanes, both_sides_of_a_thin_board_are_two) {
  const auto planes = find_planes(samples_of_both(sampled_plane(kTowardsCamera, 2, 200),
                                                  sampled_plane(-kTowardsCamera, -2, 150)));
  ASSERT_EQ(planes.size(), 2u);
  EXPECT_EQ(planes[0].points_m.size(), 200u);
  EXPECT_EQ(planes[1].points_m.size(), 150u);
}

TEST(FoundPlanes, walls_ten_centimetres_apart_are_two) {
  // Points within 2.5 cm belong to a plane.
  const auto planes = find_planes(samples_of_both(sampled_plane(kTowardsCamera, 2, 200),
                                                  sampled_plane(kTowardsCamera, 2.1F, 150)));
  ASSERT_EQ(planes.size(), 2u);
  EXPECT_NEAR(planes[0].offset_m, 2, 1e-4);
  EXPECT_NEAR(planes[1].offset_m, 2.1, 1e-4);
}

TEST(FoundPlanes, are_fitted_to_all_their_points) {
  // Readings alternate by 1 cm before and behind the wall, the first by itself would be off by one.
  auto samples = sampled_plane(kTowardsCamera, 2, 400);
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i].point_m.z() += (i + i / 10) % 2 == 0 ? 0.01F : -0.01F;
  const auto planes = find_planes(samples);
  ASSERT_EQ(planes.size(), 1u);
  EXPECT_NEAR(planes[0].offset_m, 2, 0.001);
  EXPECT_GT(planes[0].normal.dot(kTowardsCamera), std::cos(0.005F));
}

TEST(FoundPlanes, smaller_than_a_share_of_the_view_are_dropped) {
  // 60 of 2060 samples are 2.9 %, 70 of 2070 are 3.4 %; the least share is 3 %.
  const auto wall = sampled_plane(kTowardsCamera, 2, 2000);
  EXPECT_EQ(find_planes(samples_of_both(wall, sampled_plane(kUpInPicture, 1, 60))).size(), 1u);
  EXPECT_EQ(find_planes(samples_of_both(wall, sampled_plane(kUpInPicture, 1, 70))).size(), 2u);
}

TEST(FoundPlanes, are_none_where_samples_are_few) {
  EXPECT_TRUE(find_planes(sampled_plane(kTowardsCamera, 2, 49)).empty());
  EXPECT_EQ(find_planes(sampled_plane(kTowardsCamera, 2, 50)).size(), 1u);
}

TEST(FoundPlanes, are_at_most_eight) {
  std::vector<SurfacePoint> stairs;
  for (int i = 0; i < 10; ++i)
    stairs = samples_of_both(stairs,
                             sampled_plane(kTowardsCamera, 1 + 0.2F * static_cast<float>(i), 100));
  EXPECT_EQ(find_planes(stairs).size(), PlaneOptions{}.max_planes);
}

}  // namespace
}  // namespace roomcast::alignment
