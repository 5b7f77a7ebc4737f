// SPDX-License-Identifier: Apache-2.0
#include "roomcast/align/pair/shape_hypotheses.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "roomcast/align/feature/shape_features.h"
#include "roomcast/align/made_up_views.h"
#include "roomcast/align/pair/pose_difference.h"

namespace roomcast::align {
namespace {

const MadeUpView& beside() {
  static const MadeUpView view =
      made_up_view({}, "beside", world_from_optical_looking_at({1.2, 1.9, 1.6}, {-0.3, 0.4, -0.3}));
  return view;
}

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

TEST(ShapeHypotheses, hold_the_true_pose_without_any_colour) {
  const auto found = hypotheses_by_shape(first_corner().view->surface, beside().view->surface);
  const RigidTransform truth = true_pose(first_corner(), beside());
  EXPECT_TRUE(std::any_of(found.begin(), found.end(), [&](const PoseHypothesis& hypothesis) {
    const auto apart = difference(hypothesis.a_from_b, truth);
    return apart.angle_rad < 0.1 && apart.distance_m < 0.15;
  }));
}

}  // namespace
}  // namespace roomcast::align
