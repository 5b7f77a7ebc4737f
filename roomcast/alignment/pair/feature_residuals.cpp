// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/feature_residuals.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace roomcast::alignment {
namespace {

constexpr double kMedianOfRayleigh = 1.1774;  // median distance, in sigmas of each coordinate

using Matrix23 = Eigen::Matrix<double, 2, 3>;
using Matrix32 = Eigen::Matrix<double, 3, 2>;
using PairJacobian = Eigen::Matrix<double, 2, kPairUnknowns>;

/// A colour camera in double precision.
struct Camera {
  double fx, fy, cx, cy;
  Eigen::Matrix3d color_from_depth;
  Eigen::Vector3d color_from_depth_m;
  SensorCorrection correction;

  Camera(const ColorPicture& picture, const SensorCorrection& of_sensor)
      : fx(double(picture.camera.fx)),
        fy(double(picture.camera.fy)),
        cx(double(picture.camera.cx)),
        cy(double(picture.camera.cy)),
        color_from_depth(picture.color_from_depth_rotation.cast<double>()),
        color_from_depth_m(picture.color_from_depth_m.cast<double>()),
        correction(of_sensor) {}

  /// Derivative of a lifted point by the pixel shift of its feature.
  [[nodiscard]] Matrix32 point_by_shift(const Eigen::Vector3d& point_m) const {
    const double z = (color_from_depth * point_m + color_from_depth_m).z();
    Matrix32 in_color;
    in_color << z / fx, 0, 0, z / fy, 0, 0;
    return color_from_depth.transpose() * in_color;
  }
};

/// A lifted feature with its sensor's correction applied, and its derivative by that correction.
struct Lifted {
  Eigen::Vector3d point_m;
  Eigen::Matrix<double, 3, kCorrectionUnknowns> by_correction;

  Lifted(const Camera& camera, const Eigen::Vector3f& measured_m) {
    const Eigen::Vector3d measured = measured_m.cast<double>();
    by_correction << camera.point_by_shift(measured), point_by_depth(measured);
    point_m = measured + by_correction.leftCols<2>() * camera.correction.color_shift_px;
  }
};

struct Reprojection {
  Eigen::Vector2d residual_px;
  Matrix23 by_point;  // derivative by the point in the depth frame
};

std::optional<Reprojection> reproject(const Camera& camera, const Eigen::Vector3d& point_m,
                                      const Eigen::Vector2f& seen,
                                      const FeatureResidualOptions& options) {
  const Eigen::Vector3d p = camera.color_from_depth * point_m + camera.color_from_depth_m;
  if (!(p.z() > options.nearest_m)) return std::nullopt;
  const Eigen::Vector2d pixel(camera.fx * p.x() / p.z() + camera.cx,
                              camera.fy * p.y() / p.z() + camera.cy);
  Reprojection out;
  out.residual_px = pixel - seen.cast<double>() - camera.correction.color_shift_px;
  if (!(out.residual_px.norm() < options.max_residual_px)) return std::nullopt;
  Matrix23 by_color_point;
  by_color_point << camera.fx / p.z(), 0, -camera.fx * p.x() / (p.z() * p.z()),  //
      0, camera.fy / p.z(), -camera.fy * p.y() / (p.z() * p.z());
  out.by_point = by_color_point * camera.color_from_depth;
  return out;
}

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/// Calls `visit(match, jacobian row, residual, weight)` for both rows of the residual.
template <class Visit>
void visit_rows(const PointMatch& match, const Reprojection& at, const PairJacobian& jacobian,
                const FeatureTrust& trust, Visit visit) {
  const double weight = trust.share * robust_weight(at.residual_px.norm() / trust.sigma_px) /
                        (trust.sigma_px * trust.sigma_px);
  for (int row = 0; row < 2; ++row)
    visit(match, PairVector(jacobian.row(row).transpose()), at.residual_px(row), weight);
}

template <class Visit>
void for_each_term(const ColorPicture& a, const ColorPicture& b, const PairState& state,
                   std::span<const PointMatch> matches, const FeatureTrust& trust,
                   const FeatureResidualOptions& options, Visit visit) {
  const Camera camera_a(a, state.a), camera_b(b, state.b);
  const Eigen::Matrix3d& a_from_b = state.a_from_b.rotation;
  const RigidTransform b_from_a = state.a_from_b.inverse();
  for (const PointMatch& match : matches) {
    const Lifted of_a(camera_a, match.a_m), of_b(camera_b, match.b_m);
    const Eigen::Vector3d in_a = state.a_from_b * of_b.point_m;
    if (const auto at = reproject(camera_a, in_a, match.a_pixel, options)) {
      PairJacobian jacobian = PairJacobian::Zero();
      jacobian.leftCols<3>() = -at->by_point * cross_matrix(in_a);
      jacobian.middleCols<3>(3) = at->by_point;
      jacobian.middleCols<2>(kOfA + kShift) = -Eigen::Matrix2d::Identity();
      jacobian.middleCols<kCorrectionUnknowns>(kOfB) = at->by_point * a_from_b * of_b.by_correction;
      visit_rows(match, *at, jacobian, trust, visit);
    }
    if (const auto at = reproject(camera_b, b_from_a * of_a.point_m, match.b_pixel, options)) {
      const Matrix23 by_a = at->by_point * b_from_a.rotation;
      PairJacobian jacobian = PairJacobian::Zero();
      jacobian.leftCols<3>() = by_a * cross_matrix(of_a.point_m);
      jacobian.middleCols<3>(3) = -by_a;
      jacobian.middleCols<2>(kOfB + kShift) = -Eigen::Matrix2d::Identity();
      jacobian.middleCols<kCorrectionUnknowns>(kOfA) = by_a * of_a.by_correction;
      visit_rows(match, *at, jacobian, trust, visit);
    }
  }
}

}  // namespace

PairEquations feature_equations(const ColorPicture& a, const ColorPicture& b,
                                const PairState& state, std::span<const PointMatch> matches,
                                const FeatureTrust& trust, const FeatureResidualOptions& options) {
  PairEquations sum;
  for_each_term(a, b, state, matches, trust, options,
                [&](const PointMatch&, const PairVector& jacobian, double residual, double weight) {
                  sum.add(jacobian, residual, weight);
                });
  return sum;
}

void add_feature_scores(const ColorPicture& a, const ColorPicture& b, const PairState& state,
                        std::span<const PointMatch> matches, const FeatureTrust& trust,
                        PairScores& scores, const FeatureResidualOptions& options) {
  for_each_term(
      a, b, state, matches, trust, options,
      [&](const PointMatch& match, const PairVector& jacobian, double residual, double weight) {
        scores.add(match.a_m.cast<double>(), match.b_m.cast<double>(),
                   weight * residual * jacobian);
      });
}

double feature_sigma_px(const ColorPicture& a, const ColorPicture& b, const PairState& state,
                        std::span<const PointMatch> matches,
                        const FeatureResidualOptions& options) {
  const Camera camera_a(a, state.a), camera_b(b, state.b);
  const RigidTransform b_from_a = state.a_from_b.inverse();
  std::vector<double> away_px;
  for (const PointMatch& match : matches) {
    const Lifted of_a(camera_a, match.a_m), of_b(camera_b, match.b_m);
    const auto in_a = reproject(camera_a, state.a_from_b * of_b.point_m, match.a_pixel, options);
    const auto in_b = reproject(camera_b, b_from_a * of_a.point_m, match.b_pixel, options);
    if (in_a) away_px.push_back(in_a->residual_px.norm());
    if (in_b) away_px.push_back(in_b->residual_px.norm());
  }
  if (away_px.empty()) return options.max_sigma_px;
  const auto middle = away_px.begin() + static_cast<std::ptrdiff_t>(away_px.size() / 2);
  std::nth_element(away_px.begin(), middle, away_px.end());
  return std::clamp(*middle / kMedianOfRayleigh, options.min_sigma_px, options.max_sigma_px);
}

}  // namespace roomcast::alignment
