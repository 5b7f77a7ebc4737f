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

using FlowInterpolation = ComputeProgram<shaders::interpolate_flow_comp>;

/// When a sensor took a picture, and how what it shows moves.
struct PictureMotion {
  std::optional<RoomTime> capture_time;          // without it nothing moves
  const scene_flow::FlowField* cells = nullptr;  // of the picture; null: nothing moves
};

class SurfaceFlow {
 public:
  explicit SurfaceFlow(const CameraIntrinsics& depth);

  /// Of the sensor's newest picture.
  void take(const PictureMotion& motion);

  /// Computes the velocities of the newest picture, whose cleaned surface is `depth_m`.
  void interpolate(const FlowInterpolation& program, const GlTexture& depth_m);

  /// How far `instant` is after the newest picture, in seconds, at most kMaxAhead either way; 0
  /// without both.
  [[nodiscard]] float ahead_s(std::optional<RoomTime> instant) const;

  /// Of the newest picture.
  [[nodiscard]] std::optional<RoomTime> time() const { return time_; }
  /// Metres per second of each pixel, in the sensor's frame; RGBA16F, of the lens's size. Zero
  /// until they are interpolated.
  [[nodiscard]] const GlTexture& velocities() const { return velocities_; }

 private:
  int width_, height_;
  GlTexture cells_;  // RGBA16F: scene_flow::CellFlow
  GlTexture velocities_;
  bool velocities_are_zero_ = true;
  std::optional<RoomTime> time_;
  bool moves_ = false;
};

}  // namespace roomcast::render
