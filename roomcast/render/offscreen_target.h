// SPDX-License-Identifier: Apache-2.0
// A picture to draw into that is not on any screen: colour, depth, and which sensor drew each
// pixel. Needs the GL context it was made with.
#pragma once

#include <cstdint>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/render/gl_object.h"
#include "roomcast/render/view_camera.h"

namespace roomcast {

/// In `OffscreenTarget::read_sensors`, a pixel that no sensor drew.
inline constexpr std::int32_t kDrawnByNoSensor = -1;

class OffscreenTarget {
 public:
  /// kInvalidArgument unless both sides are 1..kMaxImageSide; kUnavailable when the driver will not
  /// draw into it.
  static Result<OffscreenTarget> create(int width, int height);

  /// What follows is drawn here: binds the framebuffer and sets the viewport.
  void bind() const;
  /// Binds it and makes it one colour, infinitely far, drawn by no sensor.
  void clear(Rgb8 background) const;

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// To copy the picture from. Attachment 0 is colour, attachment 1 the sensors.
  [[nodiscard]] GLuint framebuffer() const { return framebuffer_.name(); }
  /// For drawings of several passes, which attach them to framebuffers of their own. RGBA8, DEPTH32F.
  [[nodiscard]] const GlTexture& color() const { return color_; }
  [[nodiscard]] const GlTexture& depth() const { return depth_; }

  /// Wait for the drawing to end. Top row first, as every image here.
  [[nodiscard]] ColorImage read_color() const;
  /// Along the axis of the eye for which it was drawn; 0 where no surface was.
  [[nodiscard]] Image<float> read_depth_m(const ViewCamera& camera) const;
  /// SensorId::value, or kDrawnByNoSensor.
  [[nodiscard]] Image<std::int32_t> read_sensors() const;

 private:
  OffscreenTarget(int width, int height);

  int width_, height_;
  GlTexture color_, depth_, sensors_;
  GlFramebuffer framebuffer_;
};

}  // namespace roomcast
