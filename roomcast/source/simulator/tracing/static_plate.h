// SPDX-License-Identifier: Apache-2.0
// What a fixed camera sees of the empty room, traced once: everything that stands still costs
// nothing per frame. z is along the optical axis in metres; pixels that see nothing have z = 0.
#pragma once

#include "roomcast/core/image.h"
#include "roomcast/source/simulator/scene/room.h"
#include "roomcast/source/simulator/tracing/placed_camera.h"
#include "roomcast/source/simulator/tracing/ray_scene.h"

namespace roomcast::sim {

struct DepthPlate {
  Image<float> z_m;
  Image<float> facing;    // cosine between the surface's normal and the way back to the camera
  Image<float> infrared;  // share of the camera's light that the surface returns
};

struct ColorPlate {
  Image<float> z_m;
  ColorImage color;
};

[[nodiscard]] DepthPlate trace_depth_plate(const Room& room, const RayScene& scene,
                                           const PlacedCamera& camera);

/// Lit, shadowed, and smoothed where the picture has edges.
[[nodiscard]] ColorPlate trace_color_plate(const Room& room, const RayScene& scene,
                                           const PlacedCamera& camera);

}  // namespace roomcast::sim
