// SPDX-License-Identifier: Apache-2.0
#include "bench/line/viewer_path.h"

#include <fstream>

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

using namespace std::chrono_literals;

std::filesystem::path written(const std::string& text) {
  const auto file = std::filesystem::path(testing::TempDir()) / "path.txt";
  std::ofstream(file) << text;
  return file;
}

TEST(ViewerPath, unitys_poses_become_right_handed) {
  const auto path = ViewerPath::read(
      written("1689344673, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1\n"
              "68, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0\n"
              "100, 1, 1.7, 2, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0\n"
              "300, 1, 1.7, 4, 0, 90, 0, 0, 0.7, 0, 0.7, 1, 0, 0, 0, 1, 0\n"));
  ASSERT_TRUE(path.ok()) << path.error().message;
  EXPECT_EQ(path->length(), 200ms);
  EXPECT_LT((path->at(0ms).translation_m - Eigen::Vector3d(1, 1.7, -2)).norm(), 1e-9);
  EXPECT_LT((path->at(0ms).rotation - Eigen::Matrix3d::Identity()).norm(), 1e-9)
      << "Unity's z is ahead, ours -z";
  EXPECT_LT((path->at(100ms).translation_m - Eigen::Vector3d(1, 1.7, -3)).norm(), 1e-9);
  EXPECT_LT((-path->at(200ms).rotation.col(2) - Eigen::Vector3d(1, 0, 0)).norm(), 1e-9)
      << "turned to the right";
  EXPECT_LT((path->at(300ms).translation_m - Eigen::Vector3d(1, 1.7, -3)).norm(), 1e-9)
      << "and back";
}

TEST(ViewerPath, a_file_without_poses_is_refused) {
  EXPECT_EQ(ViewerPath::read(written("no path\n1, 2, 3\n")).error().code, ErrorCode::kMalformed);
  EXPECT_EQ(ViewerPath::read("/nonexistent/path").error().code, ErrorCode::kNotFound);
}

TEST(ViewerPath, can_be_moved_to_what_is_to_be_looked_at) {
  const ViewerPath path = ViewerPath::round_walk(2, 30s).around({5, 7});
  for (const auto time : {0s, 4s, 11s}) {
    const Eigen::Vector3d eye_m = path.at(time).translation_m;
    EXPECT_NEAR((Eigen::Vector2d(eye_m.x(), eye_m.z()) - Eigen::Vector2d(5, 7)).norm(), 2, 0.3);
  }
}

TEST(ViewerPath, the_place_nearest_to_all_rays_is_where_they_meet) {
  EXPECT_LT((nearest_to_all({{{0, 0}, {1, 1}}, {{2, 0}, {0, 3}}}) - Eigen::Vector2d(2, 2)).norm(),
            1e-9);
  EXPECT_EQ(nearest_to_all({{{0, 1}, {1, 0}}, {{0, 2}, {1, 0}}}), Eigen::Vector2d(0, 0));
  EXPECT_EQ(nearest_to_all({}), Eigen::Vector2d(0, 0));
}

}  // namespace
}  // namespace roomcast::bench
