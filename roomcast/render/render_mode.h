// SPDX-License-Identifier: Apache-2.0
// The ways to draw the surfaces of a room.
#pragma once

#include <array>
#include <string_view>

namespace roomcast::render {

enum class RenderMode {
  kPoints,    // one pixel for each depth pixel, as in the paper
  kSplats,    // squares as large as the distance between neighbours
  kMesh,      // triangles between neighbouring depth pixels; the nearest surface wins
  kAdaptive,  // as kMesh, of cleaned surfaces; flat parts become few triangles
  kBlend,     // cleaned surfaces of all sensors, mixed by quality and viewing direction
  kStill,     // the room's model alone: what stands still, without people
};
/// Those that draw what sensors show.
inline constexpr std::array kRenderModes = {RenderMode::kPoints, RenderMode::kSplats,
                                            RenderMode::kMesh, RenderMode::kAdaptive,
                                            RenderMode::kBlend};
/// Those that a viewer can choose.
inline constexpr std::array kViewModes = {RenderMode::kPoints, RenderMode::kSplats,
                                          RenderMode::kMesh,   RenderMode::kAdaptive,
                                          RenderMode::kBlend,  RenderMode::kStill};

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
    case RenderMode::kStill:
      return "still";
  }
  return "";
}

/// True if a picture in this mode also depends on earlier frames.
[[nodiscard]] constexpr bool uses_background_model(RenderMode mode) {
  return mode == RenderMode::kAdaptive || mode == RenderMode::kBlend;
}

}  // namespace roomcast::render
