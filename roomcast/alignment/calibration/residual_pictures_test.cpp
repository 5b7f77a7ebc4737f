// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/calibration/residual_pictures.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace roomcast::alignment::calibration {
namespace {

/// Counts the pixels that are neither background nor grey.
int colored(const ColorImage& picture) {
  return static_cast<int>(std::count_if(
      picture.data(), picture.data() + picture.view().pixel_count(), [](const Rgb8& p) {
        return std::max({p.r, p.g, p.b}) - std::min({p.r, p.g, p.b}) > 60;
      }));
}

TEST(ResidualPictures, larger_errors_make_longer_lines) {
  LensFit lens;
  lens.camera = {640, 480, 525, 525, 319.5, 239.5};
  for (int i = 0; i < 20; ++i) lens.errors.push_back({{30.0 * i + 20, 200}, {0, 0.05}});
  const int short_lines = colored(corner_error_picture(lens));
  for (CornerError& corner : lens.errors) corner.error_px.y() = 1;
  const int long_lines = colored(corner_error_picture(lens));
  EXPECT_GT(short_lines, 0);
  EXPECT_GT(long_lines, 3 * short_lines);
}

TEST(ResidualPictures, views_without_depth_are_left_out) {
  DepthFit depth;
  depth.views = {{0.8, 900, 12, 0.4, 2}, {1.4, 400, 20, -0.7, 3}};
  const int two = colored(depth_error_picture(depth));
  depth.views.push_back({});
  EXPECT_EQ(colored(depth_error_picture(depth)), two);
  depth.views.clear();
  EXPECT_LT(colored(depth_error_picture(depth)), two);
}

}  // namespace
}  // namespace roomcast::alignment::calibration
