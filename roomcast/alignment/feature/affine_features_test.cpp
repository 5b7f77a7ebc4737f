// SPDX-License-Identifier: Apache-2.0
// A small colour camera that looks straight at a printed wall: affine features take long.
#include "roomcast/alignment/feature/affine_features.h"

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/picture_features.h"
#include "roomcast/alignment/feature/repeats.h"
#include "roomcast/alignment/feature/wall_fixture.h"

namespace roomcast::alignment {
namespace {

/// Colour 100 x 80 of a wall 2 m ahead.
struct SmallPicture {
  DepthSurface surface;
  ColorPicture picture;

  explicit SmallPicture(const DepthImage& depth_mm = wall_depth(2))
      : surface(wall_surface(depth_mm)), picture(make()) {}

  ColorPicture make() const {
    SensorCalibration calibration = wall_calibration();
    calibration.color = {100, 80, 72.5, 72.5, 49.5, 39.5};
    const PrintedWall wall{};
    ColorImage color(100, 80);
    for (int v = 0; v < 80; ++v) {
      for (int u = 0; u < 100; ++u) {
        // Cells of 6 cm would be two pixels: the print is taken three times as coarse.
        const std::uint8_t grey =
            wall.grey_at((u - 49.5) / 72.5 * 2 / 3, (v - 39.5) / 72.5 * 2 / 3);
        color.at(u, v) = {grey, grey, grey};
      }
    }
    return color_picture(color, calibration, surface);
  }
};

TEST(AffineFeatures, are_more_than_those_of_the_picture_and_lie_on_the_surface) {
  const SmallPicture seen;
  const FeatureSet set = affine_features(seen.picture, seen.surface);
  EXPECT_GT(set.size(), 3 * picture_features(seen.picture, seen.surface).size());
  ASSERT_EQ(set.features.size(), set.descriptors.size());
  for (const Feature& feature : set.features) {
    EXPECT_NEAR(feature.point_m.z(), 2, 0.001);
    EXPECT_LT((seen.picture.pixel_of(feature.point_m) - feature.pixel).norm(), 0.1);
    EXPECT_EQ(feature.size_m, 0);  // in pixels of a tilted view: no size in metres
  }
}

TEST(AffineFeatures, know_their_look_alikes) {
  const SmallPicture seen;
  FeatureSet set = affine_features(seen.picture, seen.surface);
  ASSERT_GT(set.size(), 0u);
  std::vector<float> known;
  for (Feature& feature : set.features) {
    known.push_back(feature.nearest_similar_distance);
    feature.nearest_similar_distance = -1;
  }
  compute_ambiguity(set);
  for (std::size_t i = 0; i < set.size(); ++i)
    EXPECT_EQ(known[i], set.features[i].nearest_similar_distance);
}

TEST(AffineFeatures, without_depth_are_none) {
  const SmallPicture unmeasured(DepthImage(200, 160));
  EXPECT_EQ(affine_features(unmeasured.picture, unmeasured.surface).size(), 0u);
}

}  // namespace
}  // namespace roomcast::alignment
