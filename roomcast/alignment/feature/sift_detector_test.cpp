// SPDX-License-Identifier: Apache-2.0
// Pictures with round blobs at known places.
#include "roomcast/alignment/feature/sift_detector.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "roomcast/alignment/feature/room_fixture.h"

namespace roomcast::alignment {
namespace {

using Blobs = std::vector<Eigen::Vector2d>;

constexpr double kBlobSigma_px = 4;
/// Contrast is equalised over 8 x 8 tiles of the picture. Each blob is in the middle of four of
/// them, so that it stays symmetric.
constexpr int kBlobPicture_px = 256;
const Blobs kThreeBlobs = {{63.5, 63.5}, {191.5, 95.5}, {95.5, 191.5}};

/// Bright blobs on grey.
Image<std::uint8_t> blob_picture(int side_px = kBlobPicture_px, const Blobs& blobs = kThreeBlobs) {
  Image<std::uint8_t> grey(side_px, side_px);
  for (int y = 0; y < side_px; ++y) {
    for (int x = 0; x < side_px; ++x) {
      double sum = 60;
      for (const Eigen::Vector2d& blob : blobs) {
        const double away = (Eigen::Vector2d(x, y) - blob).norm() / kBlobSigma_px;
        sum += 150 * std::exp(-0.5 * away * away);
      }
      grey.at(x, y) = static_cast<std::uint8_t>(std::lround(sum));
    }
  }
  return grey;
}

/// Distance from a blob to the nearest feature.
double nearest_px(const std::vector<SiftFeature>& features, const Eigen::Vector2d& blob) {
  double nearest = 1e9;
  for (const SiftFeature& feature : features)
    nearest = std::min(nearest, (feature.pixel.cast<double>() - blob).norm());
  return nearest;
}

TEST(SiftDetector, finds_blobs_where_they_are) {
  const auto features = detect_sift(blob_picture(), {}, {});
  // A quarter of a pixel is what OpenCV's own coordinates would be off by.
  for (const Eigen::Vector2d& blob : kThreeBlobs) EXPECT_LT(nearest_px(features, blob), 0.2);
}

TEST(SiftDetector, finds_nothing_where_the_mask_is_zero) {
  MaskImage mask(kBlobPicture_px, kBlobPicture_px, 255);
  for (int y = 0; y < kBlobPicture_px / 2; ++y) {
    for (int x = 0; x < kBlobPicture_px / 2; ++x) mask.at(x, y) = 0;
  }
  const auto features = detect_sift(blob_picture(), mask.view(), {});
  EXPECT_GT(nearest_px(features, kThreeBlobs[0]), 10);
  EXPECT_LT(nearest_px(features, kThreeBlobs[1]), 0.2);
  EXPECT_LT(nearest_px(features, kThreeBlobs[2]), 0.2);
}

TEST(SiftDetector, gives_features_from_top_to_bottom_and_the_same_every_time) {
  const auto one = detect_sift(blob_picture(), {}, {}), other = detect_sift(blob_picture(), {}, {});
  ASSERT_GE(one.size(), 3u);
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].pixel, other[i].pixel);
    EXPECT_EQ(one[i].descriptor, other[i].descriptor);
  }
  EXPECT_TRUE(std::ranges::is_sorted(one, {},
                                     [](const SiftFeature& feature) { return feature.pixel.y(); }));
}

/// Cells of random greys.
Image<std::uint8_t> noise_picture() {
  constexpr int kNoiseCell_px = 8;
  Image<std::uint8_t> grey(128, 128);
  for (int y = 0; y < grey.height(); ++y) {
    for (int x = 0; x < grey.width(); ++x)
      grey.at(x, y) = static_cast<std::uint8_t>(
          255 * pattern_noise(1, x / kNoiseCell_px, y / kNoiseCell_px, 0));
  }
  return grey;
}

TEST(SiftDetector, finds_about_as_many_as_asked_for) {
  // A place with several directions is several features, of equal rank: either all are kept or
  // none.
  const std::size_t some = detect_sift(noise_picture(), {}, {.max_features = 20}).size();
  EXPECT_GE(some, 20u);
  EXPECT_LE(some, 24u);
  EXPECT_GT(detect_sift(noise_picture(), {}, {}).size(), 40u);
}

TEST(SiftDetector, finds_nothing_in_plain_and_in_tiny_pictures) {
  const Image<std::uint8_t> plain(kBlobPicture_px, kBlobPicture_px, 100), tiny(15, 200, 100);
  EXPECT_TRUE(detect_sift(plain, {}, {}).empty());
  EXPECT_TRUE(detect_sift(tiny, {}, {}).empty());
  EXPECT_TRUE(detect_affine_sift(tiny, {}).empty());
  EXPECT_TRUE(detect_sift(Image<std::uint8_t>(), {}, {}).empty());
}

TEST(AffineSift, finds_a_blob_in_oblique_views_too) {
  const Eigen::Vector2d middle(63.5, 63.5);
  const Image<std::uint8_t> picture = blob_picture(128, {middle});
  const auto near_middle = [&](const std::vector<SiftFeature>& features) {
    return std::ranges::count_if(features, [&](const SiftFeature& feature) {
      return (feature.pixel.cast<double>() - middle).norm() < 3;
    });
  };
  EXPECT_GE(near_middle(detect_sift(picture, {}, {})), 1);
  EXPECT_GT(near_middle(detect_affine_sift(picture, {})),
            near_middle(detect_sift(picture, {}, {})));
}

}  // namespace
}  // namespace roomcast::alignment
