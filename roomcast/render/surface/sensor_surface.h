// SPDX-License-Identifier: Apache-2.0
// One sensor's newest pictures on the GPU: depth (R16UI, millimetres), colour in the depth grid
// or twice as fine (RGB8), the mask of where that colour is to be believed, and the lens as a table
// of rays (RG32F): about 15 bytes per pixel. Needs a current GL context for its whole life. Shaders
// read it through shaders/sensor_surface.glsl.
#pragma once

#include <cstdint>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/render/gl/gl_object.h"

namespace roomcast::render {

/// The largest depth picture that is drawn (an Azure Kinect's widest is a quarter of it).
inline constexpr int kMaxSurfacePixels = 4 * 1024 * 1024;

class SensorSurface {
 public:
  /// Empty pictures. Fails as CameraIntrinsics::check does; kTooLarge beyond kMaxSurfacePixels.
  static Result<SensorSurface> create(const CameraIntrinsics& depth);

  /// Replaces the pictures. Without colour (both `color` and `seen` empty) all
  /// of the surface counts as unseen. Allocates nothing but when the resolution of colour changes.
  /// kInvalidArgument unless the sizes are those of `intrinsics()`, colour's that or twice that;
  /// the last pictures are then kept.
  Status upload(DepthView depth_mm, ColorView color, MaskView seen);

  /// Puts the textures where shaders/sensor_surface.glsl looks for them.
  void bind() const;

  [[nodiscard]] const GlTexture& depth_mm() const { return depth_mm_; }
  [[nodiscard]] const GlTexture& rays() const { return rays_; }
  [[nodiscard]] const GlTexture& color() const { return color_; }
  [[nodiscard]] const GlTexture& seen() const { return seen_; }

  [[nodiscard]] const CameraIntrinsics& intrinsics() const { return intrinsics_; }
  /// Colour pixels for each pixel of depth and direction: 1 or 2.
  [[nodiscard]] int color_scale() const { return color_scale_; }
  [[nodiscard]] int pixel_count() const { return intrinsics_.width * intrinsics_.height; }
  /// How many pictures were uploaded: what is derived from one compares it to know that it is out
  /// of date.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

 private:
  void set_color_scale(int scale);
  explicit SensorSurface(const CameraIntrinsics& depth);

  CameraIntrinsics intrinsics_;
  GlTexture depth_mm_, rays_, color_, seen_;
  int color_scale_ = 1;
  std::uint64_t revision_ = 0;
};

}  // namespace roomcast::render
