// SPDX-License-Identifier: Apache-2.0
#include "roomcast/align/view/color_picture.h"

#include <cmath>

#include <gtest/gtest.h>

#include "roomcast/align/made_up_room.h"
#include "roomcast/align/view/texture.h"

namespace roomcast::align {
namespace {

const RigidTransform kPose = corner_pose(2, 1.5);

struct Seen {
  CalibrationBundle bundle = made_up_bundle({}, "s", kPose);
  DepthSurface surface = depth_surface(bundle.depth_mm, bundle.calibration.depth);
  ColorPicture picture = color_picture(bundle.color, bundle.calibration, surface);
};

TEST(ColorPicture, lifts_a_pixel_to_the_surface_that_is_seen_there) {
  const Seen seen;
  int lifted = 0, on_surface = 0;
  for (int y = 20; y < 280; y += 13) {
    for (int x = 20; x < 380; x += 13) {
      const auto point = seen.picture.lift({x, y});
      if (!point) continue;
      ++lifted;
      const Eigen::Vector3d at = kPose * point->cast<double>();
      on_surface +=
          std::abs(cast_ray({}, kPose.translation_m, at - kPose.translation_m) - 1) < 0.01;
    }
  }
  EXPECT_GT(lifted, 250);
  EXPECT_GT(on_surface, 0.95 * lifted) << "the rest lies at edges that 3x3 pixels do not show";
}

TEST(ColorPicture, lifts_nothing_outside_or_without_depth) {
  Seen seen;
  EXPECT_FALSE(seen.picture.lift({-5, 10}).has_value());
  EXPECT_FALSE(seen.picture.lift({1e6F, 10}).has_value());
  seen.picture.z_m = Image<float>(seen.picture.z_m.width(), seen.picture.z_m.height());
  EXPECT_FALSE(seen.picture.lift({200, 150}).has_value());
}

TEST(ColorPicture, large_pictures_are_made_smaller_and_keep_their_geometry) {
  Seen seen;
  SensorCalibration large = seen.bundle.calibration;
  large.color = {2000, 1500, 1500, 1500, 999.5, 749.5};
  const ColorPicture picture =
      color_picture(ColorImage(2000, 1500, {9, 9, 9}), large, seen.surface);
  EXPECT_EQ(picture.grey.width(), 1000);
  EXPECT_FLOAT_EQ(picture.camera.fx, 750);
  EXPECT_FLOAT_EQ(picture.camera.cx, 499.5F);
  EXPECT_EQ(picture.grey.at(500, 300), 9);
}

TEST(Texture, knows_the_grey_of_every_point_it_holds) {
  const Seen seen;
  const Texture texture = make_texture(seen.surface, seen.picture);
  ASSERT_GT(texture.points.size(), 5000u);
  const auto mean_difference = [&](const Eigen::Vector3d& aside_m) {
    double sum = 0;
    for (const TexturedPoint& point : texture.points) {
      const Eigen::Vector3d at = kPose * point.point_m.cast<double>() + aside_m;
      sum += std::abs(double(point.grey) - pattern_grey({}, at));
    }
    return sum / double(texture.points.size());
  };
  EXPECT_LT(mean_difference({0, 0, 0}), 0.7 * mean_difference({0.3, 0.3, 0.3}));
}

}  // namespace
}  // namespace roomcast::align
