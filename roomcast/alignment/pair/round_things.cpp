// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/round_things.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "roomcast/geometry/dense_solvers.h"

namespace roomcast::alignment {
namespace {

constexpr std::array<double, 4> kFirstRadii_m = {0.09, 0.14, 0.2, 0.28};
constexpr int kSphereSteps = 6;
constexpr double kInside = 1.25;         // radii: points that could belong to the thing
constexpr double kSphereDamping = 1e-3;  // of a point's information

struct Sphere {
  Eigen::Vector3d center_m;
  double radius_m;
};

struct SphereFit {
  Sphere sphere;
  int points = 0, inside = 0;  // that fit; within reach of the sphere or inside it
  double squares = 0;
  Eigen::Vector3d outward = Eigen::Vector3d::Zero();  // sum of unit vectors

  [[nodiscard]] double rms_m() const { return std::sqrt(squares / points); }
  /// Half the angle of the cap that is seen: the mean direction of a cap is (1 + cos) / 2 long.
  [[nodiscard]] double cap_rad() const {
    return std::acos(std::clamp(2 * outward.norm() / points - 1, -1.0, 1.0));
  }
  [[nodiscard]] double rank() const { return points * cap_rad(); }
};

/// One step of Gauss-Newton; `fit` counts what took part before it.
void step(std::span<const SurfacePoint> points, const RoundThingOptions& options, SphereFit& fit) {
  Sphere& sphere = fit.sphere;
  fit = {sphere};
  Eigen::Matrix4d information = Eigen::Matrix4d::Zero();
  Eigen::Vector4d gradient = Eigen::Vector4d::Zero();
  for (const SurfacePoint& point : points) {
    const Eigen::Vector3d apart = point.point_m.cast<double>() - sphere.center_m;
    const double distance_m = apart.norm();
    if (distance_m > kInside * sphere.radius_m || !(distance_m > 0)) continue;
    ++fit.inside;
    const double residual_m = distance_m - sphere.radius_m;
    const Eigen::Vector3d outward = apart / distance_m;
    if (std::abs(residual_m) > options.reach_m ||
        point.normal.cast<double>().dot(outward) < options.min_cosine)
      continue;
    Eigen::Vector4d by;
    by << -outward, -1;
    const double weight = robust_weight(residual_m / options.sigma_m);
    information += weight * by * by.transpose();
    gradient += weight * residual_m * by;
    ++fit.points;
    fit.squares += residual_m * residual_m;
    fit.outward += outward;
  }
  if (fit.points < options.min_points) return;
  information.diagonal().array() += kSphereDamping;
  const Eigen::Vector4d by = solve_symmetric(information, -gradient);
  sphere.center_m += by.head<3>();
  sphere.radius_m += by(3);
}

std::optional<SphereFit> fitted(std::span<const SurfacePoint> points, const Sphere& start,
                                const RoundThingOptions& options) {
  SphereFit fit{start};
  for (int i = 0; i < kSphereSteps; ++i) {
    step(points, options, fit);
    if (fit.points < options.min_points || fit.sphere.radius_m < double(options.min_radius_m) ||
        fit.sphere.radius_m > double(options.max_radius_m))
      return std::nullopt;
  }
  const bool is_round = fit.rms_m() <= options.max_rms_m &&
                        fit.points >= options.min_share * fit.inside &&
                        fit.cap_rad() >= options.min_cap_rad;
  return is_round ? std::optional(fit) : std::nullopt;
}

std::vector<SphereFit> fits_of(const MovingSurface& surface, const RoundThingOptions& options) {
  std::vector<SurfacePoint> points;
  for (const Eigen::Vector2i& block : surface.blocks)
    points.push_back(surface.at.at(block.x(), block.y()));
  std::vector<SphereFit> fits;
  const std::size_t apart = std::max<std::size_t>(1, points.size() / options.starts);
  for (std::size_t i = 0; i < points.size(); i += apart) {
    for (const double radius_m : kFirstRadii_m) {
      const Eigen::Vector3d center =
          (points[i].point_m - float(radius_m) * points[i].normal).cast<double>();
      if (const auto fit = fitted(points, {center, radius_m}, options)) fits.push_back(*fit);
    }
  }
  std::ranges::stable_sort(fits, std::greater(), &SphereFit::rank);
  return fits;
}

}  // namespace

std::vector<RoundThing> round_things(std::span<const MovingSurface> surfaces,
                                     const RoundThingOptions& options) {
  std::vector<RoundThing> found;
  for (const MovingSurface& surface : surfaces) {
    const std::size_t before = found.size();
    for (const SphereFit& fit : fits_of(surface, options)) {
      const bool is_new = std::all_of(found.begin() + static_cast<std::ptrdiff_t>(before),
                                      found.end(), [&](const RoundThing& known) {
                                        return (known.center_m - fit.sphere.center_m).norm() >=
                                               known.radius_m + fit.sphere.radius_m;
                                      });
      if (is_new) found.push_back({surface.time_s, fit.sphere.center_m, fit.sphere.radius_m});
    }
  }
  return found;
}

}  // namespace roomcast::alignment
