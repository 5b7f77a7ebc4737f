// SPDX-License-Identifier: Apache-2.0
// A wall seen straight on.
#include "roomcast/alignment/view/texture.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/wall_fixture.h"

namespace roomcast::alignment {
namespace {

/// Depth and colour of a wall 2 m ahead.
struct TexturedWall {
  DepthSurface surface = wall_surface(wall_depth(2));
  ColorPicture picture;
  Texture texture;

  explicit TexturedWall(const ColorImage& color, const SensorCalibration& calibration)
      : picture(color_picture(color, calibration, surface)),
        texture(make_texture(surface, picture)) {}
  explicit TexturedWall(const ColorImage& color) : TexturedWall(color, wall_calibration()) {}
};

ColorImage plain_color(Rgb8 color) {
  return {400, 320, color};
}

TEST(TextureOfAWall, has_every_second_point_of_the_depth_picture_row_by_row) {
  const TexturedWall wall(plain_color({90, 90, 90}));
  EXPECT_EQ(wall.texture.width, 100);
  EXPECT_EQ(wall.texture.height, 80);
  // The colour picture's rim of four pixels is two depth pixels wide: one grid point on each side.
  EXPECT_EQ(wall.texture.points.size(), std::size_t(98 * 78));
  for (std::size_t i = 0; i < wall.texture.points.size(); ++i) {
    const TexturedPoint& point = wall.texture.points[i];
    EXPECT_EQ(point.x, 1 + static_cast<int>(i % 98));
    EXPECT_EQ(point.y, 1 + static_cast<int>(i / 98));
    EXPECT_EQ(point.point_m, wall.surface.at.at(2 * point.x, 2 * point.y).point_m);
    EXPECT_NEAR(point.grey, 90, 0.01F);  // a plain picture stays as it is when blurred
  }
}

TEST(TextureOfAWall, is_blurred_evenly) {
  // One bright column: the blur spreads its 200 levels but keeps their sum.
  ColorImage color = plain_color({0, 0, 0});
  for (int y = 0; y < color.height(); ++y) color.at(200, y) = {200, 200, 200};
  const TexturedWall wall(color);
  float sum = 0;
  for (int x = 195; x <= 205; ++x) sum += wall.texture.soft_grey.at(x, 160);
  EXPECT_NEAR(sum, 200, 0.1F);
  EXPECT_EQ(wall.texture.soft_grey.at(195, 160), 0);  // beyond the blur's reach
  EXPECT_GT(wall.texture.soft_grey.at(196, 160), 0);
  EXPECT_FLOAT_EQ(wall.texture.soft_grey.at(198, 160), wall.texture.soft_grey.at(202, 160));
  EXPECT_GT(wall.texture.soft_grey.at(200, 160), wall.texture.soft_grey.at(199, 160));
}

TEST(TextureOfAWall, has_no_grey_outside_the_picture_or_at_its_rim) {
  const TexturedWall wall(plain_color({90, 90, 90}));
  EXPECT_TRUE(texture_grey(wall.texture, {4, 4}).has_value());
  EXPECT_TRUE(texture_grey(wall.texture, {395, 315}).has_value());
  for (const Eigen::Vector2f& pixel :
       {Eigen::Vector2f(3.9F, 100), Eigen::Vector2f(100, 3.9F), Eigen::Vector2f(395.1F, 100),
        Eigen::Vector2f(100, 315.1F), Eigen::Vector2f(-5, 100), Eigen::Vector2f(1e6F, 100)}) {
    EXPECT_FALSE(texture_grey(wall.texture, pixel).has_value()) << pixel.transpose();
    EXPECT_FALSE(texture_tint(wall.texture, pixel).has_value()) << pixel.transpose();
  }
}

TEST(TextureOfAWall, knows_hues_from_greys) {
  EXPECT_FALSE(TexturedWall(plain_color({90, 90, 90})).texture.has_hues);
  const TexturedWall reddish(plain_color({110, 90, 90}));
  EXPECT_TRUE(reddish.texture.has_hues);
  EXPECT_NEAR(*texture_tint(reddish.texture, {200, 160}), kNoTint + 10, 0.5F);
  EXPECT_FALSE(TexturedWall(plain_color({94, 90, 90})).texture.has_hues);  // two levels: a cast
}

TEST(TextureOfAWall, leaves_out_what_the_colour_camera_does_not_see) {
  // The colour camera is 40 cm to the left. A post 1 m ahead hides from it another part of the wall
  // than from the depth camera.
  SensorCalibration calibration = wall_calibration();
  calibration.color_from_depth.translation_m.x() = 0.4;
  DepthImage depth_mm = wall_depth(2);
  for (int y = 0; y < depth_mm.height(); ++y) {
    for (int x = 90; x < 110; ++x) depth_mm.at(x, y) = 1000;
  }
  const DepthSurface surface = wall_surface(depth_mm);
  const ColorPicture picture = color_picture(plain_color({90, 90, 90}), calibration, surface);
  const Texture texture = make_texture(surface, picture);
  // The post spans -0.066..0.066 m at 1 m. Seen from x = -0.4 m, it hides 0.27..0.53 m at 2 m,
  // which depth sees at pixels 119 to 138.
  const auto has_depth_column = [&](int x) {
    return std::ranges::any_of(texture.points,
                               [&](const TexturedPoint& point) { return 2 * point.x == x; });
  };
  EXPECT_TRUE(has_depth_column(100));  // the post
  EXPECT_TRUE(has_depth_column(114));
  for (int x = 122; x <= 136; x += 2) EXPECT_FALSE(has_depth_column(x)) << x;
  EXPECT_TRUE(has_depth_column(142));
}

TEST(TextureOfAWall, without_depth_has_no_points) {
  const DepthSurface surface = wall_surface(DepthImage(200, 160));
  const ColorPicture picture =
      color_picture(plain_color({90, 90, 90}), wall_calibration(), surface);
  EXPECT_TRUE(make_texture(surface, picture).points.empty());
}

}  // namespace
}  // namespace roomcast::alignment
