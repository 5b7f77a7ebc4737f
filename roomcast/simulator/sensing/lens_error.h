// SPDX-License-Identifier: Apache-2.0
// LensError: how far a unit's true lens is from the nominal one of its model, which is all that an
// uncalibrated sensor declares. Focal lengths of structured-light sensors that were calibrated one
// by one differ by one to three percent, centres by several pixels (Smisek, Jancosek, Pajdla, "3D
// with Kinect", ICCV workshops 2011; Herrera, Kannala, Heikkila, PAMI 34(10), 2012). Pixels at a
// width of 640. Pure functions.
#pragma once

#include "roomcast/geometry/camera_model.h"
#include "roomcast/simulator/random/random.h"

namespace roomcast::simulator {

/// Each error is uniform between minus and plus this.
inline constexpr double kMaxFocalError = 0.03;    // share of the focal length
inline constexpr double kMaxAspectError = 0.002;  // of fy against fx
inline constexpr double kMaxCentreError_px = 8;
inline constexpr double kMaxBendError = 0.03;                                // of k1 and k2
inline constexpr double kMaxColorTurn_rad = 0.01, kMaxColorShift_m = 0.004;  // about, along an axis

struct LensError {
  double focal = 0, aspect = 0;  // shares
  double cx_px = 0, cy_px = 0;   // at a width of 640
  double bend_k1 = 0, bend_k2 = 0;
};

[[nodiscard]] LensError draw_lens_error(Random& random);

/// The true lens of a unit.
[[nodiscard]] CameraIntrinsics with_error(CameraIntrinsics nominal, const LensError& error);

/// The true place of the unit's colour camera.
[[nodiscard]] RigidTransform with_drawn_error(RigidTransform color_from_depth, Random& random);

}  // namespace roomcast::simulator
