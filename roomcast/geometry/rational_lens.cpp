// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/rational_lens.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>

namespace roomcast {
namespace {

constexpr int kSamples = 400;     // radii of the fit
constexpr int kLawsonSteps = 60;  // the error settles to a percent of its size
constexpr double kRadiusStep = 1e-3;
constexpr double kSmallestFactor = 1e-3;  // of the linear term: else it is not a lens

using Terms = Eigen::Vector4d;  // of r, r^3, r^5, r^7

double radial_factor(const RationalLens& lens, double r2) {
  const CameraIntrinsics& c = lens.camera;
  return (1 + r2 * (c.k1 + r2 * (c.k2 + r2 * c.k3))) /
         (1 + r2 * (lens.k4 + r2 * (lens.k5 + r2 * lens.k6)));
}

Terms powers(double r) {
  const double r2 = r * r;
  return {r, r * r2, r * r2 * r2, r * r2 * r2 * r2};
}

double corner_radius(const CameraIntrinsics& c) {
  double largest = 0;
  for (const double u : {-0.5, c.width - 0.5}) {
    for (const double v : {-0.5, c.height - 0.5})
      largest = std::max(largest, std::hypot((u - c.cx) / c.fx, (v - c.cy) / c.fy));
  }
  return largest;
}

/// The radius up to which the lens is to be converted: the first one whose distorted radius leaves
/// the picture. 0 if the lens folds over before.
double shown_radius(const RationalLens& lens, double largest_radius) {
  const double corner = corner_radius(lens.camera);
  double before = 0;
  for (double r = kRadiusStep; r < largest_radius; r += kRadiusStep) {
    const double distorted = r * radial_factor(lens, r * r);
    if (!(distorted > before)) return 0;
    if (distorted > corner) return r;
    before = distorted;
  }
  return largest_radius;
}

struct Fit {
  Terms terms = Terms::Zero();
  double largest_error = 0;
};

Fit smallest_largest_error(const RationalLens& lens, double radius) {
  std::vector<double> weights(kSamples);
  std::vector<Terms> rows(kSamples);
  std::vector<double> targets(kSamples);
  for (int i = 0; i < kSamples; ++i) {
    const double r = radius * (i + 0.5) / kSamples;
    const auto at = static_cast<std::size_t>(i);
    rows[at] = powers(r);
    targets[at] = r * radial_factor(lens, r * r);
    weights[at] = r;  // a ring has as many pixels
  }
  Fit best;
  for (int step = 0; step < kLawsonSteps; ++step) {
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Terms right = Terms::Zero();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      normal += weights[i] * rows[i] * rows[i].transpose();
      right += weights[i] * targets[i] * rows[i];
    }
    const Terms terms = normal.ldlt().solve(right);
    double largest = 0, sum = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double error = std::abs(terms.dot(rows[i]) - targets[i]);
      largest = std::max(largest, error);
      weights[i] *= error + 1e-15;
      sum += weights[i];
    }
    if (step == 0 || largest < best.largest_error) best = {terms, largest};
    if (!(sum > 0)) break;
    for (double& weight : weights) weight /= sum;
  }
  return best;
}

}  // namespace

Eigen::Vector2d distort(const RationalLens& lens, const Eigen::Vector2d& xy) {
  const CameraIntrinsics& c = lens.camera;
  const double x = xy.x(), y = xy.y(), r2 = xy.squaredNorm();
  const double radial = radial_factor(lens, r2);
  return {x * radial + 2 * c.p1 * x * y + c.p2 * (r2 + 2 * x * x),
          y * radial + c.p1 * (r2 + 2 * y * y) + 2 * c.p2 * x * y};
}

Result<ConvertedLens> polynomial_lens(const RationalLens& lens, double largest_radius) {
  if (Status status = lens.camera.check(); !status) return status.error();
  if (!std::isfinite(lens.k4) || !std::isfinite(lens.k5) || !std::isfinite(lens.k6) ||
      !(largest_radius > 0 && largest_radius < 100))
    return invalid_argument("the lens has a coefficient that is not a number");
  if (lens.k4 == 0 && lens.k5 == 0 && lens.k6 == 0) return ConvertedLens{lens.camera, 0};
  const double radius = shown_radius(lens, largest_radius);
  if (!(radius > 0)) return invalid_argument("the lens folds over within its picture");
  const Fit fit = smallest_largest_error(lens, radius);
  const double scale = fit.terms[0];
  if (!(scale > kSmallestFactor) || !fit.terms.allFinite())
    return invalid_argument("the lens cannot be approximated by a polynomial");
  ConvertedLens converted{lens.camera,
                          fit.largest_error * std::max(lens.camera.fx, lens.camera.fy)};
  CameraIntrinsics& c = converted.camera;
  c.fx *= scale;
  c.fy *= scale;
  c.k1 = fit.terms[1] / scale;
  c.k2 = fit.terms[2] / scale;
  c.k3 = fit.terms[3] / scale;
  c.p1 /= scale;
  c.p2 /= scale;
  return converted;
}

}  // namespace roomcast
