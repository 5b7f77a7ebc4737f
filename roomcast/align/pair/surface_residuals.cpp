// SPDX-License-Identifier: Apache-2.0
#include "roomcast/align/pair/surface_residuals.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "roomcast/align/view/depth_noise.h"

namespace roomcast::align {
namespace {

constexpr float kAlike = 0.8F;       // cosine between normals
constexpr float kSlidePerReach = 4;  // along the surface a partner may lie further away
constexpr double kMostIndependent = 1500;
constexpr double kMedianOfNormal = 0.6745;  // of the absolute value, in sigmas
constexpr double kLeastNoise = 0.2, kMostNoise = 1.5;

/// One direction of a pair: points of `source` are looked up in `target`.
struct Direction {
  const DepthSurface& source;
  const DepthSurface& target;
  Eigen::Matrix3f rotation;  // target from source
  Eigen::Vector3f shift;

  Direction(const DepthSurface& from, const DepthSurface& to, const RigidTransform& to_from_from)
      : source(from),
        target(to),
        rotation(to_from_from.rotation.cast<float>()),
        shift(to_from_from.translation_m.cast<float>()) {}
};

/// A point of the source, in both frames, and its distance along the normal of what it is compared
/// with.
struct Partners {
  Eigen::Vector3f in_source, in_target, normal_in_target;
  float residual_m;
  double variance_m2;
};

template <class Visit>
void for_each_partner(const Direction& way, const SurfaceResidualOptions& options, Visit visit) {
  const auto& samples = way.source.samples;
  const std::size_t step = std::max<std::size_t>(1, samples.size() / options.points);
  const float slide = kSlidePerReach * options.reach_m;
  for (std::size_t i = 0; i < samples.size(); i += step) {
    const Eigen::Vector3f& from = samples[i].point_m;
    const Eigen::Vector3f point = way.rotation * from + way.shift;
    Eigen::Vector2f pixel;
    if (!way.target.lens.project(point, pixel)) continue;
    const int u = static_cast<int>(std::lround(pixel.x()));
    const int v = static_cast<int>(std::lround(pixel.y()));
    if (u < 0 || v < 0 || u >= way.target.at.width() || v >= way.target.at.height()) continue;
    const SurfacePoint& seen = way.target.at.at(u, v);
    if (seen.normal.dot(way.rotation * samples[i].normal) < kAlike) continue;
    const Eigen::Vector3f apart = point - seen.point_m;
    const float residual = seen.normal.dot(apart);
    if (std::abs(residual) > options.reach_m || apart.squaredNorm() > slide * slide) continue;
    const double here = double(depth_sigma_m(from.z())),
                 there = double(depth_sigma_m(seen.point_m.z()));
    visit(Partners{from, point, seen.normal, residual, 0.5 * (here * here + there * there)});
  }
}

void add(PairEquations& sum, const PairVector& jacobian, const Partners& partners, double noise) {
  const double residual = double(partners.residual_m);
  const double variance = noise * noise * partners.variance_m2;
  sum.add(jacobian, residual, robust_weight(residual / std::sqrt(variance)) / variance);
}

}  // namespace

PairEquations surface_equations(const DepthSurface& a, const DepthSurface& b,
                                const RigidTransform& a_from_b,
                                const SurfaceResidualOptions& options) {
  PairEquations sum;
  PairVector jacobian = PairVector::Zero();
  for_each_partner(Direction(b, a, a_from_b), options, [&](const Partners& p) {
    const Eigen::Vector3d n = p.normal_in_target.cast<double>();
    const Eigen::Vector3d x = p.in_target.cast<double>();
    jacobian.head<6>() << x.cross(n), n;
    add(sum, jacobian, p, options.noise);
  });
  for_each_partner(Direction(a, b, a_from_b.inverse()), options, [&](const Partners& p) {
    const Eigen::Vector3d n = a_from_b.rotation * p.normal_in_target.cast<double>();
    const Eigen::Vector3d x = p.in_source.cast<double>();
    jacobian.head<6>() << -x.cross(n), -n;
    add(sum, jacobian, p, options.noise);
  });
  PairEquations capped;
  capped.add(sum, std::min(1.0, kMostIndependent / std::max(1, sum.terms)));
  return capped;
}

double surface_noise(const DepthSurface& a, const DepthSurface& b, const RigidTransform& a_from_b,
                     const SurfaceResidualOptions& options) {
  std::vector<double> sigmas;
  const auto keep = [&](const Partners& partners) {
    sigmas.push_back(std::abs(double(partners.residual_m)) / std::sqrt(partners.variance_m2));
  };
  for_each_partner(Direction(b, a, a_from_b), options, keep);
  for_each_partner(Direction(a, b, a_from_b.inverse()), options, keep);
  if (sigmas.empty()) return kMostNoise;
  const auto middle = sigmas.begin() + static_cast<std::ptrdiff_t>(sigmas.size() / 2);
  std::nth_element(sigmas.begin(), middle, sigmas.end());
  return std::clamp(*middle / kMedianOfNormal, kLeastNoise, kMostNoise);
}

std::vector<float> surface_residuals_m(const DepthSurface& a, const DepthSurface& b,
                                       const RigidTransform& a_from_b,
                                       const SurfaceResidualOptions& options) {
  std::vector<float> residuals;
  const auto keep = [&](const Partners& partners) { residuals.push_back(partners.residual_m); };
  for_each_partner(Direction(b, a, a_from_b), options, keep);
  for_each_partner(Direction(a, b, a_from_b.inverse()), options, keep);
  return residuals;
}

}  // namespace roomcast::align
