// SPDX-License-Identifier: Apache-2.0
// EyePicture: converts a headset's field of view to one the renderer can draw. A headset's eye may
// see farther to one side than to the other, with non-square pixels; the renderer's lens is centred
// with square pixels. So the renderer draws a larger centred picture, the eye gets a part of it,
// and the headset gets the exact angles of that part. Pure.
// Source: OpenXR 1.0, section 10 (XrFovf, XrCompositionLayerProjectionView).
#pragma once

#include <openxr/openxr.h>

#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/render/view/view_camera.h"
#include "roomcast/viewer/view/view_target.h"

namespace roomcast::viewer::xr {

struct EyePicture {
  PictureSize drawn;            // the centred picture
  double vertical_fov_rad = 1;  // of the centred picture
  int left = 0, bottom = 0;     // corner of the eye's part, from the lower left
  PictureSize part;             // size of the eye's part, at most that of the eye's image
  XrFovf fov{};                 // angles of the eye's part
};

/// `size`: of the eye's image. kUnsupported for angles without a picture (a fault of the runtime).
[[nodiscard]] Result<EyePicture> eye_picture(const XrFovf& fov, PictureSize size);

/// The same part in a larger centred picture; `size`: even, and not below `picture.drawn`.
[[nodiscard]] EyePicture with_size(const EyePicture& picture, PictureSize size);

[[nodiscard]] RigidTransform transform_from_pose(const XrPosef& pose);
[[nodiscard]] XrPosef pose_from_transform(const RigidTransform& transform);

}  // namespace roomcast::viewer::xr
