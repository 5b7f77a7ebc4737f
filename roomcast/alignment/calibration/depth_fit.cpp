// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/calibration/depth_fit.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include <Eigen/Geometry>

#include "roomcast/geometry/dense_solvers.h"
#include "roomcast/geometry/rotations.h"

namespace roomcast::alignment::calibration {
namespace {

constexpr int kRounds = 4, kStepsPerRound = 5;
constexpr int kPixelStep = 2;     // every other row and column suffices
constexpr double kRim_m = 0.012;  // of the board: readings near its edge mix with the background
constexpr double kWidestError_m = 0.06;  // readings farther from the plane are not on the board
constexpr std::size_t kFewestReadings = 200;

/// Noise of a reading grows with the square of its distance.
double sigma_m(double z_m) {
  return 0.001 + 0.0015 * z_m * z_m;
}

/// Three turns, three shifts, scale, bias.
enum Unknown { kTurn = 0, kShift = 3, kScale = 6, kBias = 7, kUnknowns = 8 };
using Unknowns = Eigen::Matrix<double, kUnknowns, 1>;
using Normal = Eigen::Matrix<double, kUnknowns, kUnknowns>;

/// Standard deviations of the start values: parameters that the views do not determine stay there.
Unknowns trust(bool poses_are_known) {
  const double turn = poses_are_known ? 1e-9 : 0.1, shift = poses_are_known ? 1e-9 : 0.1;
  Unknowns sigma;
  sigma << turn, turn, turn, shift, shift, shift, 0.05, 0.05;
  return sigma;
}

struct Plane {
  Eigen::Vector3d normal;
  double distance_m;  // normal . point == distance
};

Plane plane_of(const RigidTransform& color_from_board) {
  const Eigen::Vector3d normal = color_from_board.rotation.col(2);
  return {normal, normal.dot(color_from_board.translation_m)};
}

struct Reading {
  Eigen::Vector3d ray;  // of the depth camera, z = 1
  double z_m;
};

Eigen::Vector3d point_in_color(const DepthModel& model, const Reading& reading) {
  const double z_m = model.scale * reading.z_m + model.bias_m;
  return model.color_from_depth * Eigen::Vector3d(z_m * reading.ray);
}

bool is_on_board(const CharucoBoard& board, const RigidTransform& color_from_board,
                 const Eigen::Vector3d& point_m) {
  const Eigen::Vector3d p = color_from_board.inverse() * point_m;
  const Eigen::Vector2d size = board.size_m();
  return p.x() > kRim_m && p.y() > kRim_m && p.x() < size.x() - kRim_m &&
         p.y() < size.y() - kRim_m && std::abs(p.z()) < kWidestError_m;
}

std::vector<Reading> readings_on_board(const CharucoBoard& board, const BoardDepth& view,
                                       const Image<Eigen::Vector2f>& rays,
                                       const DepthModel& model) {
  std::vector<Reading> readings;
  for (int y = 0; y < rays.height(); y += kPixelStep) {
    for (int x = 0; x < rays.width(); x += kPixelStep) {
      const Eigen::Vector2f& ray = rays.at(x, y);
      const Reading reading{{static_cast<double>(ray.x()), static_cast<double>(ray.y()), 1},
                            0.001 * view.depth_mm->at(x, y)};
      if (reading.z_m == 0 || std::isnan(ray.x())) continue;
      if (is_on_board(board, view.color_from_board, point_in_color(model, reading)))
        readings.push_back(reading);
    }
  }
  if (readings.size() < kFewestReadings) readings.clear();
  return readings;
}

double error_m(const Plane& plane, const DepthModel& model, const Reading& reading) {
  return plane.normal.dot(point_in_color(model, reading)) - plane.distance_m;
}

struct Equations {
  Normal normal = Normal::Zero();
  Unknowns right = Unknowns::Zero();

  void add(const Plane& plane, const DepthModel& model, const Reading& reading) {
    const RigidTransform& pose = model.color_from_depth;
    const Eigen::Vector3d direction = pose.rotation * reading.ray;
    const double z_m = model.scale * reading.z_m + model.bias_m;
    const double error = error_m(plane, model, reading) / sigma_m(reading.z_m);
    const double cauchy = 1 / (1 + 0.1 * error * error);
    Unknowns slope;
    slope << (z_m * direction).cross(plane.normal), plane.normal,
        plane.normal.dot(direction) * reading.z_m, plane.normal.dot(direction);
    slope /= sigma_m(reading.z_m);
    normal += cauchy * slope * slope.transpose();
    right += cauchy * error * slope;
  }
};

DepthModel moved(const DepthModel& model, const Unknowns& by) {
  const Eigen::Vector3d turn = by.segment<3>(kTurn);
  DepthModel next = model;
  next.color_from_depth.rotation = rotation_from_vector(turn) * model.color_from_depth.rotation;
  next.color_from_depth.translation_m += by.segment<3>(kShift);
  next.scale += by[kScale];
  next.bias_m += by[kBias];
  return next;
}

PlaneError error_of_view(const Plane& plane, const std::vector<Reading>& readings,
                         const DepthModel& before, const DepthModel& after) {
  PlaneError error;
  error.readings = readings.size();
  if (readings.empty()) return error;
  const double count = static_cast<double>(readings.size());
  double square = 0;
  // Positive is away from the camera, for either direction of the board's normal.
  const double sign = plane.distance_m < 0 ? -1 : 1;
  for (const Reading& reading : readings) {
    const double left_mm = 1000 * sign * error_m(plane, after, reading);
    error.distance_m += reading.z_m / count;
    error.mean_before_mm += 1000 * sign * error_m(plane, before, reading) / count;
    error.mean_after_mm += left_mm / count;
    square += left_mm * left_mm / count;
  }
  error.rms_after_mm = std::sqrt(square);
  return error;
}

void tell_sigmas(const Equations& equations, DepthFit& fit) {
  const Normal covariance = inverse_of(equations.normal);
  const auto sigma = [&](int first, int count) {
    return std::sqrt(covariance.diagonal().segment(first, count).sum());
  };
  fit.rotation_sigma_deg = sigma(kTurn, 3) * 180 / std::numbers::pi;
  fit.translation_sigma_mm = 1000 * sigma(kShift, 3);
  fit.bias_sigma_mm = 1000 * sigma(kBias, 1);
}

}  // namespace

Result<DepthFit> fit_depth(const CharucoBoard& board, const std::vector<BoardDepth>& views,
                           const SensorCalibration& cameras) {
  const Image<Eigen::Vector2f> rays =
      ray_table(cameras.color_is_registered ? cameras.color : cameras.depth);
  const Unknowns sigma = trust(cameras.color_is_registered);
  DepthModel start;
  if (!cameras.color_is_registered) start.color_from_depth = cameras.color_from_depth;
  DepthFit fit;
  fit.model = start;
  std::vector<std::vector<Reading>> readings(views.size());
  Equations equations;
  Unknowns from_start = Unknowns::Zero();
  for (int round = 0; round < kRounds; ++round) {
    std::size_t seen = 0;
    for (std::size_t i = 0; i < views.size(); ++i) {
      readings[i] = readings_on_board(board, views[i], rays, fit.model);
      seen += !readings[i].empty();
    }
    if (seen < kFewestDepthViews) {
      return Error{ErrorCode::kNotFound,
                   "depth was read on the board in " + std::to_string(seen) + " views; it needs " +
                       std::to_string(kFewestDepthViews) + ", within the depth camera's range"};
    }
    for (int step = 0; step < kStepsPerRound; ++step) {
      equations = {};
      for (std::size_t i = 0; i < views.size(); ++i) {
        const Plane plane = plane_of(views[i].color_from_board);
        for (const Reading& reading : readings[i]) equations.add(plane, fit.model, reading);
      }
      const Unknowns weight = sigma.cwiseAbs2().cwiseInverse();
      equations.normal.diagonal() += weight;
      equations.right += weight.cwiseProduct(from_start);
      const Unknowns by = -solve_symmetric(equations.normal, equations.right);
      fit.model = moved(fit.model, by);
      from_start += by;
    }
  }
  tell_sigmas(equations, fit);
  for (std::size_t i = 0; i < views.size(); ++i) {
    fit.views.push_back(
        error_of_view(plane_of(views[i].color_from_board), readings[i], start, fit.model));
  }
  return fit;
}

}  // namespace roomcast::alignment::calibration
