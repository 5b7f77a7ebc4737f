// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/rig/joint_fit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Geometry>

#include "roomcast/geometry/dense_solvers.h"

namespace roomcast::alignment {
namespace {

/// Unknowns of a sensor: motion (6), logarithm of the scale, then its lens: logarithm of the focal
/// length, optical centre as tangents.
constexpr Eigen::Index kScale = 6, kLens = 7, kUnknowns = 10;
constexpr double kFixedInformation = 1e12;
constexpr double kMedianOfNormalNoise = 0.6745;

using SensorVector = Eigen::Matrix<double, kUnknowns, 1>;

Eigen::Index first_of(std::size_t sensor) {
  return kUnknowns * static_cast<Eigen::Index>(sensor);
}

/// Derivative of a place along `direction` by the unknowns of the sensor that measured it.
SensorVector place_by_unknowns(const ScaledPose& pose, const Eigen::Vector3d& measured_m,
                               const Eigen::Vector3d& direction) {
  const Eigen::Vector3d scaled = pose.scale * measured_m;
  const Eigen::Vector3d along = pose.origin_from_sensor.rotation.transpose() * direction;
  SensorVector by;
  by.head<3>() = (pose.origin_from_sensor * scaled).cross(direction);
  by.segment<3>(3) = direction;
  by(kScale) = along.dot(scaled);
  by(kLens) = -along.x() * scaled.x() - along.y() * scaled.y();
  by(kLens + 1) = -along.x() * scaled.z();
  by(kLens + 2) = -along.y() * scaled.z();
  return by;
}

/// Derivatives of the term's residual by the unknowns of both sensors. Residuals count in units of
/// what was measured: else smaller scales would fit better, because they make residuals smaller.
struct TermDerivatives {
  SensorVector by_a, by_b;

  TermDerivatives(const JointTerm& term, const ScaledPose& of_a, const ScaledPose& of_b)
      : by_a(-place_by_unknowns(of_a, term.a_m, term.direction)),
        by_b(place_by_unknowns(of_b, term.b_m, term.direction)) {
    by_a(kScale) -= 0.5 * term.residual_m;
    by_b(kScale) -= 0.5 * term.residual_m;
  }
};

using Patch = std::pair<std::size_t, int>;  // of a sensor's picture

struct System {
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;
  std::map<Patch, Eigen::VectorXd> scores;  // only where asked for

  explicit System(std::size_t sensors)
      : information(Eigen::MatrixXd::Zero(first_of(sensors), first_of(sensors))),
        gradient(Eigen::VectorXd::Zero(first_of(sensors))) {}
};

/// Median of the residuals, in sigmas of a normal distribution.
double noise_of(std::span<const JointTerm> terms) {
  std::vector<double> sigmas;
  for (const JointTerm& term : terms) sigmas.push_back(std::abs(term.residual_m) / term.sigma_m);
  const auto middle = sigmas.begin() + static_cast<std::ptrdiff_t>(sigmas.size() / 2);
  std::nth_element(sigmas.begin(), middle, sigmas.end());
  return *middle / kMedianOfNormalNoise;
}

class JointSystem {
 public:
  JointSystem(const JointTerms& terms, std::size_t origin, const JointFitOptions& options)
      : terms_(terms), origin_(origin), options_(options) {}

  [[nodiscard]] System at(std::span<const ScaledPose> poses, const JointReach& reach,
                          bool with_scores) const {
    System system(poses.size());
    for (const RigPair& pair : terms_.pairs()) {
      for (const Evidence kind : kEvidence) {
        const std::vector<JointTerm> terms = terms_.of(pair, kind, poses, reach);
        if (!terms.empty()) add(pair, kind, terms, poses, with_scores, system);
      }
    }
    return system;
  }

  /// Information of the priors; unknowns that are fixed have very much of it.
  [[nodiscard]] Eigen::VectorXd priors(std::size_t sensors, std::span<const double> scale_sigmas,
                                       bool free_scales, bool free_lenses) const {
    Eigen::VectorXd prior = Eigen::VectorXd::Zero(first_of(sensors));
    for (std::size_t i = 0; i < sensors; ++i) {
      const Eigen::Index k = first_of(i);
      if (i == origin_ || !terms_.view(i)) prior.segment<6>(k).setConstant(kFixedInformation);
      prior(k + kScale) =
          free_scales && scale_sigmas[i] > 0 ? 1 / std::pow(scale_sigmas[i], 2) : kFixedInformation;
      prior.segment<3>(k + kLens).setConstant(kFixedInformation);
      if (free_lenses && terms_.view(i)) prior.segment<3>(k + kLens) = lens_prior(i);
    }
    return prior;
  }

 private:
  [[nodiscard]] Eigen::Vector3d lens_prior(std::size_t sensor) const {
    const CameraIntrinsics& camera = terms_.view(sensor)->surface.camera;
    return {1 / std::pow(options_.focal_sigma, 2),
            std::pow(camera.fx / options_.center_sigma_px, 2),
            std::pow(camera.fy / options_.center_sigma_px, 2)};
  }

  [[nodiscard]] std::pair<Patch, Patch> patches_of(const RigPair& pair,
                                                   const JointTerm& term) const {
    return {{pair.first, patch_of(term.a_m, options_.patches)},
            {pair.second, patch_of(term.b_m, options_.patches)}};
  }

  /// Adds the evidence of one kind. The weight of all that is in one patch is that of one
  /// observation with the variance of the smooth errors, and its noise.
  void add(const RigPair& pair, Evidence kind, std::span<const JointTerm> terms,
           std::span<const ScaledPose> poses, bool with_scores, System& system) const {
    const bool is_moving = kind == Evidence::kMoving || kind == Evidence::kRound;
    const double noise =
        std::clamp(noise_of(terms), is_moving ? options_.min_moving_noise : options_.min_noise,
                   options_.max_noise);
    const double shape = kind == Evidence::kStill ? 0 : options_.shape_sigma_m;
    const double smooth_m2 = std::pow(std::hypot(options_.smooth_sigma_m, shape), 2);
    std::vector<double> weights;
    std::map<Patch, double> of_patches;
    for (const JointTerm& term : terms) {
      const double sigma_m = noise * term.sigma_m;
      weights.push_back(robust_weight(term.residual_m / sigma_m) / (sigma_m * sigma_m));
      const auto [in_a, in_b] = patches_of(pair, term);
      of_patches[in_a] += weights.back();
      of_patches[in_b] += weights.back();
    }
    for (std::size_t i = 0; i < terms.size(); ++i) {
      const auto [in_a, in_b] = patches_of(pair, terms[i]);
      const double counts =
          0.5 / (1 + smooth_m2 * of_patches[in_a]) + 0.5 / (1 + smooth_m2 * of_patches[in_b]);
      add_term(pair, terms[i], counts * weights[i], poses, system);
      if (with_scores) add_scores(pair, terms[i], counts * weights[i], poses, system);
    }
  }

  void add_term(const RigPair& pair, const JointTerm& term, double weight,
                std::span<const ScaledPose> poses, System& system) const {
    const Eigen::Index a = first_of(pair.first), b = first_of(pair.second);
    const auto [by_a, by_b] = TermDerivatives(term, poses[pair.first], poses[pair.second]);
    system.information.block<kUnknowns, kUnknowns>(a, a) += weight * by_a * by_a.transpose();
    system.information.block<kUnknowns, kUnknowns>(b, b) += weight * by_b * by_b.transpose();
    const Eigen::Matrix<double, kUnknowns, kUnknowns> between = weight * by_a * by_b.transpose();
    system.information.block<kUnknowns, kUnknowns>(a, b) += between;
    system.information.block<kUnknowns, kUnknowns>(b, a) += between.transpose();
    system.gradient.segment<kUnknowns>(a) += weight * term.residual_m * by_a;
    system.gradient.segment<kUnknowns>(b) += weight * term.residual_m * by_b;
  }

  void add_scores(const RigPair& pair, const JointTerm& term, double weight,
                  std::span<const ScaledPose> poses, System& system) const {
    const auto [by_a, by_b] = TermDerivatives(term, poses[pair.first], poses[pair.second]);
    const auto [in_a, in_b] = patches_of(pair, term);
    for (const Patch& patch : {in_a, in_b}) {
      Eigen::VectorXd& score = system.scores[patch];
      if (score.size() == 0) score.setZero(system.gradient.size());
      score.segment<kUnknowns>(first_of(pair.first)) += weight * term.residual_m * by_a;
      score.segment<kUnknowns>(first_of(pair.second)) += weight * term.residual_m * by_b;
    }
  }

  const JointTerms& terms_;
  std::size_t origin_;
  const JointFitOptions& options_;
};

Eigen::MatrixXd inverse_with(const Eigen::MatrixXd& information, const Eigen::VectorXd& prior) {
  Eigen::MatrixXd matrix = information;
  matrix.diagonal() += prior;
  return solve_symmetric(matrix, Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols()));
}

void move(const Eigen::VectorXd& step, std::vector<ScaledPose>& poses) {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const SensorVector of_sensor = step.segment<kUnknowns>(first_of(i));
    poses[i].origin_from_sensor = step_transform(of_sensor.head<6>()) * poses[i].origin_from_sensor;
    poses[i].scale *= std::exp(of_sensor(kScale));
  }
}

bool is_held(const Eigen::VectorXd& prior, Eigen::Index unknown) {
  return prior(unknown) >= kFixedInformation;
}

/// Leaves out what all held scales have in common, if the scale of no sensor in view is exact.
void leave_out_common_scale(const Eigen::VectorXd& prior, const Eigen::VectorXd& prior_of_all,
                            Eigen::MatrixXd& covariance) {
  std::vector<Eigen::Index> scales;
  for (Eigen::Index i = 0; i < prior.size(); i += kUnknowns) {
    if (is_held(prior_of_all, i + kLens)) continue;  // in no pair
    if (!is_held(prior, i + kScale) || is_held(prior_of_all, i + kScale)) return;
    scales.push_back(i + kScale);
  }
  if (scales.empty()) return;
  Eigen::MatrixXd differences = Eigen::MatrixXd::Identity(prior.size(), prior.size());
  for (const Eigen::Index i : scales)
    for (const Eigen::Index j : scales) differences(i, j) -= 1 / static_cast<double>(scales.size());
  covariance = differences * covariance * differences.transpose();
}

/// Covariance of all unknowns of a fit: the larger one of the model's and of what patches say
/// (Liang & Zeger 1986), and the effect of what is held though it is not known exactly.
Eigen::MatrixXd covariance_of(const System& system, const Eigen::VectorXd& prior,
                              const Eigen::VectorXd& prior_of_all) {
  const Eigen::MatrixXd model = inverse_with(system.information, prior);
  Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(model.rows(), model.cols());
  // Every term is in a patch of each sensor, so each counts half.
  for (const auto& [patch, score] : system.scores) spread += 0.5 * score * score.transpose();
  for (Eigen::Index i = 0; i < prior.size(); ++i)
    if (prior(i) < kFixedInformation) spread(i, i) += prior(i);
  Eigen::MatrixXd covariance = model;
  const Eigen::MatrixXd by_patches = model * spread * model;
  for (Eigen::Index i = 0; i < model.rows(); i += kUnknowns) {
    const auto of = [&](const Eigen::MatrixXd& matrix) {
      return matrix.block<kUnknowns, kUnknowns>(i, i).trace();
    };
    if (of(by_patches) > of(model))
      covariance.block<kUnknowns, kUnknowns>(i, i) = by_patches.block<kUnknowns, kUnknowns>(i, i);
  }
  // The posterior of unknowns that are held here and free in `prior_of_all`, carried over.
  const Eigen::MatrixXd of_all = inverse_with(system.information, prior_of_all);
  Eigen::MatrixXd held = Eigen::MatrixXd::Zero(model.rows(), model.cols());
  for (Eigen::Index i = 0; i < prior.size(); ++i) {
    if (!is_held(prior, i) || is_held(prior_of_all, i)) continue;
    for (Eigen::Index j = 0; j < prior.size(); ++j)
      if (is_held(prior, j) && !is_held(prior_of_all, j)) held(i, j) = of_all(i, j);
  }
  leave_out_common_scale(prior, prior_of_all, held);
  const Eigen::MatrixXd carried = model * system.information;
  return covariance + carried * held * carried.transpose();
}

std::vector<std::size_t> moving_instants(const JointTerms& terms, std::span<const ScaledPose> poses,
                                         const JointReach& reach) {
  std::vector<std::size_t> instants(poses.size());
  for (const RigPair& pair : terms.pairs()) {
    const std::size_t common = terms.common_instants(pair, poses, reach);
    instants[pair.first] = std::max(instants[pair.first], common);
    instants[pair.second] = std::max(instants[pair.second], common);
  }
  return instants;
}

}  // namespace

JointFit fit_jointly(const JointTerms& terms, std::vector<ScaledPose> start, std::size_t origin,
                     ScaleFit scales, std::span<const double> scale_sigmas,
                     const JointFitOptions& options) {
  const std::size_t sensors = start.size();
  const JointSystem equations(terms, origin, options);
  const bool is_free = scales == ScaleFit::kFree;
  const Eigen::VectorXd prior = equations.priors(sensors, scale_sigmas, is_free, false);
  std::vector<ScaledPose> poses = std::move(start);
  JointReach reach = options.first;
  for (int i = 0; i < options.steps; ++i) {
    System system = equations.at(poses, reach, false);
    if (is_free) {
      for (std::size_t k = 0; k < sensors; ++k)
        if (scale_sigmas[k] > 0)
          system.gradient(first_of(k) + kScale) +=
              std::log(poses[k].scale) / std::pow(scale_sigmas[k], 2);
    }
    system.information.diagonal() += prior;
    move(solve_symmetric(system.information, -system.gradient), poses);
    reach.still_m = std::max(options.last.still_m, options.shrink * reach.still_m);
    reach.moving_m = std::max(options.last.moving_m, options.shrink * reach.moving_m);
  }
  const System system = equations.at(poses, options.last, true);
  const Eigen::MatrixXd covariance =
      covariance_of(system, prior, equations.priors(sensors, scale_sigmas, true, true));
  JointFit fit{std::move(poses), {}, {}, {}};
  fit.instants = moving_instants(terms, fit.sensors, options.last);
  for (std::size_t i = 0; i < sensors; ++i) {
    const Eigen::Index k = first_of(i);
    const bool held = i == origin || !terms.view(i);
    const double factor = held ? 0 : options.unmodelled * options.unmodelled;
    fit.covariance.emplace_back(factor * covariance.block<6, 6>(k, k));
    const bool is_known = !is_free || !terms.view(i) || !(scale_sigmas[i] > 0);
    fit.scale_sigma.push_back(is_known ? 0 : std::sqrt(covariance(k + kScale, k + kScale)));
  }
  return fit;
}

}  // namespace roomcast::alignment
