// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/motion/motion_check.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "roomcast/alignment/pair/pair_equations.h"
#include "roomcast/geometry/dense_solvers.h"
#include "roomcast/geometry/rotations.h"

namespace roomcast::alignment {
namespace {

/// The solution of the equations, restricted to the well-determined directions.
Vector6 known_motion(const Matrix6& information, const Vector6& gradient,
                     const MotionCheckOptions& options) {
  Vector6 scale;  // radians as metres at the lever
  scale << Eigen::Vector3d::Constant(1 / options.lever_m), Eigen::Vector3d::Ones();
  const Matrix6 scaled = scale.asDiagonal() * information * scale.asDiagonal();
  const PrincipalAxes axes = principal_axes(scaled);
  const Matrix6 directions = axes.directions;
  const Vector6 along = directions.transpose() * scale.cwiseProduct(gradient);
  Vector6 step = Vector6::Zero();
  for (Eigen::Index i = 0; i < 6; ++i) {
    const double known = axes.variances(i);
    if (known * options.observable_m * options.observable_m < 1) continue;
    step -= along(i) / known * directions.col(i);
  }
  return scale.cwiseProduct(step);
}

}  // namespace

struct MotionCheck::Tally {
  int readings = 0, hidden = 0, gone = 0, fitting = 0;
  double misfit = 0;

  [[nodiscard]] int comparable() const { return readings - hidden; }
  [[nodiscard]] double agree() const {
    return static_cast<double>(fitting) / std::max(1, comparable());
  }
  [[nodiscard]] double mean_misfit() const { return misfit / std::max(1, comparable()); }
};

MotionCheck::MotionCheck(const CalibrationBundle& bundle, const MotionCheckOptions& options)
    : options_(options),
      lens_(bundle.calibration.depth),
      rays_(ray_table(bundle.calibration.depth)) {
  const auto samples =
      depth_surface(bundle.depth_mm, bundle.calibration.depth, options.surface).samples;
  const double step = std::max(
      1.0, static_cast<double>(samples.size()) / static_cast<double>(options.max_landmarks));
  for (double at = 0; at < static_cast<double>(samples.size()); at += step) {
    const SurfacePoint& sample = samples[static_cast<std::size_t>(at)];
    landmarks_.push_back(
        {sample.point_m, sample.normal, options.surface.noise.sigma_m(sample.point_m.z())});
  }
}

/// Calls `visit(landmark, its current position, its current normal, distance by which the reading
/// there is farther)`.
template <class Visit>
void MotionCheck::for_each_reading(DepthView depth_mm, const RigidTransform& now_from_then,
                                   Visit visit) const {
  const Pose pose{now_from_then.rotation.cast<float>(), now_from_then.translation_m.cast<float>()};
  const float nearest_m = options_.surface.nearest_m;
  for (const Landmark& landmark : landmarks_) {
    const Eigen::Vector3f point = pose.rotation * landmark.point_m + pose.shift;
    Eigen::Vector2f pixel;
    if (!lens_.project(point, pixel)) continue;
    const auto x = static_cast<int>(std::lround(pixel.x()));
    const auto y = static_cast<int>(std::lround(pixel.y()));
    if (x < 0 || y < 0 || x >= depth_mm.width || y >= depth_mm.height) continue;
    const float z_m = 0.001F * static_cast<float>(depth_mm.at(x, y));
    const Eigen::Vector2f& ray = rays_.at(x, y);
    if (!(z_m > nearest_m) || std::isnan(ray.x())) continue;
    const Eigen::Vector3f normal = pose.rotation * landmark.normal;
    visit(landmark, point, normal, normal.dot(point - z_m * ray.homogeneous()));
  }
}

RigidTransform MotionCheck::improved(DepthView depth_mm, const RigidTransform& now_from_then,
                                     float widening) const {
  Matrix6 information = Matrix6::Zero();
  Vector6 gradient = Vector6::Zero();
  int terms = 0;
  for_each_reading(depth_mm, now_from_then,
                   [&](const Landmark& landmark, const Eigen::Vector3f& point,
                       const Eigen::Vector3f& normal, float farther_m) {
                     const auto sigmas = double(farther_m / landmark.sigma_m);
                     const double weight = robust_weight(sigmas / double(widening)) /
                                           double(landmark.sigma_m * landmark.sigma_m);
                     Vector6 jacobian;
                     jacobian << point.cross(normal).cast<double>(), normal.cast<double>();
                     information.selfadjointView<Eigen::Lower>().rankUpdate(jacobian, weight);
                     gradient += weight * double(farther_m) * jacobian;
                     ++terms;
                   });
  const double factor = std::min(1.0, options_.max_independent / std::max(1, terms));
  const Matrix6 whole = factor * Matrix6(information.selfadjointView<Eigen::Lower>());
  return step_transform(known_motion(whole, factor * gradient, options_)) * now_from_then;
}

MotionCheck::Tally MotionCheck::tally(DepthView depth_mm,
                                      const RigidTransform& now_from_then) const {
  const float fit_sigmas = options_.fit_sigmas;
  const float hidden_m = options_.hidden_m, gone_m = options_.gone_m;
  Tally tally;
  for_each_reading(depth_mm, now_from_then,
                   [&](const Landmark& landmark, const Eigen::Vector3f&, const Eigen::Vector3f&,
                       float farther_m) {
                     const float fits_m = fit_sigmas * landmark.sigma_m;
                     ++tally.readings;
                     if (farther_m < -fits_m - hidden_m) return void(++tally.hidden);
                     tally.gone += farther_m > fits_m + gone_m;
                     tally.fitting += std::abs(farther_m) <= fits_m;
                     const auto sigmas = double(farther_m / landmark.sigma_m);
                     tally.misfit += sigmas * sigmas / (1 + sigmas * sigmas / 4);
                   });
  return tally;
}

MotionEvidence MotionCheck::compare(DepthView depth_mm) const {
  MotionEvidence evidence;
  for (const float widening : options_.widening)
    evidence.now_from_then = improved(depth_mm, evidence.now_from_then, widening);
  const Tally still = tally(depth_mm, {}), moved = tally(depth_mm, evidence.now_from_then);
  const auto all = static_cast<double>(std::max<std::size_t>(1, landmarks_.size()));
  evidence.shift_m = evidence.now_from_then.translation_m.norm();
  evidence.angle_rad = vector_from_rotation(evidence.now_from_then.rotation).norm();
  evidence.comparable = moved.comparable() / all;
  evidence.agree_if_still = still.agree();
  evidence.agree_if_moved = moved.agree();
  evidence.gain = still.mean_misfit() - moved.mean_misfit();
  evidence.gone = static_cast<double>(still.gone) / std::max(1, still.readings);
  return evidence;
}

}  // namespace roomcast::alignment
