// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/camera_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <Eigen/LU>

namespace roomcast {
namespace {

constexpr int kMaxNewtonSteps = 30;
constexpr double kNewtonTolerance = 1e-12;  // normalised coordinates; 1e-6 px is about 1e-9

/// d(distorted radius)/d(radius) of the radial part; the model folds over where this reaches 0.
double radial_slope(const CameraIntrinsics& c, double r2) {
  return 1 + r2 * (3 * c.k1 + r2 * (5 * c.k2 + r2 * 7 * c.k3));
}

/// Whether the radial part increases everywhere from the axis out to this radius.
bool before_fold(const CameraIntrinsics& c, double r2) {
  if (!(radial_slope(c, r2) > 0)) return false;
  const double a = 21 * c.k3, b = 10 * c.k2,
               d = 3 * c.k1;  // derivative a x^2 + b x + d of the slope
  const double discriminant = b * b - 4 * a * d;
  if (discriminant < 0) return true;
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  for (const double extremum : {q / a, d / q}) {
    if (extremum > 0 && extremum < r2 && !(radial_slope(c, extremum) > 0)) return false;
  }
  return true;
}

struct Distorted {
  Eigen::Vector2d xy;
  Eigen::Matrix2d jacobian;
};

Distorted distort_with_jacobian(const CameraIntrinsics& c, const Eigen::Vector2d& xy) {
  const double x = xy.x(), y = xy.y();
  const double r2 = xy.squaredNorm();
  const double radial = 1 + r2 * (c.k1 + r2 * (c.k2 + r2 * c.k3));
  const double radial_by_r2 = c.k1 + r2 * (2 * c.k2 + r2 * 3 * c.k3);
  const double cross = 2 * x * y * radial_by_r2 + 2 * c.p1 * x + 2 * c.p2 * y;
  Distorted out;
  out.xy = distort(c, xy);
  out.jacobian << radial + 2 * x * x * radial_by_r2 + 2 * c.p1 * y + 6 * c.p2 * x, cross,  //
      cross, radial + 2 * y * y * radial_by_r2 + 6 * c.p1 * y + 2 * c.p2 * x;
  return out;
}

std::optional<Eigen::Vector2d> undistort_from(const CameraIntrinsics& camera,
                                              const Eigen::Vector2d& distorted_xy,
                                              Eigen::Vector2d xy) {
  for (int step = 0; step < kMaxNewtonSteps; ++step) {
    const Distorted at = distort_with_jacobian(camera, xy);
    const Eigen::Vector2d residual = at.xy - distorted_xy;
    if (!(at.jacobian.determinant() > 0)) return std::nullopt;
    if (residual.norm() < kNewtonTolerance) {
      if (!before_fold(camera, xy.squaredNorm())) return std::nullopt;
      return xy;
    }
    xy -= at.jacobian.inverse() * residual;
  }
  return std::nullopt;
}

Error bad_field(const char* field, const std::string& what) {
  return {ErrorCode::kInvalidArgument, std::string("camera field ") + field + " " + what};
}

Status check_side(const char* field, int side) {
  if (side >= 1 && side <= kMaxImageSide) return {};
  return bad_field(field, "must be 1 to " + std::to_string(kMaxImageSide) + " pixels, not " +
                              std::to_string(side));
}

Eigen::Vector2d normalised(const CameraIntrinsics& c, const Eigen::Vector2d& pixel) {
  return {(pixel.x() - c.cx) / c.fx, (pixel.y() - c.cy) / c.fy};
}

}  // namespace

Status CameraIntrinsics::check() const {
  if (Status status = check_side("width", width); !status.ok()) return status;
  if (Status status = check_side("height", height); !status.ok()) return status;
  const std::pair<const char*, double> fields[] = {{"fx", fx}, {"fy", fy}, {"cx", cx},
                                                   {"cy", cy}, {"k1", k1}, {"k2", k2},
                                                   {"k3", k3}, {"p1", p1}, {"p2", p2}};
  for (const auto& [name, value] : fields) {
    if (!std::isfinite(value)) return bad_field(name, "must be a finite number");
  }
  if (!(fx > 0)) return bad_field("fx", "must be positive");
  if (!(fy > 0)) return bad_field("fy", "must be positive");
  return {};
}

Eigen::Vector2d distort(const CameraIntrinsics& camera, const Eigen::Vector2d& xy) {
  const double x = xy.x(), y = xy.y();
  const double r2 = xy.squaredNorm();
  const double radial = 1 + r2 * (camera.k1 + r2 * (camera.k2 + r2 * camera.k3));
  return {x * radial + 2 * camera.p1 * x * y + camera.p2 * (r2 + 2 * x * x),
          y * radial + camera.p1 * (r2 + 2 * y * y) + 2 * camera.p2 * x * y};
}

std::optional<Eigen::Vector2d> undistort(const CameraIntrinsics& camera,
                                         const Eigen::Vector2d& distorted_xy) {
  return undistort_from(camera, distorted_xy, distorted_xy);
}

std::optional<Eigen::Vector2d> project(const CameraIntrinsics& camera,
                                       const Eigen::Vector3d& point_m) {
  if (!(point_m.z() > 0)) return std::nullopt;
  const Eigen::Vector2d xy = point_m.head<2>() / point_m.z();
  if (!before_fold(camera, xy.squaredNorm())) return std::nullopt;
  const Eigen::Vector2d distorted = distort(camera, xy);
  return Eigen::Vector2d{camera.fx * distorted.x() + camera.cx,
                         camera.fy * distorted.y() + camera.cy};
}

std::optional<Eigen::Vector3d> unproject(const CameraIntrinsics& camera,
                                         const Eigen::Vector2d& pixel, double z_m) {
  const auto xy = undistort(camera, normalised(camera, pixel));
  if (!xy) return std::nullopt;
  return Eigen::Vector3d{xy->x() * z_m, xy->y() * z_m, z_m};
}

double widest_radius_squared(const CameraIntrinsics& camera) {
  constexpr double kReserve = 1.01;  // covers half a pixel beyond the border
  double largest = 0;
  const auto visit = [&](int u, int v) {
    if (const auto ray = unproject(camera, {u, v}, 1)) {
      largest = std::max(largest, ray->head<2>().squaredNorm());
    }
  };
  for (int u = 0; u < camera.width; ++u) visit(u, 0), visit(u, camera.height - 1);
  for (int v = 0; v < camera.height; ++v) visit(0, v), visit(camera.width - 1, v);
  return kReserve * largest;
}

Image<Eigen::Vector2f> ray_table(const CameraIntrinsics& camera) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  Image<Eigen::Vector2f> table(camera.width, camera.height, Eigen::Vector2f(kNone, kNone));
  for (int v = 0; v < camera.height; ++v) {
    std::optional<Eigen::Vector2d> left;  // the neighbour's ray is a good initial value
    for (int u = 0; u < camera.width; ++u) {
      const Eigen::Vector2d distorted = normalised(camera, {u, v});
      if (left) left = undistort_from(camera, distorted, *left);
      if (!left) left = undistort(camera, distorted);
      if (left) table.at(u, v) = left->cast<float>();
    }
  }
  return table;
}

}  // namespace roomcast
