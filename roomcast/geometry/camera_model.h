// SPDX-License-Identifier: Apache-2.0
// Pinhole camera with Brown-Conrady distortion (Brown 1966; the model of OpenCV and of
// camera.json). Pixel centres are at integer coordinates. Optical frame: x right, y down, z
// forward, metres.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast {

struct CameraIntrinsics {
  int width = 0, height = 0;              // pixels
  double fx = 0, fy = 0, cx = 0, cy = 0;  // pixels
  double k1 = 0, k2 = 0, k3 = 0;          // radial
  double p1 = 0, p2 = 0;                  // tangential

  /// kInvalidArgument naming the invalid field, unless sizes are 1..kMaxImageSide, focal lengths
  /// are positive and all values are finite.
  [[nodiscard]] Status check() const;
  friend bool operator==(const CameraIntrinsics&, const CameraIntrinsics&) = default;
};

/// Images from outside are at most this wide and high, in pixels.
inline constexpr int kMaxImageSide = 8192;

/// An RGB-D sensor as calibrated by its maker (or by the rig's author).
struct SensorCalibration {
  CameraIntrinsics depth;
  CameraIntrinsics color;
  RigidTransform color_from_depth;
  /// True if colour pictures arrive already resampled to the depth grid (`color` then equals
  /// `depth`).
  bool color_is_registered = false;
};

/// Normalised image coordinates (x/z, y/z) -> distorted ones. Source: Brown 1966, as written in
/// OpenCV's calib3d.
[[nodiscard]] Eigen::Vector2d distort(const CameraIntrinsics& camera, const Eigen::Vector2d& xy);

/// The inverse of `distort`, by Newton's method, to better than 1e-6 of a pixel; nothing where the
/// model folds over (far outside the picture of strongly distorted lenses).
[[nodiscard]] std::optional<Eigen::Vector2d> undistort(const CameraIntrinsics& camera,
                                                       const Eigen::Vector2d& distorted_xy);

/// A point in front of the camera -> pixel coordinates (possibly outside the picture); nothing for
/// z <= 0, or where the lens model folds over (its formula would map points far outside into the
/// picture).
[[nodiscard]] std::optional<Eigen::Vector2d> project(const CameraIntrinsics& camera,
                                                     const Eigen::Vector3d& point_m);

/// Pixel coordinates and z in metres -> point in metres; nothing where `undistort` gives nothing.
[[nodiscard]] std::optional<Eigen::Vector3d> unproject(const CameraIntrinsics& camera,
                                                       const Eigen::Vector2d& pixel, double z_m);

/// The squared radius (x/z, y/z) that contains all rays of the picture, including half a pixel
/// beyond its border; the lens polynomial is invalid outside. 0 if no ray of the border is known.
[[nodiscard]] double widest_radius_squared(const CameraIntrinsics& camera);

/// The undistorted (x/z, y/z) of every pixel; NaN where there is none. Built once per camera.
[[nodiscard]] Image<Eigen::Vector2f> ray_table(const CameraIntrinsics& camera);

}  // namespace roomcast
