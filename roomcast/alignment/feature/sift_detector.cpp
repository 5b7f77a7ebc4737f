// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/feature/sift_detector.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include <opencv2/core.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

namespace roomcast::alignment {
namespace {

constexpr int kMinSide = 16;  // pixels; nothing is found in smaller pictures
// OpenCV detects in a picture of twice the size, whose pixel 2x is at x - 0.25, but reports x.
constexpr float kTooFar_px = 0.25F;

/// A view of our pixels; OpenCV takes no const pointers but does not write through this one.
cv::Mat mat_of(ImageView<const std::uint8_t> image) {
  return {image.height, image.width, CV_8UC1, const_cast<std::uint8_t*>(image.data),
          static_cast<std::size_t>(image.stride)};
}

cv::Mat equalised(ImageView<const std::uint8_t> grey, const SiftOptions& options) {
  cv::Mat out;
  cv::createCLAHE(options.clahe_limit, {options.clahe_tiles, options.clahe_tiles})
      ->apply(mat_of(grey), out);
  return out;
}

bool comes_before(const cv::KeyPoint& a, const cv::KeyPoint& b) {
  return std::tie(a.pt.y, a.pt.x, a.size, a.angle) < std::tie(b.pt.y, b.pt.x, b.size, b.angle);
}

/// Indices of the points in a fixed order.
std::vector<std::size_t> in_order(const std::vector<cv::KeyPoint>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return comes_before(points[a], points[b]);
  });
  return order;
}

std::vector<SiftFeature> detect(cv::Feature2D& detector, ImageView<const std::uint8_t> grey,
                                MaskView mask, const SiftOptions& options) {
  const cv::Mat picture = equalised(grey, options);
  const cv::Mat wanted = mask.data == nullptr ? cv::Mat() : mat_of(mask);
  std::vector<cv::KeyPoint> points;
  cv::Mat histograms;  // both in one call: they share the pyramid, which is the costly part
  detector.detectAndCompute(picture, wanted, points, histograms);
  std::vector<SiftFeature> features;
  for (const std::size_t i : in_order(points)) {
    const float* const row = histograms.ptr<float>(static_cast<int>(i));
    features.push_back(
        {{points[i].pt.x - kTooFar_px, points[i].pt.y - kTooFar_px},
         points[i].size,
         root_descriptor(std::span<const float, kDescriptorSize>(row, kDescriptorSize))});
  }
  return features;
}

cv::Ptr<cv::SIFT> sift_of(const SiftOptions& options) {
  return cv::SIFT::create(options.max_features, options.octave_layers, options.min_contrast,
                          options.largest_edge_ratio);
}

bool is_large_enough(ImageView<const std::uint8_t> grey) {
  return grey.width >= kMinSide && grey.height >= kMinSide;
}

}  // namespace

std::vector<SiftFeature> detect_affine_sift(ImageView<const std::uint8_t> grey,
                                            const SiftOptions& options, int max_tilt) {
  if (!is_large_enough(grey)) return {};
  cv::setNumThreads(1);
  return detect(*cv::AffineFeature::create(sift_of(options), max_tilt), grey, {}, options);
}

std::vector<SiftFeature> detect_sift(ImageView<const std::uint8_t> grey, MaskView mask,
                                     const SiftOptions& options) {
  if (!is_large_enough(grey)) return {};
  cv::setNumThreads(1);
  return detect(*sift_of(options), grey, mask, options);
}

}  // namespace roomcast::alignment
