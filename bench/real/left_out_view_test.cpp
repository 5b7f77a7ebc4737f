// SPDX-License-Identifier: Apache-2.0
#include "bench/real/left_out_view.h"

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

CameraIntrinsics wide_lens() {
  CameraIntrinsics lens;
  lens.width = 160;
  lens.height = 120;
  lens.fx = 120;
  lens.fy = 118;
  lens.cx = 70;
  lens.cy = 66;
  lens.k1 = -0.1;
  return lens;
}

/// What an ideal pinhole sees of a target whose colour tells the ray: x and y in hundredths.
Image<float> picture_of_rays(const render::ViewCamera& view) {
  Image<float> image(view.width, view.height);
  const double focal_px = focal_length_px(view);
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      image.at(x, y) = static_cast<float>((x - 0.5 * (view.width - 1)) / focal_px);
    }
  }
  return image;
}

TEST(LeftOutViewTest, the_view_contains_every_ray_of_the_lens) {
  const CameraIntrinsics lens = wide_lens();
  const auto view = view_around(lens, {});
  ASSERT_TRUE(view.check().ok());
  const double focal_px = focal_length_px(view);
  EXPECT_NEAR(focal_px, 120, 1e-6);
  for (const auto& [x, y] : {std::pair{0, 0}, {159, 0}, {0, 119}, {159, 119}}) {
    const auto ray = undistort(lens, {(x - lens.cx) / lens.fx, (y - lens.cy) / lens.fy});
    ASSERT_TRUE(ray);
    EXPECT_LE(std::abs(ray->x()) * focal_px, 0.5 * view.width);
    EXPECT_LE(std::abs(ray->y()) * focal_px, 0.5 * view.height);
  }
}

TEST(LeftOutViewTest, a_drawn_picture_gets_the_distortion_of_the_lens) {
  const CameraIntrinsics lens = wide_lens();
  const auto view = view_around(lens, {});
  const Image<float> drawn = in_grid_of(lens, view, picture_of_rays(view));
  ASSERT_EQ(drawn.width(), lens.width);
  for (int y = 5; y < lens.height; y += 10) {
    for (int x = 5; x < lens.width; x += 10) {
      const auto ray = undistort(lens, {(x - lens.cx) / lens.fx, (y - lens.cy) / lens.fy});
      EXPECT_NEAR(drawn.at(x, y), ray->x(), 0.51 / 120) << x << ", " << y;
    }
  }
}

}  // namespace
}  // namespace roomcast::bench
