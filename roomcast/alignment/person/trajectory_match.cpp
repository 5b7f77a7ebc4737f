// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/person/trajectory_match.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>

#include "roomcast/geometry/dense_solvers.h"
#include "roomcast/geometry/rotations.h"

namespace roomcast::alignment {
namespace {

using Eigen::Vector2d;

/// A time at which both saw a head of the same height.
struct Moment {
  double time_s;
  Vector2d a, b;            // places
  Vector2d away_a, away_b;  // from each sensor, in its own frame
};

struct Motion {
  double turn_rad = 0;
  Vector2d shift = Vector2d::Zero();

  /// (x, z): a turn about y takes z towards x.
  [[nodiscard]] Vector2d turned(const Vector2d& v) const {
    const double c = std::cos(turn_rad), s = std::sin(turn_rad);
    return {c * v.x() + s * v.y(), -s * v.x() + c * v.y()};
  }
  [[nodiscard]] Vector2d operator()(const Vector2d& v) const { return turned(v) + shift; }
};

Vector2d on_floor(const Eigen::Vector3d& point) {
  return {point.x(), point.z()};
}

std::optional<HeadSighting> between(const HeadSighting& before, const HeadSighting& after,
                                    double time_s, const TrajectoryMatchOptions& options) {
  const double gap_s = after.time_s - before.time_s;
  if (gap_s > options.max_gap_s || (after.seen_m - before.seen_m).norm() > options.max_step_m)
    return std::nullopt;
  const double part = gap_s > 0 ? (time_s - before.time_s) / gap_s : 0;
  HeadSighting there = before;
  there.time_s = time_s;
  there.seen_m += part * (after.seen_m - before.seen_m);
  there.away = ((1 - part) * before.away + part * after.away).normalized();
  return there;
}

/// The heads that b saw at a time, its clock set forward by `late_s`.
std::vector<HeadSighting> seen_at(std::span<const HeadSighting> b, double time_s, double late_s,
                                  const TrajectoryMatchOptions& options) {
  std::vector<HeadSighting> seen;
  const double there_s = time_s - late_s;
  const auto after = std::ranges::lower_bound(b, there_s, {}, &HeadSighting::time_s);
  for (auto late = after; late != b.end() && late->time_s - there_s < options.max_gap_s; ++late) {
    if (late->time_s > after->time_s) break;  // interpolate to the next picture only
    for (auto early = after; early != b.begin();) {
      --early;
      if (there_s - early->time_s > options.max_gap_s) break;
      if (const auto here = between(*early, *late, there_s, options)) {
        seen.push_back(*here);
        break;
      }
    }
  }
  return seen;
}

std::vector<Moment> common_moments(std::span<const HeadSighting> a, std::span<const HeadSighting> b,
                                   double late_s, const TrajectoryMatchOptions& options) {
  std::vector<Moment> moments;
  for (const HeadSighting& here : a) {
    for (const HeadSighting& there : seen_at(b, here.time_s, late_s, options)) {
      if (std::abs(here.seen_m.y() - there.seen_m.y()) > options.same_height_m) continue;
      moments.push_back({here.time_s, on_floor(here.seen_m) + options.inside_m * here.away,
                         on_floor(there.seen_m) + options.inside_m * there.away, here.away,
                         there.away});
    }
  }
  return moments;
}

std::optional<Motion> motion_by(const Moment& one, const Moment& other,
                                const TrajectoryMatchOptions& options) {
  const Vector2d in_a = other.a - one.a, in_b = other.b - one.b;
  if (std::abs(other.time_s - one.time_s) < options.min_apart_s ||
      in_a.norm() < options.min_apart_m)
    return std::nullopt;
  if (std::abs(in_a.norm() - in_b.norm()) > options.same_distance_m) return std::nullopt;
  Motion motion;
  motion.turn_rad = std::atan2(in_b.y(), in_b.x()) - std::atan2(in_a.y(), in_a.x());
  motion.shift = 0.5 * (one.a + other.a) - motion.turned(0.5 * (one.b + other.b));
  return motion;
}

/// The moments that agree with the motion; of several at one time the closest.
std::vector<Moment> agreeing(std::span<const Moment> moments, const Motion& motion,
                             double max_distance_m) {
  std::vector<Moment> agree;
  const auto off = [&](const Moment& m) { return (motion(m.b) - m.a).norm(); };
  for (const Moment& moment : moments) {
    if (off(moment) > max_distance_m) continue;
    if (agree.empty() || agree.back().time_s != moment.time_s) {
      agree.push_back(moment);
    } else if (off(moment) < off(agree.back())) {
      agree.back() = moment;
    }
  }
  return agree;
}

/// Hypotheses from pairs of moments, spread evenly over all of them.
std::optional<Motion> most_agreed(std::span<const Moment> moments,
                                  const TrajectoryMatchOptions& options, std::size_t& most) {
  const std::size_t step = std::max<std::size_t>(1, moments.size() / options.tried_moments);
  std::optional<Motion> best;
  for (std::size_t i = 0; i < moments.size(); i += step) {
    for (std::size_t j = i + step; j < moments.size(); j += step) {
      const auto motion = motion_by(moments[i], moments[j], options);
      if (!motion) continue;
      const std::size_t count = agreeing(moments, *motion, options.max_distance_m).size();
      if (count <= most) continue;
      most = count;
      best = motion;
    }
  }
  return best;
}

/// Unknowns: turn, shift, and how much deeper inside than usual the heads' centres are, as seen by
/// a and by b.
using Vector5 = Eigen::Matrix<double, 5, 1>;
using Matrix5 = Eigen::Matrix<double, 5, 5>;

struct Fit {
  Motion motion;
  Vector2d deeper = Vector2d::Zero();  // of a, b
  Matrix5 covariance = Matrix5::Zero();
};

/// Covariance of a head's position, seen along `away`.
Eigen::Matrix2d sighting_covariance(const Vector2d& away, const TrajectoryMatchOptions& options) {
  const double along_m = options.along_sigma_m, across_m = options.across_sigma_m;
  const Vector2d across(-away.y(), away.x());
  return along_m * along_m * away * away.transpose() +
         across_m * across_m * across * across.transpose();
}

Fit improved(std::span<const Moment> moments, const Fit& fit, const TrajectoryMatchOptions& options,
             double weight_of_each) {
  Matrix5 information = Matrix5::Zero();
  Vector5 gradient = Vector5::Zero();
  for (int i = 0; i < 2; ++i) {
    const double expected = 1 / (options.inside_sigma_m * options.inside_sigma_m);
    information(3 + i, 3 + i) += expected;
    gradient(3 + i) += expected * fit.deeper(i);
  }
  for (const Moment& moment : moments) {
    const Vector2d turned = fit.motion.turned(moment.b + fit.deeper(1) * moment.away_b);
    const Vector2d away_b = fit.motion.turned(moment.away_b);
    const Vector2d residual = turned + fit.motion.shift - moment.a - fit.deeper(0) * moment.away_a;
    Eigen::Matrix<double, 2, 5> jacobian;
    jacobian.col(0) = Vector2d(turned.y(), -turned.x());
    jacobian.block<2, 2>(0, 1).setIdentity();
    jacobian.col(3) = -moment.away_a;
    jacobian.col(4) = away_b;
    const Eigen::Matrix2d precise =
        (sighting_covariance(moment.away_a, options) + sighting_covariance(away_b, options))
            .inverse();
    const double squared_sigmas = residual.dot(precise * residual);
    const double robust = 1 / std::pow(1 + squared_sigmas / 8, 2);  // Geman & McClure 1985
    information += weight_of_each * robust * jacobian.transpose() * precise * jacobian;
    gradient += weight_of_each * robust * jacobian.transpose() * precise * residual;
  }
  Fit better = fit;
  better.covariance = inverse_of(information);
  const Vector5 step = better.covariance * gradient;
  better.motion.turn_rad -= step(0);
  better.motion.shift -= step.segment<2>(1);
  better.deeper -= step.tail<2>();
  return better;
}

/// The total time of the agreeing moments.
double seconds_of(std::span<const Moment> moments, double max_pause_s) {
  double seconds = 0;
  for (std::size_t i = 1; i < moments.size(); ++i)
    seconds += std::min(max_pause_s, moments[i].time_s - moments[i - 1].time_s);
  return seconds;
}

/// Expected error of the middle of the walk.
double walk_error_m(const Fit& fit, std::span<const Moment> moments, double shape_sigma_m) {
  Vector2d middle = Vector2d::Zero();
  for (const Moment& moment : moments) middle += moment.b / static_cast<double>(moments.size());
  const Vector2d turned = fit.motion.turned(middle);
  Eigen::Matrix<double, 2, 5> by = Eigen::Matrix<double, 2, 5>::Zero();
  by.col(0) = Vector2d(turned.y(), -turned.x());
  by.block<2, 2>(0, 1).setIdentity();
  const double variance = (by * fit.covariance * by.transpose()).trace();
  return std::sqrt(variance + 2 * shape_sigma_m * shape_sigma_m);
}

RigidTransform transform_of(const Motion& motion) {
  RigidTransform transform;
  transform.rotation = rotation_about(Eigen::Vector3d::UnitY(), motion.turn_rad);
  transform.translation_m = {motion.shift.x(), 0, motion.shift.y()};
  return transform;
}

std::size_t times_in(std::span<const Moment> moments) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < moments.size(); ++i)
    count += i == 0 || moments[i].time_s != moments[i - 1].time_s;
  return count;
}

}  // namespace

HeadSighting head_sighting(const RigidTransform& level_from_depth, double time_s,
                           const Eigen::Vector3d& seen_in_depth_m) {
  HeadSighting sighting;
  sighting.time_s = time_s;
  sighting.seen_m = level_from_depth * seen_in_depth_m;
  const Vector2d ray = on_floor(sighting.seen_m - level_from_depth.translation_m);
  if (ray.norm() > 1e-6) sighting.away = ray.normalized();
  return sighting;
}

Result<TrajectoryMatch> match_walks(std::span<const HeadSighting> a,
                                    std::span<const HeadSighting> b,
                                    const TrajectoryMatchOptions& options) {
  const auto min_moments = static_cast<std::size_t>(options.min_moments);
  const auto moments = common_moments(a, b, 0, options);
  const std::size_t times = times_in(moments);
  if (times < min_moments)
    return unavailable(
        "no person has walked through its view and another sensor's at the same time yet");
  std::size_t most = 0;
  const auto motion = most_agreed(moments, options, most);
  if (!motion || most < min_moments)
    return unavailable("the person hardly moved; walk around where both sensors see you");
  if (static_cast<double>(most) < options.min_share * static_cast<double>(times))
    return unavailable("the sensors saw different people; let one person walk around alone");
  for (const double late_s : options.other_offsets_s) {
    std::size_t rival = 0;
    (void)most_agreed(common_moments(a, b, late_s, options), options, rival);
    if (static_cast<double>(rival) > options.max_rival_share * static_cast<double>(most))
      return unavailable(
          "the walk was too simple for one clear pose; walk a curve, stop, and turn");
  }
  Fit fit{*motion};
  std::vector<Moment> agree;
  for (int step = 0; step < options.refinements; ++step) {
    agree = agreeing(moments, fit.motion, options.max_distance_m);
    if (agree.size() < min_moments) return unavailable("the trajectories do not match; walk again");
    const double independent = seconds_of(agree, options.max_pause_s) / options.independent_s;
    fit = improved(agree, fit, options,
                   std::min(1.0, independent / static_cast<double>(agree.size())));
  }
  TrajectoryMatch match{transform_of(fit.motion),
                        1000 * walk_error_m(fit, agree, options.shape_sigma_m),
                        seconds_of(agree, options.max_pause_s), static_cast<int>(agree.size())};
  if (match.seconds < options.min_seconds)
    return unavailable("the person was seen too briefly; walk around for 20 s");
  if (match.expected_error_mm > options.max_error_mm)
    return unavailable("the walk was too short; walk around more widely");
  return match;
}

}  // namespace roomcast::alignment
