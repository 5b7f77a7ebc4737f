// SPDX-License-Identifier: Apache-2.0
// LightMap: shadows and ambient occlusion of one picture. Both are computed on every fourth pixel
// and interpolated between nodes on the same surface; where nodes disagree about a lamp (at shadow
// edges), the lamp is sampled again for the pixel. Const calls are thread-safe.
#pragma once

#include <array>

#include <Eigen/Core>

#include "roomcast/core/image.h"
#include "roomcast/core/parallel_rows.h"
#include "roomcast/simulator/tracing/lighting.h"
#include "roomcast/simulator/tracing/placed_camera.h"

namespace roomcast::simulator {

class LightMap {
 public:
  LightMap(const Room& room, const RayScene& scene, const PlacedCamera& camera,
           const Workers& workers);

  /// Light that arrives at a point seen at pixel (x, y), linear.
  [[nodiscard]] Eigen::Vector3f arriving(int x, int y, const LitPoint& point,
                                         std::uint32_t dither) const;

 private:
  static constexpr std::size_t kMaxLights = 4;
  struct Node {
    LitPoint point;
    float openness = 0.0F;
    std::array<float, kMaxLights> lamp_seen{};
    bool is_surface = false;
  };
  /// Weighted combination of the nodes around a pixel.
  struct Blend {
    float openness = 0.0F, weight = 0.0F;
    std::array<float, kMaxLights> lamp_seen{}, least_seen{}, most_seen{};
  };
  [[nodiscard]] Node node_at(int x, int y, const PlacedCamera& camera) const;
  [[nodiscard]] Blend blend_around(int x, int y, const LitPoint& point) const;

  const Room& room_;
  const RayScene& scene_;
  Image<Node> nodes_;
};

}  // namespace roomcast::simulator
