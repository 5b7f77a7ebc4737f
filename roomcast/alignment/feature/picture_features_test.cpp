// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/feature/picture_features.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/affine_features.h"
#include "roomcast/alignment/feature/feature_comparison.h"
#include "roomcast/alignment/feature/rectified_features.h"
#include "roomcast/alignment/feature/room_fixture.h"
#include "roomcast/alignment/feature/sift_detector.h"
#include "roomcast/alignment/view/planes.h"

namespace roomcast::alignment {
namespace {

struct SeenWall {
  explicit SeenWall(const RigidTransform& pose, const RoomFixture& room = {})
      : world_from_depth(pose),
        bundle(bundle_fixture(room, "s", pose)),
        surface(depth_surface(bundle.depth_mm, bundle.calibration.depth)),
        picture(color_picture(bundle.color, bundle.calibration, surface)) {}
  RigidTransform world_from_depth;
  CalibrationBundle bundle;
  DepthSurface surface;
  ColorPicture picture;
};

struct Matched {
  double all = 0, right = 0;  // right: both features at the same place in the room
};

Matched matched(const SeenWall& one, const FeatureSet& of_one, const SeenWall& other,
                const FeatureSet& of_other) {
  const auto matches = compare_features(of_one, of_other, 0.5F).matches;
  Matched count{double(matches.size())};
  for (const DescriptorMatch& match : matches) {
    const Eigen::Vector3d a =
        one.world_from_depth * of_one.features[match.a].point_m.cast<double>();
    const Eigen::Vector3d b =
        other.world_from_depth * of_other.features[match.b].point_m.cast<double>();
    count.right += (a - b).norm() < 0.05;
  }
  return count;
}

double right_share(const SeenWall& one, const FeatureSet& of_one, const SeenWall& other,
                   const FeatureSet& of_other) {
  const Matched count = matched(one, of_one, other, of_other);
  EXPECT_GT(count.all, 20);
  return count.all == 0 ? 0 : count.right / count.all;
}

const RigidTransform kFrontOfWall = corner_pose(2, 1.5);
const RigidTransform kBeside = world_from_optical_looking_at({1.7, 1.8, 1.6}, {0.3, 0.4, -0.3});
const RigidTransform kNearShift = world_from_optical_looking_at({0.3, 1.9, 1.7}, {0.2, 0.4, -0.3});

TEST(SiftDetector, gives_the_same_every_time) {
  const SeenWall seen(kFrontOfWall);
  const auto one = detect_sift(seen.picture.grey, {}, {});
  const auto other = detect_sift(seen.picture.grey, {}, {});
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].pixel, other[i].pixel);
    EXPECT_EQ(one[i].descriptor, other[i].descriptor);
  }
}

/// Differences in x and in y, pixels, between features found in a picture and in the same picture
/// rotated by 180 degrees, after rotating the latter back.
std::vector<float> differences_when_turned(const Image<std::uint8_t>& grey) {
  Image<std::uint8_t> turned(grey.width(), grey.height());
  std::reverse_copy(grey.data(), grey.data() + grey.view().pixel_count(), turned.data());
  const Eigen::Vector2f last(static_cast<float>(grey.width() - 1),
                             static_cast<float>(grey.height() - 1));
  const auto of_turned = detect_sift(turned, {}, {});
  std::vector<float> differences;
  for (const SiftFeature& one : detect_sift(grey, {}, {})) {
    for (const SiftFeature& other : of_turned) {
      const Eigen::Vector2f apart = last - other.pixel - one.pixel;
      if (apart.cwiseAbs().maxCoeff() < 1 && std::abs(one.size - other.size) < 0.1F * one.size)
        differences.insert(differences.end(), {apart.x(), apart.y()});
    }
  }
  return differences;
}

TEST(SiftDetector, finds_the_same_places_in_a_picture_turned_by_half) {
  const SeenWall seen(kFrontOfWall);
  Image<std::uint8_t> whole_tiles(400, 296);  // contrast is equalised in 8 x 8 tiles
  std::copy_n(seen.picture.grey.data(), whole_tiles.view().pixel_count(), whole_tiles.data());
  auto differences = differences_when_turned(whole_tiles);
  ASSERT_GT(differences.size(), 200u);
  const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  EXPECT_NEAR(*middle, 0, 0.05F) << "a quarter pixel aside, each of them: half a pixel in all";
}

TEST(SiftDetector, finds_nothing_in_tiny_or_even_pictures) {
  EXPECT_TRUE(detect_sift(Image<std::uint8_t>(4, 4), {}, {}).empty());
  EXPECT_TRUE(detect_sift(Image<std::uint8_t>(200, 200, 90), {}, {}).empty());
}

TEST(SiftDetector, seeks_only_where_the_mask_lets_it) {
  const SeenWall seen(kFrontOfWall);
  MaskImage left(seen.picture.grey.width(), seen.picture.grey.height());
  for (int y = 0; y < left.height(); ++y) std::fill_n(left.view().row(y), 200, 255);
  for (const SiftFeature& found : detect_sift(seen.picture.grey, left, {})) {
    EXPECT_LT(found.pixel.x(), 201);
  }
}

TEST(PictureFeatures, match_between_neighbouring_views) {
  const SeenWall one(kFrontOfWall), other(kBeside);
  EXPECT_GT(right_share(one, picture_features(one.picture, one.surface), other,
                        picture_features(other.picture, other.surface)),
            0.3);
}

TEST(AffineFeatures, match_between_views_aside_where_those_of_the_picture_hardly_do) {
  const SeenWall one(kFrontOfWall), other(kNearShift);
  const Matched as_seen = matched(one, picture_features(one.picture, one.surface), other,
                                  picture_features(other.picture, other.surface));
  const Matched from_aside = matched(one, affine_features(one.picture, one.surface), other,
                                     affine_features(other.picture, other.surface));
  EXPECT_GT(from_aside.right, 3 * as_seen.right + 10);
  EXPECT_GT(from_aside.right, 0.3 * from_aside.all);
}

TEST(AffineFeatures, are_none_in_even_pictures_and_the_same_every_time) {
  const SeenWall grey(kFrontOfWall), seen(kFrontOfWall);
  ColorPicture even = grey.picture;
  std::fill_n(even.grey.data(), even.grey.view().pixel_count(), std::uint8_t{90});
  EXPECT_EQ(affine_features(even, grey.surface).size(), 0u);
  const FeatureSet one = affine_features(seen.picture, seen.surface);
  EXPECT_EQ(one.descriptors, affine_features(seen.picture, seen.surface).descriptors);
}

TEST(RectifiedFeatures, match_between_views_far_aside) {
  const SeenWall one(kFrontOfWall), other(kNearShift);
  const auto of_one =
      rectified_features(one.picture, one.surface, find_planes(one.surface.samples));
  const auto of_other =
      rectified_features(other.picture, other.surface, find_planes(other.surface.samples));
  EXPECT_GT(right_share(one, of_one, other, of_other), 0.1)
      << "one in ten is plenty for the vote, chance would be one in hundreds";
}

TEST(RectifiedFeatures, of_a_rug_lie_on_the_rug) {
  RoomFixture room;
  room.boxes = {{Eigen::Vector3d(-1, 0, -0.8), Eigen::Vector3d(1, 0.02, 0.8)}};
  const SeenWall here(kFrontOfWall, room);
  const auto set =
      rectified_features(here.picture, here.surface, find_planes(here.surface.samples));
  std::vector<double> heights_m;
  for (const Feature& feature : set.features) {
    const Eigen::Vector3d at = here.world_from_depth * feature.point_m.cast<double>();
    if (std::abs(at.x()) < 0.9 && std::abs(at.z()) < 0.7) heights_m.push_back(at.y());
  }
  ASSERT_GT(heights_m.size(), 20u);
  std::sort(heights_m.begin(), heights_m.end());
  EXPECT_NEAR(heights_m[heights_m.size() / 2], 0.02, 0.002);
}

TEST(RectifiedFeatures, of_no_planes_are_none) {
  const SeenWall here(kFrontOfWall);
  EXPECT_EQ(rectified_features(here.picture, here.surface, {}).size(), 0u);
}

}  // namespace
}  // namespace roomcast::alignment
