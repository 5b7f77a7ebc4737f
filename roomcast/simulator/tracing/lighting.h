// SPDX-License-Identifier: Apache-2.0
// The light that arrives at a point of the room. Linear light per channel; Lambert's cosine law,
// inverse squares softened near the lamp, and an ambient term scaled by ambient occlusion. Thread-
// safe.
#pragma once

#include <cstdint>
#include <span>

#include <Eigen/Core>

#include "roomcast/simulator/scene/room.h"
#include "roomcast/simulator/tracing/ray_scene.h"

namespace roomcast::simulator {

/// A surface point to be lit.
struct LitPoint {
  Eigen::Vector3f position_m = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::UnitY();
};

/// Light from a lamp without occlusion.
[[nodiscard]] Eigen::Vector3f light_from(const Light& light, const LitPoint& at);
[[nodiscard]] Eigen::Vector3f ambient_light(const Room& room, const LitPoint& at, float openness);

/// Visible share of the lamp's face from the point, by rays to `ray_count` positions spread over
/// it; the dither rotates the spread. Uses fewer rays if the first four agree.
[[nodiscard]] float share_of_lamp_seen(const RayScene& scene, const Light& light,
                                       const LitPoint& at, int ray_count, std::uint32_t dither);

/// The n-th of `count` unit vectors spread about the normal by the cosine law.
[[nodiscard]] Eigen::Vector3f cosine_direction(const Eigen::Vector3f& normal, int number,
                                               int count);

/// Share of the directions around the normal, weighted by their cosine, that are free for one
/// metre.
[[nodiscard]] float openness_at(const RayScene& scene, const LitPoint& at);

/// Light that leaves a surface: its glow plus the reflection of `arriving`.
[[nodiscard]] Eigen::Vector3f light_leaving(const Surface& surface, const Eigen::Vector3f& albedo,
                                            const Eigen::Vector3f& arriving);

}  // namespace roomcast::simulator
