// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/export/merged_cloud.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "roomcast/recording/export/wall_fixture.h"

namespace roomcast::recording {
namespace {

constexpr std::size_t kOfOneSensor = 62 * 46;  // all pixels but the picture's border

PointCloud merged(const MergedCloudOptions& options) {
  MergedCloud merge(wall_sensors(), options);
  PointCloud cloud;
  merge.merge(wall_set(), cloud);
  return cloud;
}

TEST(MergedCloud, a_common_surface_is_kept_once_from_the_sensor_that_sees_it_better) {
  const PointCloud cloud = merged({});
  EXPECT_LT(cloud.size(), 2 * kOfOneSensor);
  const auto red = static_cast<std::size_t>(std::ranges::count(cloud.colors, Rgb8{200, 0, 0}));
  EXPECT_EQ(red, kOfOneSensor);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    EXPECT_NEAR(cloud.points_m[i].z(), -2, 1e-5);
    EXPECT_NEAR(cloud.normals[i].z(), 1, 1e-4);
    // The near sensor sees a metre to each side of x = 0, and 0.77 m above and below y = 1.
    if (cloud.colors[i].g == 0) continue;
    const bool inside =
        std::abs(cloud.points_m[i].x()) < 0.95F && std::abs(cloud.points_m[i].y() - 1) < 0.7F;
    EXPECT_FALSE(inside) << cloud.points_m[i].transpose();
  }
}

TEST(MergedCloud, keeps_duplicates_on_request) {
  EXPECT_EQ(merged({.crop_m = {}, .voxel_m = 0, .keep_doubles = true}).size(), 2 * kOfOneSensor);
}

TEST(MergedCloud, crops_to_a_box) {
  const Eigen::AlignedBox3f box(Eigen::Vector3f(-0.5F, 0.5F, -3), Eigen::Vector3f(0.5F, 1.5F, 0));
  const PointCloud cloud = merged({.crop_m = box, .voxel_m = 0, .keep_doubles = false});
  EXPECT_GT(cloud.size(), 500u);
  for (const auto& point : cloud.points_m) EXPECT_TRUE(box.contains(point));
}

TEST(MergedCloud, thins_out_to_one_point_for_each_cube) {
  const PointCloud cloud = merged({.crop_m = {}, .voxel_m = 0.25F, .keep_doubles = false});
  EXPECT_LT(cloud.size(), 300u);  // of 4.3 m x 3.2 m
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    EXPECT_NEAR(cloud.normals[i].norm(), 1, 1e-5);
    for (std::size_t j = 0; j < i; ++j) {
      const auto cell = [](const Eigen::Vector3f& p) {
        return Eigen::Vector3i((p / 0.25F).array().floor().cast<int>());
      };
      EXPECT_NE(cell(cloud.points_m[i]), cell(cloud.points_m[j]));
    }
  }
}

TEST(MergedCloud, unplaced_sensors_are_left_out) {
  MergedCloud merge(wall_sensors(), {});
  FrameSet set = wall_set();
  set.frames[1].world_from_depth.reset();
  PointCloud cloud;
  merge.merge(set, cloud);
  EXPECT_EQ(cloud.size(), kOfOneSensor);
  set.frames.erase(set.frames.begin());
  merge.merge(set, cloud);
  EXPECT_EQ(cloud.size(), kOfOneSensor) << "a single one needs no place";
}

TEST(MergedCloud, refuses_options_that_make_no_sense) {
  EXPECT_FALSE(
      (MergedCloudOptions{.crop_m = Eigen::AlignedBox3f(), .voxel_m = 0, .keep_doubles = false})
          .check()
          .ok());
  EXPECT_FALSE(
      (MergedCloudOptions{.crop_m = {}, .voxel_m = -1, .keep_doubles = false}).check().ok());
  EXPECT_TRUE(MergedCloudOptions().check().ok());
}

}  // namespace
}  // namespace roomcast::recording
