// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/view/color_picture.h"

#include <cmath>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/room_fixture.h"
#include "roomcast/alignment/view/seen_corner_fixture.h"
#include "roomcast/alignment/view/texture.h"

namespace roomcast::alignment {
namespace {

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
  EXPECT_EQ(picture.tint.at(500, 300), 128);
}

TEST(ColorPicture, tint_tells_red_from_green) {
  Seen seen;
  const auto tint_of = [&](Rgb8 color) {
    const auto& camera = seen.bundle.calibration.color;
    return color_picture(ColorImage(camera.width, camera.height, color), seen.bundle.calibration,
                         seen.surface)
        .tint.at(camera.width / 2, camera.height / 2);
  };
  EXPECT_EQ(tint_of({140, 40, 60}), 178);
  EXPECT_EQ(tint_of({20, 100, 60}), 88);
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
}  // namespace roomcast::alignment
