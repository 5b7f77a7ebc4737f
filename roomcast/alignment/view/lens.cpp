// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/view/lens.h"

namespace roomcast::alignment {
namespace {

float f(double x) {
  return static_cast<float>(x);
}

}  // namespace

Lens::Lens(const CameraIntrinsics& camera)
    : fx_(f(camera.fx)),
      fy_(f(camera.fy)),
      cx_(f(camera.cx)),
      cy_(f(camera.cy)),
      k1_(f(camera.k1)),
      k2_(f(camera.k2)),
      k3_(f(camera.k3)),
      p1_(f(camera.p1)),
      p2_(f(camera.p2)),
      largest_r2_(f(widest_radius_squared(camera))) {}

}  // namespace roomcast::alignment
