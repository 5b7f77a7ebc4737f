// SPDX-License-Identifier: Apache-2.0
// The two streams of an OpenNI 2 device: which of its modes is taken, the cameras that its fields
// of view amount to, and pixels out of its frames. Radians, pixels, millimetres. Single-threaded.
#pragma once

#include <OpenNI.h>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::source {

/// Creates and configures the stream: depth in millimetres, colour as RGB, the widest mode up to
/// 640 pixels, the frame rate nearest to 30, not mirrored. Files keep what they were recorded with.
/// kUnsupported: the device has no such mode.
[[nodiscard]] Status make_openni2_stream(openni::Device& device, openni::SensorType sensor,
                                         openni::VideoStream& stream);

/// A camera without distortion that has the stream's size and fields of view; PrimeSense's where it
/// does not tell (colour of old files).
[[nodiscard]] CameraIntrinsics openni2_camera(const openni::VideoStream& stream);

/// Copies a frame. False when it is cut short or not of this camera's size.
[[nodiscard]] bool copy_openni2_depth(const openni::VideoFrameRef& frame,
                                      const CameraIntrinsics& camera, DepthImage& depth_mm);
[[nodiscard]] bool copy_openni2_color(const openni::VideoFrameRef& frame,
                                      const CameraIntrinsics& camera, ColorImage& color);

}  // namespace roomcast::source
