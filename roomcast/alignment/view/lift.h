// SPDX-License-Identifier: Apache-2.0
// Where in space lies what a pixel of the colour picture shows? On the pixel's ray, where that
// meets the surface that the depth camera saw. Depth readings lie apart by several millimetres of
// depth where a surface is seen aslant, so the nearest reading, let alone the nearest of a few,
// would put every feature of a floor too near. Metres; thread-safe (no state).
#pragma once

#include <optional>

#include <Eigen/Core>

#include "roomcast/alignment/view/color_picture.h"
#include "roomcast/alignment/view/depth_surface.h"

namespace roomcast::alignment {

/// The surface point seen at `pixel`, in the depth camera's frame; nothing where there is no depth,
/// or an edge. `surface` is what `picture` was made with.
[[nodiscard]] std::optional<Eigen::Vector3f> lift(const ColorPicture& picture,
                                                  const DepthSurface& surface,
                                                  const Eigen::Vector2f& pixel);

}  // namespace roomcast::alignment
