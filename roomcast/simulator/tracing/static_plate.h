// SPDX-License-Identifier: Apache-2.0
// Static plates: the empty room as seen by a fixed camera, traced once, so that static surfaces
// cost nothing per frame. z is along the optical axis in metres; pixels without a surface have z =
// 0.
#pragma once

#include "roomcast/core/image.h"
#include "roomcast/core/parallel_rows.h"
#include "roomcast/simulator/scene/room.h"
#include "roomcast/simulator/tracing/placed_camera.h"
#include "roomcast/simulator/tracing/ray_scene.h"

namespace roomcast::simulator {

struct DepthPlate {
  // At the pixels' centres:
  Image<float> z_m;
  Image<float> facing;    // cosine between the surface's normal and the direction to the camera
  Image<float> infrared;  // share of the camera's light that returns (infrared_back)
  Image<float> detour_m;  // excess distance caused by light that was reflected twice
  // Four samples per pixel, two by two:
  Image<float> fine_z_m;
  Image<float> fine_strength;  // signal_strength of sensing/depth_reading.h
};

struct ColorPlate {
  Image<float> z_m;
  ColorImage color;
};

/// `fine`: the same camera with twice the pixels in each direction. Without `multipath` the detours
/// are 0.
[[nodiscard]] DepthPlate trace_depth_plate(const Room& room, const RayScene& scene,
                                           const PlacedCamera& camera, const PlacedCamera& fine,
                                           bool multipath, const Workers& workers);

/// Lit, with shadows, and antialiased at edges.
[[nodiscard]] ColorPlate trace_color_plate(const Room& room, const RayScene& scene,
                                           const PlacedCamera& camera, const Workers& workers);

/// The same camera with `factor` times the pixels in each direction, on the same area.
[[nodiscard]] CameraIntrinsics resampled(CameraIntrinsics camera, double factor);

}  // namespace roomcast::simulator
