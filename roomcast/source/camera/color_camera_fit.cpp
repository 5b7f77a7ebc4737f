// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/camera/color_camera_fit.h"

#include <array>
#include <cmath>

#include "roomcast/geometry/dense_solvers.h"

namespace roomcast::source {
namespace {

constexpr int kRounds = 12;

enum Unknown { kFx, kFy, kCx, kCy, kK1, kK2, kP1, kP2, kRoll, kX, kUnknowns };
using Unknowns = Eigen::Matrix<double, kUnknowns, 1>;

SensorCalibration calibration_of(const SensorCalibration& start, const Unknowns& x) {
  SensorCalibration found = start;
  CameraIntrinsics& color = found.color;
  color.fx = x[kFx], color.fy = x[kFy], color.cx = x[kCx], color.cy = x[kCy];
  color.k1 = x[kK1], color.k2 = x[kK2], color.p1 = x[kP1], color.p2 = x[kP2];
  const double c = std::cos(x[kRoll]), s = std::sin(x[kRoll]);
  found.color_from_depth.rotation << c, -s, 0, s, c, 0, 0, 0, 1;
  found.color_from_depth.translation_m = {x[kX], 0, 0};
  return found;
}

Unknowns unknowns_of(const SensorCalibration& start) {
  const CameraIntrinsics& color = start.color;
  Unknowns x = Unknowns::Zero();
  x[kFx] = color.fx, x[kFy] = color.fy, x[kCx] = color.cx, x[kCy] = color.cy;
  x[kX] = start.color_from_depth.translation_m.x();
  return x;
}

Eigen::Vector2d residual(const SensorCalibration& cameras, const MappedPoint& mapped) {
  const Eigen::Vector3d point = cameras.color_from_depth * mapped.point_m;
  const Eigen::Vector2d xy = distort(cameras.color, point.head<2>() / point.z());
  return Eigen::Vector2d(cameras.color.fx * xy.x() + cameras.color.cx,
                         cameras.color.fy * xy.y() + cameras.color.cy) -
         mapped.seen_px;
}

/// One Gauss-Newton step with numerical derivatives.
Unknowns improved(const SensorCalibration& start, const Unknowns& x,
                  const std::vector<MappedPoint>& points) {
  Unknowns step;
  step << 1e-2, 1e-2, 1e-2, 1e-2, 1e-5, 1e-5, 1e-6, 1e-6, 1e-6, 1e-6;
  const SensorCalibration here = calibration_of(start, x);
  std::array<SensorCalibration, kUnknowns> beside;
  for (int i = 0; i < kUnknowns; ++i) {
    Unknowns moved = x;
    moved[i] += step[i];
    beside[static_cast<std::size_t>(i)] = calibration_of(start, moved);
  }
  Eigen::Matrix<double, kUnknowns, kUnknowns> normal =
      Eigen::Matrix<double, kUnknowns, kUnknowns>::Zero();
  Unknowns right = Unknowns::Zero();
  for (const MappedPoint& mapped : points) {
    const Eigen::Vector2d r = residual(here, mapped);
    Eigen::Matrix<double, 2, kUnknowns> jacobian;
    for (int i = 0; i < kUnknowns; ++i)
      jacobian.col(i) = (residual(beside[static_cast<std::size_t>(i)], mapped) - r) / step[i];
    normal += jacobian.transpose() * jacobian;
    right += jacobian.transpose() * r;
  }
  return x - solve_symmetric(normal, right);
}

double rms_px(const SensorCalibration& cameras, const std::vector<MappedPoint>& points) {
  double sum = 0;
  for (const MappedPoint& mapped : points) sum += residual(cameras, mapped).squaredNorm();
  return std::sqrt(sum / static_cast<double>(points.size()));
}

}  // namespace

Result<SensorCalibration> fit_color_camera(const SensorCalibration& start,
                                           const std::vector<MappedPoint>& points) {
  const Error no_camera{ErrorCode::kMalformed, "the device's calibration fits no colour camera"};
  if (points.size() < kFewestMappedPoints) return no_camera;
  Unknowns x = unknowns_of(start);
  for (int round = 0; round < kRounds; ++round) x = improved(start, x, points);
  const SensorCalibration found = calibration_of(start, x);
  if (!found.color.check() || !(rms_px(found, points) <= kWorstFit_px)) return no_camera;
  return found;
}

SensorCalibration mirrored(const SensorCalibration& cameras) {
  const auto flip = [](CameraIntrinsics camera) {
    camera.cx = camera.width - 1 - camera.cx;
    camera.p2 = -camera.p2;
    return camera;
  };
  const Eigen::DiagonalMatrix<double, 3> flip_x(-1, 1, 1);
  SensorCalibration out = cameras;
  out.depth = flip(cameras.depth);
  out.color = flip(cameras.color);
  out.color_from_depth.rotation = flip_x * cameras.color_from_depth.rotation * flip_x;
  out.color_from_depth.translation_m = flip_x * cameras.color_from_depth.translation_m;
  return out;
}

}  // namespace roomcast::source
