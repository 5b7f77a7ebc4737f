// SPDX-License-Identifier: Apache-2.0
// Which pixels of a sensor show a surface that another sensor of the room shows better: with more
// pixels for each part of it. A surface that is twice as far has a quarter of the pixels, and one
// seen at a slant fewer by the cosine of the angle of incidence. Pure.
#pragma once

#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::bench {

/// A sensor's depth at one instant; the image outlives it.
struct SensorDepth {
  const CameraIntrinsics* lens = nullptr;
  RigidTransform world_from_depth;
  DepthView depth_mm;
};

struct BetterShownOptions {
  double better = 1.2;        // so many times the pixels: less is not worth a change
  double agree_m = 0.03;      // two sensors see the same surface: the larger of both
  double agree_share = 0.02;  // of the distance
};

/// 255 where another of `sensors` shows the surface of `sensors[which]` better, 0 elsewhere.
[[nodiscard]] MaskImage better_shown(const std::vector<SensorDepth>& sensors, std::size_t which,
                                     const BetterShownOptions& options = {});

}  // namespace roomcast::bench
