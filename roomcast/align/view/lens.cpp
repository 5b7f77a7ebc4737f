// SPDX-License-Identifier: Apache-2.0
#include "roomcast/align/view/lens.h"

#include <algorithm>

namespace roomcast::align {
namespace {

constexpr double kRadiusReserve = 1.01;  // for points within half a pixel of the border

double largest_radius_squared(const CameraIntrinsics& camera) {
  double largest = 0;
  const auto visit = [&](int u, int v) {
    if (const auto ray = unproject(camera, {u, v}, 1)) {
      largest = std::max(largest, ray->head<2>().squaredNorm());
    }
  };
  for (int u = 0; u < camera.width; ++u) visit(u, 0), visit(u, camera.height - 1);
  for (int v = 0; v < camera.height; ++v) visit(0, v), visit(camera.width - 1, v);
  return largest;
}

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
      largest_r2_(f(kRadiusReserve * largest_radius_squared(camera))) {}

}  // namespace roomcast::align
