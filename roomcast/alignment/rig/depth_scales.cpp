// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/rig/depth_scales.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace roomcast::alignment {
namespace {

constexpr double kMaxJointShift_m = 0.3;  // of a pose by the fit; beyond it the fit has slid

/// Spread of a scale relative to the origin's: both are off.
double relative_sigma(const DepthScaleOptions& options) {
  return std::numbers::sqrt2 * options.fit.scale_sigma;
}

std::vector<ScaledPose> scaled_poses(std::span<const RefinedSensor> sensors) {
  std::vector<ScaledPose> poses;
  for (const RefinedSensor& sensor : sensors) poses.push_back({sensor.origin_from_sensor, 1});
  return poses;
}

/// The estimate, if it is determined and more likely than a sensor without an error: a calibrated
/// one's factor is 1, others' are spread by the prior (Bayes factor of both).
DepthScale accepted(double estimate, double standard_error, double uncalibrated_belief,
                    const DepthScaleOptions& options) {
  if (!(standard_error > 0) || standard_error > options.max_standard_error) return {};
  const double calibrated = options.calibrated * (1 - uncalibrated_belief);
  const double spread = std::hypot(relative_sigma(options), standard_error);
  const double at_one =
      calibrated / standard_error * std::exp(-0.5 * std::pow((estimate - 1) / standard_error, 2));
  const double elsewhere =
      (1 - calibrated) / spread * std::exp(-0.5 * std::pow((estimate - 1) / spread, 2));
  return {elsewhere > at_one ? estimate : 1, standard_error};
}

bool anything_moves(std::span<const RigPair> pairs) {
  return std::ranges::any_of(pairs, [](const RigPair& pair) {
    return !pair.candidates->a().instants.empty() && !pair.candidates->b().instants.empty();
  });
}

/// Of the scales, given what is known of them. Known ones are relative to the origin's.
std::vector<double> scale_sigmas(std::span<const RefinedSensor> sensors, std::size_t origin,
                                 std::span<const DepthScale> scales,
                                 const DepthScaleOptions& options) {
  std::vector<double> sigmas;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    const bool is_known = i < scales.size() && scales[i].standard_error > 0;
    sigmas.push_back(
        is_known ? scales[i].standard_error
                 : std::max(1e-4, options.fit.scale_sigma * sensors[i].uncalibrated_belief));
  }
  const bool any_is_known =
      std::ranges::any_of(scales, [](const DepthScale& scale) { return scale.standard_error > 0; });
  if (any_is_known) sigmas[origin] = 0;
  return sigmas;
}

bool has_slid(const JointFit& fit, std::span<const RefinedSensor> before) {
  for (std::size_t i = 0; i < before.size(); ++i) {
    const RigidTransform &now = fit.sensors[i].origin_from_sensor,
                         &then = before[i].origin_from_sensor;
    if (!((now.translation_m - then.translation_m).norm() < kMaxJointShift_m)) return true;
  }
  return false;
}

}  // namespace

std::vector<DepthScale> estimate_depth_scales(std::span<const RefinedSensor> sensors,
                                              std::size_t origin, std::span<const RigPair> pairs,
                                              const DepthScaleOptions& options,
                                              const ResidualOptions& residuals) {
  std::vector<DepthScale> found(sensors.size());
  if (!anything_moves(pairs)) return found;
  const JointTerms terms(sensors.size(), pairs, options.terms, residuals.surfaces);
  std::vector<double> sigmas(sensors.size(), relative_sigma(options));
  sigmas[origin] = 0;
  const JointFit fit =
      fit_jointly(terms, scaled_poses(sensors), origin, ScaleFit::kFree, sigmas, options.fit);
  if (has_slid(fit, sensors)) return found;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    if (i == origin || static_cast<double>(fit.instants[i]) < options.min_instants) continue;
    found[i] =
        accepted(fit.sensors[i].scale, fit.scale_sigma[i], sensors[i].uncalibrated_belief, options);
  }
  return in_common_scale(std::move(found), origin);
}

void refine_uncalibrated(std::size_t origin, std::span<const RigPair> pairs,
                         std::span<const DepthScale> scales, const DepthScaleOptions& options,
                         const ResidualOptions& residuals, std::vector<RefinedSensor>& sensors) {
  const JointTerms terms(sensors.size(), pairs, options.terms, residuals.surfaces);
  const std::vector<double> sigmas = scale_sigmas(sensors, origin, scales, options);
  JointFit fit =
      fit_jointly(terms, scaled_poses(sensors), origin, ScaleFit::kFixed, sigmas, options.fit);
  const bool keeps_poses = has_slid(fit, sensors);
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    if (!keeps_poses) sensors[i].origin_from_sensor = fit.sensors[i].origin_from_sensor;
    if (!sensors[i].covariance.isZero()) sensors[i].covariance = fit.covariance[i];
  }
}

}  // namespace roomcast::alignment
