// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/view/flat_normals.h"

#include <cmath>

namespace roomcast::alignment {
namespace {

void flatten(std::span<const Plane> planes, const DepthNoiseOptions& noise,
             const FlatNormalOptions& options, SurfacePoint& point) {
  if (point.normal.isZero()) return;
  const float thickness_m = options.thickness_m + noise.sigma_m(point.point_m.z());
  for (const Plane& plane : planes) {
    if (point.normal.dot(plane.normal) < options.min_cosine) continue;
    if (std::abs(plane.height_m(point.point_m)) > thickness_m) continue;
    point.normal = plane.normal;
    return;
  }
}

}  // namespace

void flatten_normals(std::span<const Plane> planes, DepthSurface& surface,
                     const FlatNormalOptions& options) {
  const DepthNoiseOptions& noise = surface.options.noise;
  for (int y = 0; y < surface.at.height(); ++y) {
    for (int x = 0; x < surface.at.width(); ++x)
      flatten(planes, noise, options, surface.at.at(x, y));
  }
  for (SurfacePoint& sample : surface.samples) flatten(planes, noise, options, sample);
}

}  // namespace roomcast::alignment
