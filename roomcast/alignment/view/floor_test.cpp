// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/view/floor.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

constexpr float kFloorDegree = static_cast<float>(M_PI) / 180;

/// A plane `height_m` below a camera that looks down by `down_rad`, with `size` points.
Plane plane_below(float height_m, float down_rad, std::size_t size = 100) {
  return {{0, -std::cos(down_rad), -std::sin(down_rad)},
          height_m,
          std::vector<Eigen::Vector3f>(size, Eigen::Vector3f::Zero())};
}

/// `count` samples at `height_m` above a plane.
std::vector<SurfacePoint> samples_above(const Plane& plane, float height_m, std::size_t count) {
  const Eigen::Vector3f point = (height_m - plane.offset_m) * plane.normal;
  return std::vector<SurfacePoint>(count, {point, plane.normal});
}

/// A single sample, at the camera.
const std::vector<SurfacePoint> kNothingBelow = {
    {Eigen::Vector3f::Zero(), -Eigen::Vector3f::UnitZ()}};

std::optional<Plane> floor_of(const std::vector<Plane>& planes,
                              const std::vector<SurfacePoint>& samples = kNothingBelow,
                              const std::optional<Eigen::Vector3d>& up = std::nullopt) {
  return find_floor(planes, samples, up);
}

TEST(FoundFloor, is_the_plane_that_faces_up_without_its_points) {
  const Plane floor = plane_below(1.5F, 0.4F);
  const Plane wall{{0, 0, -1}, 3, std::vector<Eigen::Vector3f>(1000)};
  const auto found = floor_of({wall, floor});
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->normal, floor.normal);
  EXPECT_EQ(found->offset_m, 1.5F);
  EXPECT_TRUE(found->points_m.empty());
}

TEST(FoundFloor, is_none_without_planes_that_face_up) {
  EXPECT_FALSE(floor_of({}).has_value());
  EXPECT_FALSE(floor_of({{{0, 0, -1}, 3, {}}}).has_value());
  EXPECT_FALSE(floor_of({{{0, 1, 0}, 1, {}}}).has_value());  // the ceiling
}

TEST(FoundFloor, may_be_seen_by_a_camera_that_looks_down_by_less_than_sixty_degrees) {
  EXPECT_TRUE(floor_of({plane_below(1.5F, 59 * kFloorDegree)}).has_value());
  EXPECT_FALSE(floor_of({plane_below(1.5F, 61 * kFloorDegree)}).has_value());
}

TEST(FoundFloor, follows_gravity_where_it_is_measured) {
  const Plane steep = plane_below(1.5F, 75 * kFloorDegree), level = plane_below(1.5F, 0, 1000);
  const Eigen::Vector3d up = steep.normal.cast<double>();
  const auto found = floor_of({level, steep}, kNothingBelow, up);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->normal, steep.normal);
  // Within 14 degrees of gravity.
  EXPECT_TRUE(floor_of({plane_below(1.5F, 62 * kFloorDegree)}, kNothingBelow, up).has_value());
  EXPECT_FALSE(floor_of({plane_below(1.5F, 60 * kFloorDegree)}, kNothingBelow, up).has_value());
}

TEST(FoundFloor, is_not_what_is_right_below_the_camera) {
  EXPECT_FALSE(floor_of({plane_below(0.29F, 0.4F)}).has_value());  // the shelf it stands on
  EXPECT_TRUE(floor_of({plane_below(0.31F, 0.4F)}).has_value());
}

TEST(FoundFloor, is_not_a_table_below_which_more_is_seen) {
  const Plane table = plane_below(0.8F, 0.4F);
  auto samples = samples_above(table, 0, 96);
  const auto below = samples_above(table, -0.7F, 4);  // 4 %; 3 % are taken for noise
  samples.insert(samples.end(), below.begin(), below.end());
  EXPECT_FALSE(floor_of({table}, samples).has_value());
  samples.pop_back();
  samples.pop_back();
  EXPECT_TRUE(floor_of({table}, samples).has_value());
}

TEST(FoundFloor, may_be_uneven_by_some_centimetres) {
  const Plane floor = plane_below(1.5F, 0.4F);
  EXPECT_TRUE(floor_of({floor}, samples_above(floor, -0.07F, 100)).has_value());
  EXPECT_FALSE(floor_of({floor}, samples_above(floor, -0.09F, 100)).has_value());
}

TEST(FoundFloor, is_the_largest_of_several) {
  const auto found = floor_of(
      {plane_below(1.5F, 0.4F, 100), plane_below(1.52F, 0.4F, 300), plane_below(1.54F, 0.4F, 200)});
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->offset_m, 1.52F);
}

}  // namespace
}  // namespace roomcast::alignment
