// SPDX-License-Identifier: Apache-2.0
// Converts the rational lens model of OpenCV (Claus & Fitzgibbon 2005; calib3d's eight
// coefficients; Azure Kinect, ROS's "rational_polynomial") to the polynomial one of
// CameraIntrinsics:
//   radial factor (1 + k1 r^2 + k2 r^4 + k3 r^6) / (1 + k4 r^2 + k5 r^4 + k6 r^6)
// Method: the distorted radius is approximated by an odd polynomial of degree 7 over all radii that
// the picture shows, with the smallest largest error (Lawson's iteration: least squares, reweighted
// by the error). The polynomial's first term scales the focal lengths. Thread-safe (no state).
#pragma once

#include <array>

#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast {

struct RationalLens {
  CameraIntrinsics camera;        // size, fx, fy, cx, cy; k1 to k3 of the numerator; p1, p2
  double k4 = 0, k5 = 0, k6 = 0;  // of the denominator
};

struct ConvertedLens {
  CameraIntrinsics camera;
  double largest_error_px = 0;  // radial, within the radius that was asked for
};

/// `largest_radius`: of the rays (x/z, y/z) that carry readings; larger ones are converted as far
/// as the picture's corners, if the model allows it, but no further than that. kInvalidArgument:
/// not a lens, or one that folds over within the picture.
[[nodiscard]] Result<ConvertedLens> polynomial_lens(const RationalLens& lens,
                                                    double largest_radius);

/// Normalised image coordinates (x/z, y/z) -> distorted ones, as OpenCV's calib3d.
[[nodiscard]] Eigen::Vector2d distort(const RationalLens& lens, const Eigen::Vector2d& xy);

}  // namespace roomcast
