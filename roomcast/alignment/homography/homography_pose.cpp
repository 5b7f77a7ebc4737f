// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/homography/homography_pose.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "roomcast/alignment/rig/world_frame.h"
#include "roomcast/alignment/view/lift.h"

namespace roomcast::alignment {
namespace {

/// Corners and the patches around them, one per row, normalised to mean 0 and length 1.
struct Corners {
  std::vector<cv::Point2f> pixels;
  cv::Mat patches;
};

Corners find_corners(const Image<std::uint8_t>& grey, const HomographyOptions& options) {
  const int reach = options.patch_reach_px;
  const cv::Mat picture(grey.height(), grey.width(), CV_8UC1,
                        const_cast<std::uint8_t*>(grey.data()));
  std::vector<cv::Point2f> found;
  cv::goodFeaturesToTrack(picture, found, options.max_corners, options.min_quality,
                          options.min_apart_px, cv::noArray(), 3, true, options.harris_k);
  Corners corners;
  for (const cv::Point2f& pixel : found) {
    const int x = cvRound(pixel.x), y = cvRound(pixel.y);
    const cv::Rect window(x - reach, y - reach, 2 * reach + 1, 2 * reach + 1);
    if ((window & cv::Rect(0, 0, picture.cols, picture.rows)) != window) continue;
    cv::Mat patch;
    picture(window).clone().reshape(1, 1).convertTo(patch, CV_32F);
    patch -= cv::mean(patch);
    corners.patches.push_back(cv::Mat(patch / (cv::norm(patch) + 1e-6)));
    corners.pixels.push_back(pixel);
  }
  return corners;
}

struct CornerMatches {
  std::vector<cv::Point2f> a, b;
};

int best_in(const float* values, int count, std::ptrdiff_t stride) {
  int best = 0;
  for (int i = 1; i < count; ++i) {
    if (values[i * stride] > values[best * stride]) best = i;
  }
  return best;
}

/// Mutual best matches by normalised cross-correlation.
CornerMatches match_corners(const Corners& a, const Corners& b, float min_correlation) {
  CornerMatches matches;
  if (a.pixels.empty() || b.pixels.empty()) return matches;
  const cv::Mat products = a.patches * b.patches.t();
  for (int i = 0; i < products.rows; ++i) {
    const int j = best_in(products.ptr<float>(i), products.cols, 1);
    const auto stride = static_cast<std::ptrdiff_t>(products.step1());
    if (products.at<float>(i, j) < min_correlation) continue;
    if (best_in(products.ptr<float>(0) + j, products.rows, stride) != i) continue;
    matches.a.push_back(a.pixels[static_cast<std::size_t>(i)]);
    matches.b.push_back(b.pixels[static_cast<std::size_t>(j)]);
  }
  return matches;
}

/// Points of the same matches in both colour cameras' frames, from depth.
struct LiftedMatches {
  std::vector<Eigen::Vector3d> a, b;
};

LiftedMatches lift(const SensorView& a, const SensorView& b, const CornerMatches& matches,
                   const cv::Mat& inliers) {
  LiftedMatches lifted;
  for (std::size_t i = 0; i < matches.a.size(); ++i) {
    if (inliers.at<std::uint8_t>(static_cast<int>(i)) == 0) continue;
    const auto in_a = lift(a.picture, a.surface, {matches.a[i].x, matches.a[i].y});
    const auto in_b = lift(b.picture, b.surface, {matches.b[i].x, matches.b[i].y});
    if (!in_a || !in_b) continue;
    lifted.a.push_back(a.picture.in_color_frame(*in_a).cast<double>());
    lifted.b.push_back(b.picture.in_color_frame(*in_b).cast<double>());
  }
  return lifted;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

cv::Mat matrix_of(const Pinhole& camera) {
  return (cv::Mat_<double>(3, 3) << camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
}

/// One of the poses of a homography, scaled by depth, and its median error against depth.
struct ScaledPose {
  RigidTransform a_from_b;
  double error_m = std::numeric_limits<double>::max();
};

ScaledPose scaled(const cv::Mat& rotation, const cv::Mat& direction, const LiftedMatches& lifted) {
  ScaledPose pose;
  Eigen::Vector3d t;
  for (int r = 0; r < 3; ++r) {
    t(r) = direction.at<double>(r);
    for (int c = 0; c < 3; ++c) pose.a_from_b.rotation(r, c) = rotation.at<double>(r, c);
  }
  std::vector<double> scales, errors;
  for (std::size_t i = 0; i < lifted.a.size(); ++i) {
    const Eigen::Vector3d apart = lifted.a[i] - pose.a_from_b.rotation * lifted.b[i];
    scales.push_back(apart.dot(t) / std::max(t.squaredNorm(), 1e-12));
  }
  pose.a_from_b.translation_m =
      t.norm() > 1e-6 ? Eigen::Vector3d(median(scales) * t) : Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < lifted.a.size(); ++i) {
    errors.push_back((pose.a_from_b * lifted.b[i] - lifted.a[i]).norm());
  }
  pose.error_m = median(errors);
  return pose;
}

RigidTransform color_from_depth(const ColorPicture& picture) {
  return {picture.color_from_depth_rotation.cast<double>(),
          picture.color_from_depth_m.cast<double>()};
}

PairReport report_of(const SensorView& a, const SensorView& b, const HomographyOptions& options) {
  PairReport report;
  report.a = a.name;
  report.b = b.name;
  report.reason = "no homography between corners of both pictures was found";
  if (const auto pose = homography_pose(a, b, options)) {
    report.accepted = true;
    report.b_from_a = pose->a_from_b.inverse();
    report.inliers = pose->inliers;
    report.reason =
        fmt::format("{} corners follow a homography; its correctness is unknown", pose->inliers);
  }
  return report;
}

}  // namespace

std::optional<HomographyPose> homography_pose(const SensorView& a, const SensorView& b,
                                              const HomographyOptions& options) {
  cv::setNumThreads(1);
  const CornerMatches matches =
      match_corners(find_corners(a.picture.grey, options), find_corners(b.picture.grey, options),
                    options.min_correlation);
  if (matches.a.size() < static_cast<std::size_t>(options.min_matches)) return std::nullopt;
  cv::Mat inliers;
  const cv::Mat homography = cv::findHomography(matches.b, matches.a, cv::RANSAC, options.inlier_px,
                                                inliers, options.ransac_trials, options.confidence);
  if (homography.empty()) return std::nullopt;
  const LiftedMatches lifted = lift(a, b, matches, inliers);
  if (lifted.a.size() < options.min_lifted) return std::nullopt;
  // The decomposition assumes one camera for both pictures, so b's pixels are converted to a's
  // camera.
  const cv::Mat camera_a = matrix_of(a.picture.camera), camera_b = matrix_of(b.picture.camera);
  std::vector<cv::Mat> rotations, directions, normals;
  cv::decomposeHomographyMat(homography * camera_b * camera_a.inv(), camera_a, rotations,
                             directions, normals);
  ScaledPose best;
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    const ScaledPose pose = scaled(rotations[i], directions[i], lifted);
    if (pose.error_m < best.error_m) best = pose;
  }
  if (rotations.empty()) return std::nullopt;
  return HomographyPose{
      color_from_depth(a.picture).inverse() * best.a_from_b * color_from_depth(b.picture),
      cv::countNonZero(inliers)};
}

AlignmentReport align_by_homography(std::span<const std::shared_ptr<const SensorView>> views,
                                    const HomographyOptions& options) {
  AlignmentReport report;
  if (views.empty()) return report;
  std::vector<Plane> floors;
  if (views[0]->floor) floors.push_back(*views[0]->floor);
  const WorldFrame world = world_frame(floors);
  report.has_floor = world.has_floor;
  for (std::size_t i = 0; i < views.size(); ++i) {
    SensorReport sensor;
    sensor.id = views[i]->name;
    sensor.placed = i == 0;
    sensor.reason = "stands at the origin";
    RigidTransform origin_from_sensor;
    if (i > 0) {
      report.pairs.push_back(report_of(*views[0], *views[i], options));
      const PairReport& pair = report.pairs.back();
      sensor.placed = pair.accepted;
      sensor.reason = pair.reason;
      if (pair.b_from_a) origin_from_sensor = pair.b_from_a->inverse();
    }
    if (sensor.placed) sensor.world_from_depth = world.world_from_origin * origin_from_sensor;
    report.sensors.push_back(std::move(sensor));
  }
  return report;
}

}  // namespace roomcast::alignment
