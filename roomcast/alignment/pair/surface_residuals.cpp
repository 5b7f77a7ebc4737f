// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/surface_residuals.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

namespace roomcast::alignment {
namespace {

constexpr double kMedianOfNormal = 0.6745;  // median absolute value, in sigmas

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

/// Calls `visit(source point, target point, residual)` for all partners within reach.
template <class Visit>
void for_each_partner(const Direction& way, const SurfaceReach& reach,
                      const SurfaceResidualOptions& options, Visit visit) {
  const auto& samples = way.source.samples;
  const std::size_t step = std::max<std::size_t>(1, samples.size() / reach.points);
  const float reach_m = reach.reach_m, min_cosine = options.min_cosine;
  const float slide = options.slide_per_reach * reach_m;
  for (std::size_t i = 0; i < samples.size(); i += step) {
    const Eigen::Vector3f point = way.rotation * samples[i].point_m + way.shift;
    Eigen::Vector2f pixel;
    if (!way.target.lens.project(point, pixel)) continue;
    const int u = static_cast<int>(std::lround(pixel.x()));
    const int v = static_cast<int>(std::lround(pixel.y()));
    if (u < 0 || v < 0 || u >= way.target.at.width() || v >= way.target.at.height()) continue;
    const SurfacePoint& seen = way.target.at.at(u, v);
    if (seen.normal.dot(way.rotation * samples[i].normal) < min_cosine) continue;
    const Eigen::Vector3f apart = point - seen.point_m;
    const float residual = seen.normal.dot(apart);
    if (std::abs(residual) > reach_m || apart.squaredNorm() > slide * slide) continue;
    visit(samples[i], seen, residual);
  }
}

/// Of the readings of two surfaces.
struct PartnerNoise {
  DepthNoiseOptions of_a, of_b;

  [[nodiscard]] float variance_m2(const SurfacePoint& a, const SurfacePoint& b) const {
    const float here = of_a.sigma_m(a.point_m.z()), there = of_b.sigma_m(b.point_m.z());
    return 0.5F * (here * here + there * there);
  }
};

/// Unknowns of surface residuals: motion and both sensors' depth. Colour shifts do not affect
/// surfaces.
constexpr std::array<Eigen::Index, 10> kKnown = {
    0, 1, 2, 3, 4, 5, kOfA + kDepth, kOfA + kDepth + 1, kOfB + kDepth, kOfB + kDepth + 1};
using SurfaceUnknowns = Eigen::Matrix<double, 10, 1>;

PairVector spread(const SurfaceUnknowns& known) {
  PairVector all = PairVector::Zero();
  for (std::size_t i = 0; i < kKnown.size(); ++i)
    all(kKnown[i]) = known(static_cast<Eigen::Index>(i));
  return all;
}

struct KnownEquations {
  Eigen::Matrix<double, 10, 10> information = Eigen::Matrix<double, 10, 10>::Zero();
  SurfaceUnknowns gradient = SurfaceUnknowns::Zero();

  [[nodiscard]] PairEquations expanded(double factor, int terms) const {
    PairEquations all;
    all.gradient = factor * spread(gradient);
    for (std::size_t i = 0; i < kKnown.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      for (std::size_t j = 0; j < kKnown.size(); ++j)
        all.information(kKnown[i], kKnown[j]) =
            factor * information(row, static_cast<Eigen::Index>(j));
    }
    all.terms = terms;
    return all;
  }
};

SurfaceUnknowns jacobian_of(const SurfacePartner& partner, const RigidTransform& a_from_b) {
  const Eigen::Vector3d n = partner.normal.cast<double>();
  const Eigen::Vector3d a = partner.a_m.cast<double>(), b = partner.b_m.cast<double>();
  const Eigen::Vector3d turned = a_from_b.rotation * b;
  const double by_a = -n.dot(a), by_b = n.dot(turned);
  SurfaceUnknowns jacobian;
  jacobian << (turned + a_from_b.translation_m).cross(n), n, by_a / a.z(), by_a, by_b / b.z(), by_b;
  return jacobian;
}

double weight_of(const SurfacePartner& partner, double noise) {
  const double variance = noise * noise * double(partner.variance_m2);
  return robust_weight(double(partner.residual_m) / std::sqrt(variance)) / variance;
}

/// Factor by which all partners count as no more than `most`.
double share_that_counts(std::size_t partners, double most) {
  return std::min(1.0, most / static_cast<double>(std::max<std::size_t>(1, partners)));
}

}  // namespace

std::vector<SurfacePartner> surface_partners(const DepthSurface& a, const DepthSurface& b,
                                             const RigidTransform& a_from_b,
                                             const SurfaceReach& reach,
                                             const SurfaceResidualOptions& options) {
  const PartnerNoise noise{a.options.noise, b.options.noise};
  std::vector<SurfacePartner> partners;
  const Eigen::Matrix3f rotation = a_from_b.rotation.cast<float>();
  for_each_partner(Direction(b, a, a_from_b), reach, options,
                   [&](const SurfacePoint& of_b, const SurfacePoint& of_a, float residual) {
                     partners.push_back({of_a.point_m, of_b.point_m, of_a.normal, residual,
                                         noise.variance_m2(of_a, of_b)});
                   });
  for_each_partner(Direction(a, b, a_from_b.inverse()), reach, options,
                   [&](const SurfacePoint& of_a, const SurfacePoint& of_b, float residual) {
                     partners.push_back({of_a.point_m, of_b.point_m, rotation * of_b.normal,
                                         -residual, noise.variance_m2(of_a, of_b)});
                   });
  return partners;
}

PairEquations surface_equations(std::span<const SurfacePartner> partners,
                                const RigidTransform& a_from_b, double noise,
                                const SurfaceResidualOptions& options) {
  KnownEquations sum;
  for (const SurfacePartner& partner : partners) {
    const double weight = weight_of(partner, noise);
    const SurfaceUnknowns jacobian = jacobian_of(partner, a_from_b);
    sum.information.noalias() += weight * jacobian * jacobian.transpose();
    sum.gradient += weight * double(partner.residual_m) * jacobian;
  }
  return sum.expanded(share_that_counts(partners.size(), options.max_independent),
                      static_cast<int>(partners.size()));
}

void add_surface_scores(std::span<const SurfacePartner> partners, const RigidTransform& a_from_b,
                        double noise, PairScores& scores, const SurfaceResidualOptions& options) {
  const double factor = share_that_counts(partners.size(), options.max_independent);
  for (const SurfacePartner& partner : partners) {
    const double weight = factor * weight_of(partner, noise);
    const double residual_m = double(partner.residual_m);
    scores.add_surface(partner.a_m.cast<double>(), partner.b_m.cast<double>(),
                       weight * residual_m * spread(jacobian_of(partner, a_from_b)), residual_m,
                       weight);
  }
}

double surface_noise(std::span<const SurfacePartner> partners,
                     const SurfaceResidualOptions& options) {
  if (partners.empty()) return options.max_noise;
  std::vector<double> sigmas;
  for (const SurfacePartner& partner : partners)
    sigmas.push_back(double(std::abs(partner.residual_m) / std::sqrt(partner.variance_m2)));
  const auto middle = sigmas.begin() + static_cast<std::ptrdiff_t>(sigmas.size() / 2);
  std::nth_element(sigmas.begin(), middle, sigmas.end());
  return std::clamp(*middle / kMedianOfNormal, options.min_noise, options.max_noise);
}

}  // namespace roomcast::alignment
