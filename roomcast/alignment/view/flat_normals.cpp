// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/view/flat_normals.h"

#include <cmath>

#include "roomcast/alignment/view/depth_noise.h"

namespace roomcast::alignment {
namespace {

constexpr float kFlatThickness_m = 0.02F;  // plus the depth noise
constexpr float kFlatCosine = 0.98F;       // cosine: a larger tilt is real

void flatten(std::span<const Plane> planes, SurfacePoint& point) {
  if (point.normal.isZero()) return;
  const float thickness_m = kFlatThickness_m + depth_sigma_m(point.point_m.z());
  for (const Plane& plane : planes) {
    if (point.normal.dot(plane.normal) < kFlatCosine) continue;
    if (std::abs(plane.height_m(point.point_m)) > thickness_m) continue;
    point.normal = plane.normal;
    return;
  }
}

}  // namespace

void flatten_normals(std::span<const Plane> planes, DepthSurface& surface) {
  for (int y = 0; y < surface.at.height(); ++y) {
    for (int x = 0; x < surface.at.width(); ++x) flatten(planes, surface.at.at(x, y));
  }
  for (SurfacePoint& sample : surface.samples) flatten(planes, sample);
}

}  // namespace roomcast::alignment
