// SPDX-License-Identifier: Apache-2.0
#include "roomcast/align/feature/picture_features.h"

#include <gtest/gtest.h>

#include "roomcast/align/feature/feature_comparison.h"
#include "roomcast/align/feature/rectified_features.h"
#include "roomcast/align/feature/sift_detector.h"
#include "roomcast/align/made_up_room.h"
#include "roomcast/align/view/planes.h"

namespace roomcast::align {
namespace {

struct Seen {
  explicit Seen(const RigidTransform& pose)
      : world_from_depth(pose),
        bundle(made_up_bundle({}, "s", pose)),
        surface(depth_surface(bundle.depth_mm, bundle.calibration.depth)),
        picture(color_picture(bundle.color, bundle.calibration, surface)) {}
  RigidTransform world_from_depth;
  CalibrationBundle bundle;
  DepthSurface surface;
  ColorPicture picture;
};

/// The share of matches whose features lie at the same place of the room.
double right_share(const Seen& one, const FeatureSet& of_one, const Seen& other,
                   const FeatureSet& of_other) {
  const auto matches = compare_features(of_one, of_other, 0.5F).matches;
  double right = 0;
  for (const DescriptorMatch& match : matches) {
    const Eigen::Vector3d a =
        one.world_from_depth * of_one.features[match.a].point_m.cast<double>();
    const Eigen::Vector3d b =
        other.world_from_depth * of_other.features[match.b].point_m.cast<double>();
    right += (a - b).norm() < 0.05;
  }
  EXPECT_GT(matches.size(), 20u);
  return matches.empty() ? 0 : right / double(matches.size());
}

const RigidTransform kHere = corner_pose(2, 1.5);
const RigidTransform kBeside = world_from_optical_looking_at({1.7, 1.8, 1.6}, {0.3, 0.4, -0.3});
const RigidTransform kAside = world_from_optical_looking_at({0.3, 1.9, 1.7}, {0.2, 0.4, -0.3});

TEST(SiftDetector, gives_the_same_every_time) {
  const Seen seen(kHere);
  const auto one = detect_sift(seen.picture.grey, {}, {});
  const auto other = detect_sift(seen.picture.grey, {}, {});
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].pixel, other[i].pixel);
    EXPECT_EQ(one[i].descriptor, other[i].descriptor);
  }
}

TEST(SiftDetector, finds_nothing_in_tiny_or_even_pictures) {
  EXPECT_TRUE(detect_sift(Image<std::uint8_t>(4, 4), {}, {}).empty());
  EXPECT_TRUE(detect_sift(Image<std::uint8_t>(200, 200, 90), {}, {}).empty());
}

TEST(SiftDetector, seeks_only_where_the_mask_lets_it) {
  const Seen seen(kHere);
  MaskImage left(seen.picture.grey.width(), seen.picture.grey.height());
  for (int y = 0; y < left.height(); ++y) std::fill_n(left.view().row(y), 200, 255);
  for (const SiftFeature& found : detect_sift(seen.picture.grey, left, {})) {
    EXPECT_LT(found.pixel.x(), 201);
  }
}

TEST(PictureFeatures, match_between_neighbouring_views) {
  const Seen one(kHere), other(kBeside);
  EXPECT_GT(right_share(one, picture_features(one.picture), other, picture_features(other.picture)),
            0.3);
}

TEST(RectifiedFeatures, match_between_views_far_aside) {
  const Seen one(kHere), other(kAside);
  const auto of_one = rectified_features(one.picture, find_planes(one.surface.samples));
  const auto of_other = rectified_features(other.picture, find_planes(other.surface.samples));
  EXPECT_GT(right_share(one, of_one, other, of_other), 0.1)
      << "one in ten is plenty for the vote, chance would be one in hundreds";
}

TEST(RectifiedFeatures, of_no_planes_are_none) {
  EXPECT_EQ(rectified_features(Seen(kHere).picture, {}).size(), 0u);
}

}  // namespace
}  // namespace roomcast::align
