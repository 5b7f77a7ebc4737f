// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/lens_error.h"

#include "roomcast/geometry/rotations.h"

namespace roomcast::simulator {
namespace {

double up_to(double most, Random& random) {
  return most * static_cast<double>(random.between(-1.0F, 1.0F));
}

Eigen::Vector3d vector_up_to(double most, Random& random) {
  const double x = up_to(most, random), y = up_to(most, random), z = up_to(most, random);
  return {x, y, z};
}

}  // namespace

LensError draw_lens_error(Random& random) {
  LensError error;
  error.focal = up_to(kMaxFocalError, random);
  error.aspect = up_to(kMaxAspectError, random);
  error.cx_px = up_to(kMaxCentreError_px, random);
  error.cy_px = up_to(kMaxCentreError_px, random);
  error.bend_k1 = up_to(kMaxBendError, random);
  error.bend_k2 = up_to(kMaxBendError, random);
  return error;
}

CameraIntrinsics with_error(CameraIntrinsics nominal, const LensError& error) {
  const double scale = nominal.width / 640.0;
  nominal.fx *= 1.0 + error.focal;
  nominal.fy *= (1.0 + error.focal) * (1.0 + error.aspect);
  nominal.cx += scale * error.cx_px;
  nominal.cy += scale * error.cy_px;
  nominal.k1 += error.bend_k1;
  nominal.k2 += error.bend_k2;
  return nominal;
}

RigidTransform with_drawn_error(RigidTransform color_from_depth, Random& random) {
  const Eigen::Vector3d turn = vector_up_to(kMaxColorTurn_rad, random);
  color_from_depth.rotation = color_from_depth.rotation * rotation_from_vector(turn);
  color_from_depth.translation_m += vector_up_to(kMaxColorShift_m, random);
  return color_from_depth;
}

}  // namespace roomcast::simulator
