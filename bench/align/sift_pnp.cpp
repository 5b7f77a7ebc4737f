// SPDX-License-Identifier: Apache-2.0
#include "bench/align/sift_pnp.h"

#include <vector>

#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>

#include "roomcast/alignment/feature/descriptor_products.h"

namespace roomcast::bench {
namespace {

constexpr float kRatio = 0.8F;  // Lowe 2004
constexpr int kRansacTrials = 5000;
constexpr float kInlier_px = 4;
constexpr double kConfidence = 0.9999;
constexpr std::size_t kMinMatches = 6;

struct Matches {
  std::vector<cv::Point3d> b_m;
  std::vector<cv::Point2d> a_pixel;
};

Matches ratio_matches(const alignment::FeatureSet& a, const alignment::FeatureSet& b) {
  Matches matches;
  std::vector<std::int32_t> products(a.size());
  for (std::size_t j = 0; j < b.size(); ++j) {
    alignment::descriptor_products(b.descriptors[j], a.descriptors, products);
    std::size_t best = 0;
    std::int32_t most = -1, second = -1;
    for (std::size_t i = 0; i < products.size(); ++i) {
      if (products[i] > most) {
        second = most;
        most = products[i];
        best = i;
      } else if (products[i] > second) {
        second = products[i];
      }
    }
    if (second < 0 ||
        alignment::descriptor_distance(most) >= kRatio * alignment::descriptor_distance(second))
      continue;
    const auto& point = b.features[j].point_m;
    const auto& pixel = a.features[best].pixel;
    matches.b_m.emplace_back(point.x(), point.y(), point.z());
    matches.a_pixel.emplace_back(pixel.x(), pixel.y());
  }
  return matches;
}

RigidTransform transform_of(const cv::Mat& rotation_vector, const cv::Mat& translation) {
  cv::Mat rotation;
  cv::Rodrigues(rotation_vector, rotation);
  RigidTransform out;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) out.rotation(r, c) = rotation.at<double>(r, c);
    out.translation_m(r) = translation.at<double>(r);
  }
  return out;
}

}  // namespace

std::optional<RigidTransform> sift_pnp_pose(const alignment::SensorView& a,
                                            const alignment::SensorView& b) {
  cv::setNumThreads(1);
  const Matches matches = ratio_matches(a.picture_features, b.picture_features);
  if (matches.b_m.size() < kMinMatches) return std::nullopt;
  const auto& camera = a.picture.camera;
  const cv::Mat matrix =
      (cv::Mat_<double>(3, 3) << camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
  cv::Mat rotation, translation;
  std::vector<int> inliers;
  if (!cv::solvePnPRansac(matches.b_m, matches.a_pixel, matrix, cv::noArray(), rotation,
                          translation, false, kRansacTrials, kInlier_px, kConfidence, inliers,
                          cv::SOLVEPNP_AP3P) ||
      inliers.size() < kMinMatches) {
    return std::nullopt;
  }
  const RigidTransform color_from_depth{a.picture.color_from_depth_rotation.cast<double>(),
                                        a.picture.color_from_depth_m.cast<double>()};
  return color_from_depth.inverse() * transform_of(rotation, translation);
}

}  // namespace roomcast::bench
