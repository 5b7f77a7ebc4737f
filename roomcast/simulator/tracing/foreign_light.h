// SPDX-License-Identifier: Apache-2.0
// ForeignLight: the infrared light of another depth camera on the surfaces that a camera sees, as a
// multiple of the camera's own light there. Both projectors are taken to be equally strong, next to
// their cameras, and to light just their cameras' pictures; light falls off with the square of the
// distance and with the cosine of incidence. The empty room alone casts shadows.
#pragma once

#include "roomcast/core/image.h"
#include "roomcast/core/parallel_rows.h"
#include "roomcast/simulator/tracing/placed_camera.h"
#include "roomcast/simulator/tracing/ray_scene.h"

namespace roomcast::simulator {

inline constexpr float kMaxForeignLight = 8.0F;  // times the camera's own light

/// A picture of `camera`: 0 where the other's light does not reach, up to kMaxForeignLight.
[[nodiscard]] Image<float> trace_foreign_light(const RayScene& scene, const PlacedCamera& camera,
                                               const PlacedCamera& other, const Workers& workers);

}  // namespace roomcast::simulator
