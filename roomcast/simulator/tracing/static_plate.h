// SPDX-License-Identifier: Apache-2.0
// What a fixed camera sees of the empty room, traced once: everything that stands still costs
// nothing per frame. z is along the optical axis in metres; pixels that see nothing have z = 0.
#pragma once

#include "roomcast/core/image.h"
#include "roomcast/simulator/scene/room.h"
#include "roomcast/simulator/tracing/placed_camera.h"
#include "roomcast/simulator/tracing/ray_scene.h"

namespace roomcast::simulator {

struct DepthPlate {
  // Through the pixels' centres:
  Image<float> z_m;
  Image<float> facing;    // cosine between the surface's normal and the way back to the camera
  Image<float> infrared;  // share of the camera's light that comes back (infrared_back)
  Image<float> detour_m;  // how much too far light that was reflected twice makes it appear
  // Four samples per pixel, two by two:
  Image<float> fine_z_m;
  Image<float> fine_strength;  // signal_strength of sensing/depth_reading.h
};

struct ColorPlate {
  Image<float> z_m;
  ColorImage color;
};

/// `fine`: the same camera with twice the pixels in each direction. Without `multipath` there are
/// no detours.
[[nodiscard]] DepthPlate trace_depth_plate(const Room& room, const RayScene& scene,
                                           const PlacedCamera& camera, const PlacedCamera& fine,
                                           bool multipath, int threads);

/// Lit, shadowed, and smoothed where the picture has edges.
[[nodiscard]] ColorPlate trace_color_plate(const Room& room, const RayScene& scene,
                                           const PlacedCamera& camera, int threads);

/// The same camera with `factor` times the pixels in each direction, on the same area.
[[nodiscard]] CameraIntrinsics resampled(CameraIntrinsics camera, double factor);

}  // namespace roomcast::simulator
