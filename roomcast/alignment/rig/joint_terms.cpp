// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/rig/joint_terms.h"

#include <algorithm>
#include <cmath>

namespace roomcast::alignment {
namespace {

constexpr double kSlidePerReach = 4;  // along a still surface, as in surface_residuals.h
constexpr float kMinFeatureWeight = 0.05F;

/// Points of `source` are looked up in the still surface of `target`.
struct StillDirection {
  const DepthSurface& source;
  const DepthSurface& target;
  double source_scale, target_scale;
  RigidTransform target_from_source;
};

/// Calls visit(of_source, of_target, residual) for the points of the source that the target shows.
template <class Visit>
void for_each_still_partner(const StillDirection& way, double reach_m, std::size_t points,
                            float min_cosine, Visit visit) {
  const Eigen::Matrix3f rotation = way.target_from_source.rotation.cast<float>();
  const Eigen::Vector3f shift = way.target_from_source.translation_m.cast<float>();
  const auto from = static_cast<float>(way.source_scale), to = static_cast<float>(way.target_scale);
  const auto reach = static_cast<float>(reach_m);
  const auto& samples = way.source.samples;
  const std::size_t step = std::max<std::size_t>(1, samples.size() / points);
  for (std::size_t i = 0; i < samples.size(); i += step) {
    const Eigen::Vector3f point = rotation * (from * samples[i].point_m) + shift;
    Eigen::Vector2f pixel;
    if (!way.target.lens.project(point, pixel)) continue;
    const int u = static_cast<int>(std::lround(pixel.x()));
    const int v = static_cast<int>(std::lround(pixel.y()));
    if (u < 0 || v < 0 || u >= way.target.at.width() || v >= way.target.at.height()) continue;
    const SurfacePoint& seen = way.target.at.at(u, v);
    if (!(seen.normal.dot(rotation * samples[i].normal) >= min_cosine)) continue;
    const Eigen::Vector3f apart = point - to * seen.point_m;
    const float residual = seen.normal.dot(apart);
    if (std::abs(residual) > reach || apart.norm() > float(kSlidePerReach) * reach) continue;
    visit(samples[i], seen, double(residual));
  }
}

double still_sigma_m(const DepthSurface& a, const SurfacePoint& in_a, const DepthSurface& b,
                     const SurfacePoint& in_b) {
  const auto of_a = static_cast<double>(a.options.noise.sigma_m(in_a.point_m.z()));
  const auto of_b = static_cast<double>(b.options.noise.sigma_m(in_b.point_m.z()));
  return std::sqrt(0.5 * (of_a * of_a + of_b * of_b));
}

/// Both places must be the same in all directions.
void add_places(const Eigen::Vector3d& a_m, const Eigen::Vector3d& b_m,
                const Eigen::Vector3d& apart_m, double sigma_m, std::vector<JointTerm>& terms) {
  for (int axis = 0; axis < 3; ++axis)
    terms.push_back({a_m, b_m, Eigen::Vector3d::Unit(axis), apart_m[axis], sigma_m});
}

}  // namespace

JointTerms::JointTerms(std::size_t sensors, std::span<const RigPair> pairs,
                       const JointTermOptions& options, const SurfaceResidualOptions& still)
    : pairs_(pairs),
      options_(options),
      still_(still),
      views_(sensors),
      surfaces_(sensors),
      round_(sensors) {
  for (const RigPair& pair : pairs) {
    views_[pair.first] = &pair.candidates->a();
    views_[pair.second] = &pair.candidates->b();
  }
  for (std::size_t i = 0; i < sensors; ++i) {
    if (!views_[i]) continue;
    surfaces_[i] = moving_surfaces(*views_[i], options.moving_surface);
    round_[i] = round_things(surfaces_[i], options.round);
  }
}

std::vector<JointTerm> JointTerms::of(const RigPair& pair, Evidence kind,
                                      std::span<const ScaledPose> poses,
                                      const JointReach& reach) const {
  if (kind == Evidence::kStill) return still_terms(pair, poses, reach);
  if (kind == Evidence::kFeatures) return feature_terms(pair, poses, reach);
  return kind == Evidence::kMoving ? moving_terms(pair, poses, reach)
                                   : round_terms(pair, poses, reach);
}

std::vector<JointTerm> JointTerms::still_terms(const RigPair& pair,
                                               std::span<const ScaledPose> poses,
                                               const JointReach& reach) const {
  const ScaledPose &of_a = poses[pair.first], &of_b = poses[pair.second];
  const DepthSurface &a = pair.candidates->a().surface, &b = pair.candidates->b().surface;
  const RigidTransform a_from_b = of_a.origin_from_sensor.inverse() * of_b.origin_from_sensor;
  std::vector<JointTerm> terms;
  for_each_still_partner(
      {b, a, of_b.scale, of_a.scale, a_from_b}, reach.still_m, options_.points, still_.min_cosine,
      [&](const SurfacePoint& in_b, const SurfacePoint& in_a, double residual_m) {
        terms.push_back({in_a.point_m.cast<double>(), in_b.point_m.cast<double>(),
                         of_a.origin_from_sensor.rotation * in_a.normal.cast<double>(), residual_m,
                         still_sigma_m(a, in_a, b, in_b)});
      });
  for_each_still_partner(
      {a, b, of_a.scale, of_b.scale, a_from_b.inverse()}, reach.still_m, options_.points,
      still_.min_cosine,
      [&](const SurfacePoint& in_a, const SurfacePoint& in_b, double residual_m) {
        terms.push_back({in_a.point_m.cast<double>(), in_b.point_m.cast<double>(),
                         of_b.origin_from_sensor.rotation * in_b.normal.cast<double>(), -residual_m,
                         still_sigma_m(a, in_a, b, in_b)});
      });
  return terms;
}

std::vector<JointTerm> JointTerms::feature_terms(const RigPair& pair,
                                                 std::span<const ScaledPose> poses,
                                                 const JointReach& reach) const {
  std::vector<JointTerm> terms;
  for (const PointMatch& match : pair.candidates->matches()) {
    const Eigen::Vector3d a_m = match.a_m.cast<double>(), b_m = match.b_m.cast<double>();
    const Eigen::Vector3d apart_m = poses[pair.second].at(b_m) - poses[pair.first].at(a_m);
    if (!(apart_m.norm() <= reach.still_m)) continue;
    const double weight = double(std::max(kMinFeatureWeight, match.weight));
    add_places(a_m, b_m, apart_m, options_.feature_sigma_m / std::sqrt(weight), terms);
  }
  return terms;
}

MovingPartners JointTerms::moving(const RigPair& pair, std::span<const ScaledPose> poses,
                                  const JointReach& reach) const {
  const ScaledPose &of_a = poses[pair.first], &of_b = poses[pair.second];
  return moving_partners({pair.candidates->a().surface.lens, surfaces_[pair.first], of_a.scale},
                         {pair.candidates->b().surface.lens, surfaces_[pair.second], of_b.scale},
                         of_a.origin_from_sensor.inverse() * of_b.origin_from_sensor,
                         static_cast<float>(reach.moving_m), options_.moving);
}

std::vector<JointTerm> JointTerms::moving_terms(const RigPair& pair,
                                                std::span<const ScaledPose> poses,
                                                const JointReach& reach) const {
  const Eigen::Matrix3d& rotation = poses[pair.first].origin_from_sensor.rotation;
  std::vector<JointTerm> terms;
  for (const SurfacePartner& partner : moving(pair, poses, reach).partners)
    terms.push_back({partner.a_m.cast<double>(), partner.b_m.cast<double>(),
                     rotation * partner.normal.cast<double>(), double(partner.residual_m),
                     std::sqrt(double(partner.variance_m2))});
  return terms;
}

std::vector<JointTerm> JointTerms::round_terms(const RigPair& pair,
                                               std::span<const ScaledPose> poses,
                                               const JointReach& reach) const {
  const ScaledPose &of_a = poses[pair.first], &of_b = poses[pair.second];
  std::vector<JointTerm> terms;
  for (const RoundThing& in_a : round_[pair.first]) {
    for (const RoundThing& in_b : round_[pair.second]) {
      if (std::abs(in_a.time_s - in_b.time_s) > options_.moving.max_apart_s) continue;
      const double radius_a = of_a.scale * in_a.radius_m, radius_b = of_b.scale * in_b.radius_m;
      if (std::abs(radius_a - radius_b) >
          options_.max_radius_difference * std::min(radius_a, radius_b))
        continue;
      const Eigen::Vector3d apart_m = of_b.at(in_b.center_m) - of_a.at(in_a.center_m);
      if (!(apart_m.norm() <= reach.moving_m)) continue;
      add_places(in_a.center_m, in_b.center_m, apart_m, options_.round_sigma_m, terms);
    }
  }
  return terms;
}

std::size_t JointTerms::common_instants(const RigPair& pair, std::span<const ScaledPose> poses,
                                        const JointReach& reach) const {
  return moving(pair, poses, reach).instants;
}

}  // namespace roomcast::alignment
