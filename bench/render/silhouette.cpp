// SPDX-License-Identifier: Apache-2.0
#include "bench/render/silhouette.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "bench/render/depth_tolerance.h"
#include "roomcast/core/assert.h"

namespace roomcast::bench {
namespace {

constexpr std::uint16_t kOpen_mm = std::numeric_limits<std::uint16_t>::max();
constexpr float kReach_m = 0.3F;

MaskImage without_specks(MaskImage& mask) {
  MaskImage out(mask.width(), mask.height());
  cv::Mat result(mask.height(), mask.width(), CV_8U, out.data());
  cv::medianBlur(cv::Mat(mask.height(), mask.width(), CV_8U, mask.data()), result, 3);
  return out;
}

double median_depth_m(const TruthView& truth, const MaskImage& mask) {
  std::vector<std::uint16_t> depths_mm;
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (mask.at(x, y) != 0) depths_mm.push_back(truth.depth_mm.at(x, y));
    }
  }
  if (depths_mm.empty()) return 0;
  const auto middle = depths_mm.begin() + static_cast<std::ptrdiff_t>(depths_mm.size() / 2);
  std::ranges::nth_element(depths_mm, middle);
  return 0.001 * *middle;
}

/// Silhouette::reach_m, with the distance in the picture in pixels.
Image<float> reach_of(const MaskImage& mask, const TruthView& truth, double distance_px) {
  cv::Mat outside(mask.height(), mask.width(), CV_8U), distances_px, labels;
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) outside.at<std::uint8_t>(y, x) = mask.at(x, y) == 0;
  }
  cv::distanceTransform(outside, distances_px, labels, cv::DIST_L2, cv::DIST_MASK_5,
                        cv::DIST_LABEL_PIXEL);
  std::unordered_map<int, float> depth_m_by_label;
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (mask.at(x, y) == 0) continue;
      depth_m_by_label[labels.at<int>(y, x)] = 0.001F * static_cast<float>(truth.depth_mm.at(x, y));
    }
  }
  Image<float> reach_m(mask.width(), mask.height());
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (static_cast<double>(distances_px.at<float>(y, x)) > distance_px) continue;
      reach_m.at(x, y) = depth_m_by_label.at(labels.at<int>(y, x)) + kReach_m;
    }
  }
  return reach_m;
}

}  // namespace

StillBackground::StillBackground(const SensorCalibration& calibration,
                                 const RigidTransform& world_from_depth)
    : lens_(calibration.depth),
      depth_from_world_(world_from_depth.inverse()),
      farthest_mm_(lens_.width, lens_.height) {}

void StillBackground::add(DepthView noise_free_mm) {
  ROOMCAST_ASSERT(noise_free_mm.width == lens_.width && noise_free_mm.height == lens_.height);
  for (int y = 0; y < lens_.height; ++y) {
    for (int x = 0; x < lens_.width; ++x) {
      const std::uint16_t depth_mm = noise_free_mm.at(x, y);
      std::uint16_t& farthest_mm = farthest_mm_.at(x, y);
      farthest_mm = std::max(farthest_mm, depth_mm == 0 ? kOpen_mm : depth_mm);
    }
  }
}

double StillBackground::nearest_m(int x, int y) const {
  std::uint16_t nearest_mm = kOpen_mm;
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, lens_.height - 1); ++v) {
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, lens_.width - 1); ++u) {
      nearest_mm = std::min(nearest_mm, farthest_mm_.at(u, v));
    }
  }
  return 0.001 * nearest_mm;
}

bool StillBackground::is_behind(const Eigen::Vector3d& point_world) const {
  const Eigen::Vector3d point = depth_from_world_ * point_world;
  const auto pixel = project(lens_, point);
  if (!pixel) return false;
  const int x = static_cast<int>(std::lround(pixel->x()));
  const int y = static_cast<int>(std::lround(pixel->y()));
  if (x < 0 || y < 0 || x >= lens_.width || y >= lens_.height) return false;
  return nearest_m(x, y) > point.z() + depth_tolerance_m(point.z());
}

Silhouette find_silhouette(const render::ViewCamera& camera, const TruthView& truth,
                           std::span<const StillBackground> backgrounds) {
  const ViewPoints points(camera);
  MaskImage mask(camera.width, camera.height);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const unsigned seen = truth.seen.at(x, y);
      if (seen == 0) continue;
      const Eigen::Vector3d point = points.at(x, y, 0.001 * truth.depth_mm.at(x, y));
      for (std::size_t s = 0; s < backgrounds.size() && mask.at(x, y) == 0; ++s) {
        if ((seen >> s & 1U) != 0 && backgrounds[s].is_behind(point)) mask.at(x, y) = 255;
      }
    }
  }
  mask = without_specks(mask);
  const double depth_m = median_depth_m(truth, mask);
  if (depth_m <= 0) return {mask, Image<float>(mask.width(), mask.height())};
  const double distance_px =
      static_cast<double>(kReach_m) * render::focal_length_px(camera) / depth_m;
  return {mask, reach_of(mask, truth, distance_px)};
}

}  // namespace roomcast::bench
