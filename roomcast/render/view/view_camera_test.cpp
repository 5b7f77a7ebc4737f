// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/view/view_camera.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "roomcast/geometry/camera_model.h"

namespace roomcast::render {
namespace {

using Eigen::Vector3d;

constexpr double kRounding = 1e-6;  // of float matrices with values around 1

Eigen::Vector4d clip_of(const ViewCamera& camera, const Vector3d& in_view) {
  return clip_from_view(camera).cast<double>() * in_view.homogeneous();
}

TEST(ViewCamera, the_default_is_legal) {
  EXPECT_TRUE(ViewCamera{}.check().ok());
}

TEST(ViewCamera, corners_are_farther_from_the_middle_than_edges) {
  const ViewCamera square{
      .world_from_view = {}, .vertical_fov_rad = std::numbers::pi / 2, .width = 500, .height = 500};
  EXPECT_NEAR(view_angles(square).half_angle_rad, std::atan(std::sqrt(2.0)), kRounding);
  const ViewCamera wide{.world_from_view = {},
                        .vertical_fov_rad = std::numbers::pi / 2,
                        .width = 1000,
                        .height = 500};
  EXPECT_NEAR(view_angles(wide).half_angle_rad, std::atan(std::sqrt(5.0)), kRounding);
  EXPECT_NEAR(view_angles(wide).half_width_rad, std::atan(2.0), kRounding);
  EXPECT_NEAR(view_angles(wide).half_height_rad, std::numbers::pi / 4, kRounding);
}

TEST(ViewCamera, what_makes_no_sense_is_refused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](auto change) {
    ViewCamera camera;
    change(camera);
    const Status legal = camera.check();
    return !legal.ok() && legal.error().code == ErrorCode::kInvalidArgument;
  };
  EXPECT_TRUE(refused([](ViewCamera& c) { c.width = 0; }));
  EXPECT_TRUE(refused([](ViewCamera& c) { c.height = kMaxImageSide + 1; }));
  EXPECT_TRUE(refused([](ViewCamera& c) { c.vertical_fov_rad = std::numbers::pi; }));
  EXPECT_TRUE(refused([nan](ViewCamera& c) { c.vertical_fov_rad = nan; }));
  EXPECT_TRUE(refused([](ViewCamera& c) { c.near_m = 0; }));
  EXPECT_TRUE(refused([](ViewCamera& c) { c.far_m = c.near_m; }));
  EXPECT_TRUE(refused([](ViewCamera& c) { c.far_m = HUGE_VAL; }));
  EXPECT_TRUE(refused([nan](ViewCamera& c) { c.world_from_view.translation_m.x() = nan; }));
  EXPECT_TRUE(refused([nan](ViewCamera& c) { c.world_from_view.rotation(1, 1) = nan; }));
}

TEST(ViewCamera, half_the_field_of_view_lies_at_the_upper_edge) {
  ViewCamera camera;
  const double half = 0.5 * camera.vertical_fov_rad;
  const Eigen::Vector4d clip = clip_of(camera, {0, std::sin(half), -std::cos(half)});
  EXPECT_NEAR(clip.y() / clip.w(), 1, kRounding);
}

TEST(ViewCamera, near_and_far_are_the_ends_of_the_depth_range) {
  ViewCamera camera;
  const Eigen::Vector4d near = clip_of(camera, {0, 0, -camera.near_m});
  const Eigen::Vector4d far = clip_of(camera, {0, 0, -camera.far_m});
  EXPECT_NEAR(near.z() / near.w(), -1, kRounding);
  EXPECT_NEAR(far.z() / far.w(), 1, kRounding);
}

TEST(ViewCamera, looking_at_a_target_puts_it_straight_ahead_and_up_above) {
  const Vector3d eye(1, 1.6, 2), target(4, 0.5, -3);
  const RigidTransform view_from_world = world_from_view_looking_at(eye, target).inverse();
  const Vector3d seen = view_from_world * target;
  EXPECT_NEAR(seen.x(), 0, kRounding);
  EXPECT_NEAR(seen.y(), 0, kRounding);
  EXPECT_NEAR(seen.z(), -(target - eye).norm(), kRounding);
  EXPECT_GT((view_from_world * (target + Vector3d::UnitY())).y(), 0);
  EXPECT_NEAR((view_from_world * (target + Vector3d::UnitY())).x(), 0, kRounding);
}

}  // namespace
}  // namespace roomcast::render
