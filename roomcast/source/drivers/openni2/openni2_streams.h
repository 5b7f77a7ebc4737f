// SPDX-License-Identifier: Apache-2.0
// The two streams of an OpenNI 2 device: choice of the mode, camera models from the fields of view,
// and copies of the pixels of a frame. Radians, pixels, millimetres. Single-threaded.
#pragma once

#include <OpenNI.h>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::source {

/// Creates and configures the stream: depth in millimetres, colour as RGB, the widest mode up to
/// 640 pixels, the frame rate nearest to 30, not mirrored. Files keep the recorded mode.
/// kUnsupported: the device has no such mode.
[[nodiscard]] Status make_openni2_stream(openni::Device& device, openni::SensorType sensor,
                                         openni::VideoStream& stream);

/// A camera without distortion that has the stream's size and fields of view; PrimeSense's fields
/// if it gives none (colour of old files).
[[nodiscard]] CameraIntrinsics openni2_camera(const openni::VideoStream& stream);

/// Copies a frame. Returns false if it is truncated or not of this camera's size.
[[nodiscard]] bool copy_openni2_depth(const openni::VideoFrameRef& frame,
                                      const CameraIntrinsics& camera, DepthImage& depth_mm);
[[nodiscard]] bool copy_openni2_color(const openni::VideoFrameRef& frame,
                                      const CameraIntrinsics& camera, ColorImage& color);

}  // namespace roomcast::source
