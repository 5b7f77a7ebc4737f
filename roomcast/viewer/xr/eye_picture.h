// SPDX-License-Identifier: Apache-2.0
// From what a headset asks for to what the renderer draws. A headset's eye sees farther to one side
// than to the other, and its pixels need not be square; the renderer's lens is centred and its
// pixels are square. So a centred picture is drawn that holds the eye's, and the eye gets its part
// of it; the headset is told the exact angles of that part. Pure.
// Source: OpenXR 1.0, section 10 (XrFovf, XrCompositionLayerProjectionView).
#pragma once

#include <openxr/openxr.h>

#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/render/view/view_camera.h"
#include "roomcast/viewer/view/view_target.h"

namespace roomcast::viewer::xr {

struct EyePicture {
  PictureSize drawn;            // the centred picture
  double vertical_fov_rad = 1;  // of that one
  int left = 0, bottom = 0;     // where the eye's part begins, from the lower left
  PictureSize part;             // its size: at most that of the eye's image
  XrFovf fov{};                 // what it shows
};

/// `size`: of the eye's image. kUnsupported for angles that are no picture (a runtime's fault).
[[nodiscard]] Result<EyePicture> eye_picture(const XrFovf& fov, PictureSize size);

/// The same, of a larger centred picture; `size`: even, and not below `picture.drawn`.
[[nodiscard]] EyePicture with_size(const EyePicture& picture, PictureSize size);

[[nodiscard]] RigidTransform transform_from_pose(const XrPosef& pose);
[[nodiscard]] XrPosef pose_from_transform(const RigidTransform& transform);

}  // namespace roomcast::viewer::xr
