// SPDX-License-Identifier: Apache-2.0
// Lifts a pixel of the colour picture into space: to the point where the pixel's ray meets the
// surface seen by the depth camera. On surfaces seen at a grazing angle neighbouring readings
// differ by several millimetres of depth. The nearest reading, let alone the nearest of a few,
// would therefore put every feature of a floor too near. Metres; thread-safe (no state).
#pragma once

#include <optional>

#include <Eigen/Core>

#include "roomcast/alignment/view/color_picture.h"
#include "roomcast/alignment/view/depth_surface.h"

namespace roomcast::alignment {

/// The surface point seen at `pixel`, in the depth camera's frame; nothing without depth or at an
/// edge. `picture` must have been made with `surface`.
[[nodiscard]] std::optional<Eigen::Vector3f> lift(const ColorPicture& picture,
                                                  const DepthSurface& surface,
                                                  const Eigen::Vector2f& pixel);

}  // namespace roomcast::alignment
