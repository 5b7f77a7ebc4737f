// SPDX-License-Identifier: Apache-2.0
// For tests: the simulated room seen by one sensor in its corner.
#pragma once

#include "roomcast/alignment/feature/room_fixture.h"
#include "roomcast/alignment/view/color_picture.h"

namespace roomcast::alignment {

inline const RigidTransform kPose = corner_pose(2, 1.5);

struct Seen {
  CalibrationBundle bundle = bundle_fixture({}, "s", kPose);
  DepthSurface surface = depth_surface(bundle.depth_mm, bundle.calibration.depth);
  ColorPicture picture = color_picture(bundle.color, bundle.calibration, surface);
};

}  // namespace roomcast::alignment
