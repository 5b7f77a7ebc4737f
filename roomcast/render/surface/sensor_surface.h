// SPDX-License-Identifier: Apache-2.0
// SensorSurface: one sensor's newest pictures on the GPU: depth (R16UI, millimetres), colour at the
// depth grid's resolution or twice that (RGB8), the mask of valid colours, and the lens as a table
// of rays (RG32F): about 15 bytes per pixel. Needs a current GL context for its whole life. Shaders
// read it through shaders/sensor_surface.glsl.
#pragma once

#include <cstdint>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/render/gl/shaders.h"

namespace roomcast::render {

/// The largest depth picture that is drawn, four times the largest mode of an Azure Kinect.
inline constexpr int kMaxSurfacePixels = 4 * 1024 * 1024;

class SensorSurface {
 public:
  /// Makes empty pictures. Errors as CameraIntrinsics::check; kTooLarge beyond kMaxSurfacePixels.
  static Result<SensorSurface> create(const CameraIntrinsics& depth);

  /// Replaces the pictures. Without colour (both `color` and `seen` empty) the colour of the whole
  /// surface is unknown. Allocates only when the resolution of colour changes. kInvalidArgument
  /// unless the sizes match `intrinsics()`, colour's once or twice; then the last pictures are
  /// kept.
  Status upload(DepthView depth_mm, ColorView color, MaskView seen);

  /// Binds the pictures for a program that reads them.
  void bind_to(ProgramWith<shaders::sensor_surface_glsl> program) const;

  [[nodiscard]] const GlTexture& depth_mm() const { return depth_mm_; }
  [[nodiscard]] const GlTexture& rays() const { return rays_; }
  [[nodiscard]] const GlTexture& color() const { return color_; }
  [[nodiscard]] const GlTexture& seen() const { return seen_; }

  [[nodiscard]] const CameraIntrinsics& intrinsics() const { return intrinsics_; }
  /// widest_radius_squared() of these, which takes too long to be computed for each drawing.
  [[nodiscard]] double widest_radius_squared() const { return widest_radius_squared_; }
  /// Colour pixels per depth pixel along each axis: 1 or 2.
  [[nodiscard]] int color_scale() const { return color_scale_; }
  [[nodiscard]] int pixel_count() const { return intrinsics_.width * intrinsics_.height; }
  /// The number of uploads. Derived data compare it to find out that they are out of date.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

 private:
  void set_color_scale(int scale);
  explicit SensorSurface(const CameraIntrinsics& depth);

  CameraIntrinsics intrinsics_;
  double widest_radius_squared_;
  GlTexture depth_mm_, rays_, color_, seen_;
  int color_scale_ = 1;
  std::uint64_t revision_ = 0;
};

}  // namespace roomcast::render
