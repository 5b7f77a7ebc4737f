// SPDX-License-Identifier: Apache-2.0
// Light that reaches a time-of-flight camera by way of two surfaces travels further, and pulls the
// measured phase with it: corners of rooms come out too far (Fuchs, "Multipath interference
// compensation in time-of-flight camera images", ICPR 2010). One bounce: for a point P, rays spread
// by the cosine law find surfaces Q; each sends on to P a share of the camera's light that is
// reflectance * cos / distance^2 of Q against cos / distance^2 of P, along a path that is
// (|PQ| + |QC| - |PC|) / 2 too long. The shares add up as phasors (Gupta et al., "Phasor imaging",
// ACM TOG 2015) at 80 and at 120 MHz, the Kinect v2's high frequencies: light from far away in the
// room cancels itself out. The mean of both counts; where it says "nearer", which no measurement we
// know of shows, there is no detour (ours). Surfaces count as matt, and only those in the picture
// are lit by the camera; of what stands still only. Worked out on every fourth pixel and
// interpolated on the same surface.
#pragma once

#include "roomcast/core/image.h"
#include "roomcast/simulator/scene/room.h"
#include "roomcast/simulator/tracing/placed_camera.h"
#include "roomcast/simulator/tracing/ray_scene.h"

namespace roomcast::simulator {

/// How much too far the surface at each pixel appears along the optical axis, in metres. `z_m`: its
/// depth.
[[nodiscard]] Image<float> trace_detours(const Room& room, const RayScene& scene,
                                         const PlacedCamera& camera, ImageView<const float> z_m,
                                         int threads);

}  // namespace roomcast::simulator
