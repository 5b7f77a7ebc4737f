// SPDX-License-Identifier: Apache-2.0
// A picture to draw into that is not on any screen, of one eye or of two side by side: colour,
// depth, and which sensor drew each pixel. Needs the GL context it was made with.
#pragma once

#include <cstdint>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/render/gl/gl_object.h"
#include "roomcast/render/view/view_camera.h"

namespace roomcast::render {

/// In `OffscreenTarget::read_sensors`, a pixel that no sensor drew.
inline constexpr std::int32_t kDrawnByNoSensor = -1;

class OffscreenTarget {
 public:
  /// `width`, `height`: for each eye; `eyes`: 1 or 2 (Eyes::count). kInvalidArgument unless both
  /// sides are 1..kMaxImageSide; kUnavailable when the driver will not draw into it.
  static Result<OffscreenTarget> create(int width, int height, int eyes = 1);

  /// What follows is drawn here: binds the framebuffer and sets the viewport.
  void bind() const;
  /// Binds it and makes it one colour, infinitely far, drawn by no sensor.
  void clear(Rgb8 background) const;

  /// Of each eye's part.
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] int eyes() const { return eyes_; }
  /// To copy the picture from: the first eye's part begins at the left, the second's behind it.
  /// Attachment 0 is colour, attachment 1 the sensors.
  [[nodiscard]] GLuint framebuffer() const { return framebuffer_.name(); }
  /// For drawings of several passes, which attach them to framebuffers of their own. RGBA8,
  /// DEPTH32F.
  [[nodiscard]] const GlTexture& color() const { return color_; }
  [[nodiscard]] const GlTexture& depth() const { return depth_; }

  /// An eye's part. Wait for the drawing to end. Top row first, as every image here.
  [[nodiscard]] ColorImage read_color(int eye = 0) const;
  /// Along the axis of the eye for which it was drawn; 0 where no surface was.
  [[nodiscard]] Image<float> read_depth_m(const ViewCamera& camera, int eye = 0) const;
  /// SensorId::value, or kDrawnByNoSensor.
  [[nodiscard]] Image<std::int32_t> read_sensors(int eye = 0) const;

 private:
  OffscreenTarget(int width, int height, int eyes);
  template <class T>
  [[nodiscard]] Image<T> read_back(const GlTexture& texture, int eye, GLenum format,
                                   GLenum type) const;

  int width_, height_, eyes_;
  GlTexture color_, depth_, sensors_;
  GlFramebuffer framebuffer_;
};

}  // namespace roomcast::render
