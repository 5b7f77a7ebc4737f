// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/model_cells.h"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

namespace roomcast::render {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

/// Squares of 5 cm, 2 m before an eye at the origin that looks along -z; the one in the middle of
/// the picture is at x and y from 0 to 5 cm.
class ModelCellsTest : public testing::Test {
 protected:
  ModelCellsTest() {
    constexpr std::uint32_t kAcross = 41;
    for (std::uint32_t i = 0; i < kAcross * kAcross; ++i) {
      const std::uint32_t x = i % kAcross, y = i / kAcross;
      points_m_.emplace_back(0.05F * static_cast<float>(x) - 1, 0.05F * static_cast<float>(y) - 1,
                             -2);
      if (x == 0 || y == 0) continue;
      triangles_.push_back({i - kAcross - 1, i - kAcross, i});
      triangles_.push_back({i - kAcross - 1, i, i - 1});
    }
    eye_.width = eye_.height = 100;  // 43 pixels for each metre of the squares
    eye_.vertical_fov_rad = 1.716;
  }

  /// With a hole in these pixels only, counted from the left and from below.
  std::vector<ModelTriangle> near(const Eyes& eyes, const std::vector<Eigen::Vector2i>& holes_px) {
    const int width = eyes.count() * eyes.width();
    std::vector<float> depth(static_cast<std::size_t>(width * eyes.height()), 0.5F);
    for (const Eigen::Vector2i& at : holes_px)
      depth[static_cast<std::size_t>(at.y() * width + at.x())] = 1;
    HoleMap holes;
    holes.find(depth, width);
    std::vector<ModelTriangle> found;
    ModelCells(points_m_, triangles_).add_near_holes(eyes, holes, found);
    return found;
  }

  [[nodiscard]] bool surrounds(const ModelTriangle& triangle, float x_m, float y_m) const {
    Eigen::AlignedBox3f box_m;
    for (const std::uint32_t point : triangle) box_m.extend(points_m_[point]);
    return box_m.contains(Vector3f(x_m, y_m, -2));
  }

  std::vector<Vector3f> points_m_;
  std::vector<ModelTriangle> triangles_;
  ViewCamera eye_;
};

TEST_F(ModelCellsTest, a_hole_keeps_what_is_before_it_and_little_else) {
  const auto found = near(eye_, {{50, 50}});
  EXPECT_GE(std::ranges::count_if(
                found, [&](const auto& triangle) { return surrounds(triangle, 0.012F, 0.012F); }),
            2);
  EXPECT_LE(found.size(), 18U) << "the square and its neighbours";
  EXPECT_TRUE(near(eye_, {}).empty());
  EXPECT_TRUE(near(eye_, {{2, 50}}).empty()) << "there is no square there";
}

TEST_F(ModelCellsTest, everything_is_a_hole) {
  std::vector<Eigen::Vector2i> all_px;
  for (int i = 0; i < 100 * 100; ++i) all_px.emplace_back(i % 100, i / 100);
  auto found = near(eye_, all_px);
  std::ranges::sort(found);
  auto all = triangles_;
  std::ranges::sort(all);
  EXPECT_EQ(found, all);
  eye_.world_from_view.rotation = Eigen::AngleAxisd(std::numbers::pi, Vector3d::UnitY()).matrix();
  EXPECT_TRUE(near(eye_, all_px).empty()) << "behind the eye";
  eye_.world_from_view = world_from_view_looking_at({0, 0, -4}, {0, 0, -2});
  EXPECT_TRUE(near(eye_, all_px).empty()) << "backs";
}

TEST_F(ModelCellsTest, each_eye_has_holes_of_its_own) {
  ViewCamera away = eye_;
  away.world_from_view.rotation = Eigen::AngleAxisd(std::numbers::pi, Vector3d::UnitY()).matrix();
  EXPECT_FALSE(near(Eyes(away, eye_), {{150, 50}}).empty());
  EXPECT_FALSE(near(Eyes(eye_, away), {{50, 50}}).empty());
  EXPECT_TRUE(near(Eyes(away, eye_), {{50, 50}}).empty());
}

TEST_F(ModelCellsTest, what_reaches_behind_the_eye_is_kept) {
  points_m_ = {{-1, -1, -2}, {1, -1, -2}, {0, 1, 2}};
  triangles_ = {{0, 1, 2}};
  EXPECT_EQ(near(eye_, {{0, 0}}).size(), 1U);
}

}  // namespace
}  // namespace roomcast::render
