// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/board/tag_tracker.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "roomcast/alignment/board/tag_cells.h"
#include "roomcast/alignment/feature/room_fixture.h"

namespace roomcast::alignment {
namespace {

constexpr double kSide_m = 0.16;

/// A wall 4 m ahead and in front of it a white board with a tag in its middle.
class TagScene {
 public:
  explicit TagScene(const RigidTransform& depth_from_board) : depth_from_board_(depth_from_board) {
    calibration.depth = {320, 240, 290, 290, 159.5, 119.5, 0.05, -0.1};
    calibration.color = {960, 720, 850, 850, 479.5, 359.5, 0.01, -0.02};
    calibration.color_from_depth.translation_m = {-0.05, 0, 0};
    draw();
  }

  SensorCalibration calibration;
  DepthImage depth_mm;
  ColorImage color;

 private:
  /// The point where a ray meets the board, in the board's frame.
  [[nodiscard]] std::optional<Eigen::Vector3d> on_board(const RigidTransform& board_from_eye,
                                                        const Eigen::Vector3d& ray,
                                                        double& along) const {
    const Eigen::Vector3d way = board_from_eye.rotation * ray;
    along = -board_from_eye.translation_m.z() / way.z();
    const Eigen::Vector3d at = board_from_eye.translation_m + along * way;
    constexpr double kHalf = 0.75 * kSide_m;
    if (!(along > 0) || std::abs(at.x()) > kHalf || std::abs(at.y()) > kHalf) return std::nullopt;
    return at;
  }
  [[nodiscard]] std::uint8_t grey_at(const Eigen::Vector3d& at) const {
    const double cell = kSide_m / 8;
    const int column = static_cast<int>(std::floor(at.x() / cell + 5));
    const int row = static_cast<int>(std::floor(5 - at.y() / cell));
    const bool inside = column >= 0 && row >= 0 && column < 10 && row < 10;
    const bool white =
        !inside || cells_[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
    return white ? 220 : 20;
  }
  void draw() {
    constexpr double kWall_m = 4;
    const RigidTransform board_from_depth = depth_from_board_.inverse();
    const RigidTransform board_from_color =
        board_from_depth * calibration.color_from_depth.inverse();
    double along = 0;
    depth_mm.resize(calibration.depth.width, calibration.depth.height);
    const auto rays = ray_table(calibration.depth);
    for (int y = 0; y < depth_mm.height(); ++y) {
      for (int x = 0; x < depth_mm.width(); ++x) {
        const bool hit =
            on_board(board_from_depth, rays.at(x, y).cast<double>().homogeneous(), along)
                .has_value();
        depth_mm.at(x, y) = static_cast<std::uint16_t>(std::lround(1000 * (hit ? along : kWall_m)));
      }
    }
    color.resize(calibration.color.width, calibration.color.height);
    for (int y = 0; y < color.height(); ++y) {
      for (int x = 0; x < color.width(); ++x) {
        int sum = 0;  // over 3 x 3 rays per pixel
        for (int i = 0; i < 9; ++i) {
          const auto ray =
              unproject(calibration.color, {x + (i % 3 - 1) / 3.0, y + (i / 3 - 1) / 3.0}, 1);
          const auto at = ray ? on_board(board_from_color, *ray, along) : std::nullopt;
          sum += at ? grey_at(*at) : 120;
        }
        const auto grey = static_cast<std::uint8_t>(sum / 9);
        color.at(x, y) = {grey, grey, grey};
      }
    }
  }

  RigidTransform depth_from_board_;  // board: x right, y up, z towards the reader
  TagCells cells_ = *tag_cells(7);
};

RigidTransform held(double turn_rad, const Eigen::Vector3d& at_m) {
  RigidTransform pose;
  pose.rotation = (Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  pose.translation_m = at_m;
  return pose;
}

TEST(TagTracker, corners_of_a_tag_are_found_in_space) {
  for (const double turn_rad : {-0.7, 0.0, 0.5}) {
    const RigidTransform pose = held(turn_rad, {0.1, -0.2, 1.6});
    const TagScene scene(pose);
    TagTracker finder(scene.calibration);
    const auto tags = finder.find(scene.depth_mm.view(), scene.color.view());
    ASSERT_EQ(tags.size(), 1U) << turn_rad;
    EXPECT_EQ(tags[0].id, 7);
    constexpr double kHalf = kSide_m / 2;
    const std::array<Eigen::Vector3d, 4> printed = {
        Eigen::Vector3d(-kHalf, -kHalf, 0), Eigen::Vector3d(kHalf, -kHalf, 0),
        Eigen::Vector3d(kHalf, kHalf, 0), Eigen::Vector3d(-kHalf, kHalf, 0)};
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_LT((tags[0].corners_m[i] - pose * printed[i]).norm(), 0.003) << "corner " << i;
  }
}

TEST(TagTracker, a_tag_without_depth_is_left_out) {
  TagScene scene(held(0, {0, 0, 1.5}));
  scene.depth_mm = DepthImage(scene.depth_mm.width(), scene.depth_mm.height());
  TagTracker finder(scene.calibration);
  EXPECT_TRUE(finder.find(scene.depth_mm.view(), scene.color.view()).empty());
}

TEST(TagTracker, a_room_without_tags_has_none) {
  const auto bundle = bundle_fixture({}, "s0", corner_pose(2, 1.5));
  TagTracker finder(bundle.calibration);
  EXPECT_TRUE(finder.find(bundle.depth_mm.view(), bundle.color.view()).empty());
}

}  // namespace
}  // namespace roomcast::alignment
