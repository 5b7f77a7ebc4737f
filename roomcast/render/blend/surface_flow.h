// SPDX-License-Identifier: Apache-2.0
// SurfaceFlow: how one sensor's live surface moves, on the GPU, and when it was seen. Blend and
// adaptive modes draw what moves where it is at one instant. Needs the GL context it was made with.
#pragma once

#include <optional>

#include "roomcast/core/clock.h"
#include "roomcast/render/gl/shaders.h"
#include "roomcast/scene_flow/scene_flow.h"

namespace roomcast::render {

/// Surfaces are not moved for longer than this: nobody knows how they go on.
inline constexpr nanoseconds kMaxAhead{70'000'000};

class SurfaceFlow {
 public:
  explicit SurfaceFlow(const CameraIntrinsics& depth);

  /// The sensor's newest picture, of the lens's size, and when it was taken; without a time nothing
  /// moves in it. A picture of the same time as the last is taken for the same.
  void take(DepthView depth_mm, std::optional<RoomTime> capture_time);

  /// How far `instant` is after the newest picture, in seconds, at most kMaxAhead either way; 0
  /// without both.
  [[nodiscard]] float ahead_s(std::optional<RoomTime> instant) const;

  /// Of the newest picture.
  [[nodiscard]] std::optional<RoomTime> time() const { return time_; }
  [[nodiscard]] const GlTexture& cells() const { return cells_; }

 private:
  void clear_cells();

  scene_flow::SceneFlow flow_;
  GlTexture cells_;  // RGBA16F, as scene_flow.glsl reads it
  std::optional<RoomTime> time_;
};

}  // namespace roomcast::render
