// SPDX-License-Identifier: Apache-2.0
// The ways in which surfaces can be drawn.
#pragma once

#include <array>
#include <string_view>

namespace roomcast::render {

enum class RenderMode {
  kPoints,    // a pixel for each depth pixel: the paper's way
  kSplats,    // squares as large as the surface between neighbours
  kMesh,      // a triangle for every three neighbours; the nearest surface wins
  kAdaptive,  // the same of cleaned surfaces, whose flat parts are few triangles
  kBlend,     // cleaned surfaces of all sensors weighted by how well each sees what the eye sees
};
inline constexpr std::array kRenderModes = {RenderMode::kPoints, RenderMode::kSplats,
                                            RenderMode::kMesh, RenderMode::kAdaptive,
                                            RenderMode::kBlend};

[[nodiscard]] constexpr std::string_view name_of(RenderMode mode) {
  switch (mode) {
    case RenderMode::kPoints:
      return "points";
    case RenderMode::kSplats:
      return "splats";
    case RenderMode::kMesh:
      return "mesh";
    case RenderMode::kAdaptive:
      return "adaptive";
    case RenderMode::kBlend:
      return "blend";
  }
  return "";
}

/// What such a picture shows depends on earlier frames, too.
[[nodiscard]] constexpr bool remembers_background(RenderMode mode) {
  return mode == RenderMode::kAdaptive || mode == RenderMode::kBlend;
}

}  // namespace roomcast::render
