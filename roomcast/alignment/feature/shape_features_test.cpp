// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/feature/shape_features.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/views_fixture.h"

namespace roomcast::alignment {
namespace {

TEST(ShapeFeatures, are_histograms_of_what_bends) {
  const auto features = shape_features(first_corner().view->surface.samples);
  EXPECT_GT(features.size(), 20u);
  EXPECT_LT(features.size(), first_corner().view->surface.samples.size() / 2);
  for (const ShapeFeature& feature : features) {
    const auto& bins = feature.histogram;
    EXPECT_NEAR(std::accumulate(bins.begin(), bins.begin() + kShapeBins, 0.F), 1, 1e-3);
  }
}

TEST(ShapeFeatures, of_a_plane_are_none) {
  std::vector<SurfacePoint> flat;
  for (int i = 0; i < 2500; ++i) {
    flat.push_back(
        {{0.05F * static_cast<float>(i % 50), 0.05F * static_cast<float>(i / 50), 2}, {0, 0, -1}});
  }
  EXPECT_TRUE(shape_features(flat).empty());
  EXPECT_TRUE(shape_features({}).empty());
}

TEST(MatchShapes, finds_each_in_itself) {
  const auto features = shape_features(first_corner().view->surface.samples);
  const auto matches = match_shapes(features, features);
  const auto with_itself =
      std::count_if(matches.begin(), matches.end(), [](const auto& m) { return m.a == m.b; });
  EXPECT_GT(static_cast<std::size_t>(with_itself), features.size() * 9 / 10);
}

}  // namespace
}  // namespace roomcast::alignment
