// SPDX-License-Identifier: Apache-2.0
// OffscreenTarget: an off-screen picture for one eye, or for two side by side: colour, depth, and
// the sensor that drew each pixel. Needs the GL context it was made with.
#pragma once

#include <cstdint>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/render/gl/gl_object.h"
#include "roomcast/render/view/view_camera.h"

namespace roomcast::render {

/// Value of `OffscreenTarget::read_sensors` for a pixel that no sensor drew.
inline constexpr std::int32_t kDrawnByNoSensor = -1;

class OffscreenTarget {
 public:
  /// `width`, `height`: of each eye's part; `eyes`: 1 or 2 (Eyes::count). kInvalidArgument unless
  /// both sides are 1..kMaxImageSide; kUnavailable if the driver cannot render to it.
  static Result<OffscreenTarget> create(int width, int height, int eyes = 1);

  /// The framebuffer's colour attachments.
  static constexpr GLuint kColorAttachment = 0, kSensorsAttachment = 1;

  /// Binds the framebuffer and sets the viewport, so that drawing goes here.
  void bind() const;
  /// Binds the framebuffer and clears it: one colour, infinite depth, no sensor. `alpha`: 0 where
  /// something else is to be seen through the background, else 1.
  void clear(Rgb8 background, float alpha = 1) const;

  /// Size of each eye's part, pixels.
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] int eyes() const { return eyes_; }
  /// The framebuffer, to copy from. The first eye's part is at the left, the second's right of it.
  [[nodiscard]] GLuint framebuffer() const { return framebuffer_.name(); }
  /// The textures, for drawing in several passes with other framebuffers. RGBA8, DEPTH32F.
  [[nodiscard]] const GlTexture& color() const { return color_; }
  [[nodiscard]] const GlTexture& depth() const { return depth_; }

  /// One eye's part, top row first. Waits for drawing to finish.
  [[nodiscard]] ColorImage read_color(int eye = 0) const;
  /// Metres along the axis of `camera`, for which the eye's part was drawn; 0 where there is no
  /// surface.
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
