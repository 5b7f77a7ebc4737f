// SPDX-License-Identifier: Apache-2.0
// Multipath of a time-of-flight camera: light that travels via two surfaces has a longer path and
// shifts the measured phase, so corners of rooms are measured too far (Fuchs, "Multipath
// interference compensation in time-of-flight camera images", ICPR 2010). One bounce: for a point
// P, rays spread by the cosine law find surfaces Q; each Q sends to P a share of the camera's light
// that is reflectance * cos / distance^2 of Q relative to cos / distance^2 of P, along a path that
// is (|PQ| + |QC| - |PC|) / 2 too long. The shares add up as phasors (Gupta et al., "Phasor
// imaging", ACM TOG 2015) at 80 and at 120 MHz, the Kinect v2's high frequencies; distant
// contributions cancel out. The result is the mean of both; a negative result, which no measurement
// known to us shows, counts as no detour (ours). Surfaces are treated as matt; only static surfaces
// inside the picture are lit by the camera. Computed on every fourth pixel and interpolated on the
// same surface.
#pragma once

#include "roomcast/core/image.h"
#include "roomcast/core/parallel_rows.h"
#include "roomcast/simulator/scene/room.h"
#include "roomcast/simulator/tracing/placed_camera.h"
#include "roomcast/simulator/tracing/ray_scene.h"

namespace roomcast::simulator {

/// Excess distance of the surface at each pixel along the optical axis, in metres. `z_m`: its
/// depth.
[[nodiscard]] Image<float> trace_detours(const Room& room, const RayScene& scene,
                                         const PlacedCamera& camera, ImageView<const float> z_m,
                                         const Workers& workers);

}  // namespace roomcast::simulator
