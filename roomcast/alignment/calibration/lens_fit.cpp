// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/calibration/lens_fit.h"

#include <cmath>

#include <opencv2/calib3d.hpp>

namespace roomcast::alignment::calibration {
namespace {

struct Correspondences {
  std::vector<std::vector<cv::Point3f>> on_board;
  std::vector<std::vector<cv::Point2f>> in_picture;
};

Correspondences correspondences_of(const CharucoBoard& board,
                                   const std::vector<std::vector<SeenCorner>>& views) {
  Correspondences all;
  for (const auto& view : views) {
    auto& on_board = all.on_board.emplace_back();
    auto& in_picture = all.in_picture.emplace_back();
    for (const SeenCorner& seen : view) {
      const Eigen::Vector2f corner = board.corner_m(seen.corner).cast<float>();
      on_board.emplace_back(corner.x(), corner.y(), 0.0F);
      in_picture.emplace_back(seen.pixel.cast<float>().x(), seen.pixel.cast<float>().y());
    }
  }
  return all;
}

cv::Matx33d matrix_of(const CameraIntrinsics& camera) {
  return {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1};
}

cv::Mat distortion_of(const CameraIntrinsics& camera) {
  return (cv::Mat_<double>(1, 5) << camera.k1, camera.k2, camera.p1, camera.p2, camera.k3);
}

CameraIntrinsics camera_of(const CameraIntrinsics& start, const cv::Matx33d& matrix,
                           const cv::Mat& distortion) {
  CameraIntrinsics camera = start;
  camera.fx = matrix(0, 0), camera.fy = matrix(1, 1);
  camera.cx = matrix(0, 2), camera.cy = matrix(1, 2);
  camera.k1 = distortion.at<double>(0), camera.k2 = distortion.at<double>(1);
  camera.p1 = distortion.at<double>(2), camera.p2 = distortion.at<double>(3);
  camera.k3 = distortion.at<double>(4);
  return camera;
}

RigidTransform transform_of(const cv::Mat& rotation, const cv::Mat& translation) {
  cv::Mat matrix;
  cv::Rodrigues(rotation, matrix);
  RigidTransform transform;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) transform.rotation(r, c) = matrix.at<double>(r, c);
    transform.translation_m[r] = translation.at<double>(r);
  }
  return transform;
}

void add_errors(const CharucoBoard& board, const std::vector<SeenCorner>& view,
                const RigidTransform& camera_from_board, LensFit& fit) {
  for (const SeenCorner& seen : view) {
    const Eigen::Vector2d corner = board.corner_m(seen.corner);
    const auto expected =
        project(fit.camera, camera_from_board * Eigen::Vector3d(corner.x(), corner.y(), 0));
    if (expected) fit.errors.push_back({seen.pixel, seen.pixel - *expected});
  }
}

double rms_of(const std::vector<CornerError>& errors) {
  double sum = 0;
  for (const CornerError& error : errors) sum += error.error_px.squaredNorm();
  return std::sqrt(sum / static_cast<double>(errors.size()));
}

/// OpenCV throws on invalid input; the caller turns that into an error.
void solve(const Correspondences& seen, bool keep_lens, LensFit& fit) {
  cv::Matx33d matrix = matrix_of(fit.camera);
  cv::Mat distortion = distortion_of(fit.camera);
  std::vector<cv::Mat> rotations, translations;
  if (keep_lens) {
    for (std::size_t i = 0; i < seen.on_board.size(); ++i) {
      cv::solvePnP(seen.on_board[i], seen.in_picture[i], matrix, distortion,
                   rotations.emplace_back(), translations.emplace_back());
    }
  } else {
    // A third radial term would fit noise rather than the lens.
    cv::calibrateCamera(seen.on_board, seen.in_picture, {fit.camera.width, fit.camera.height},
                        matrix, distortion, rotations, translations,
                        cv::CALIB_USE_INTRINSIC_GUESS | cv::CALIB_FIX_K3);
    fit.camera = camera_of(fit.camera, matrix, distortion);
  }
  for (std::size_t i = 0; i < rotations.size(); ++i)
    fit.camera_from_board.push_back(transform_of(rotations[i], translations[i]));
}

}  // namespace

Result<LensFit> fit_lens(const CharucoBoard& board,
                         const std::vector<std::vector<SeenCorner>>& views,
                         const CameraIntrinsics& start, bool keep_lens) {
  if (views.size() < (keep_lens ? 1 : kFewestViews)) {
    return Error{ErrorCode::kNotFound, "the board was seen " + std::to_string(views.size()) +
                                           " times; a lens needs " + std::to_string(kFewestViews) +
                                           " views at least"};
  }
  const Error no_board{
      ErrorCode::kMalformed,
      "the corners do not fit the board; check its size, and glue it on something flat"};
  LensFit fit;
  fit.camera = start;
  if (!keep_lens) fit.camera.k3 = 0;
  try {
    solve(correspondences_of(board, views), keep_lens, fit);
  } catch (const cv::Exception&) {
    return no_board;
  }
  for (std::size_t i = 0; i < views.size(); ++i)
    add_errors(board, views[i], fit.camera_from_board[i], fit);
  if (!fit.camera.check() || fit.errors.empty()) return no_board;
  fit.rms_px = rms_of(fit.errors);
  if (!(fit.rms_px < kWorstRms_px)) return no_board;
  return fit;
}

}  // namespace roomcast::alignment::calibration
