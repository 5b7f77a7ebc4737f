// SPDX-License-Identifier: Apache-2.0
// EyeTarget: one eye of a headset. Copies the eye's part of the finished two-eye picture into the
// headset's image, with depth if the headset accepts it. Needs the GL context of the session.
#pragma once

#include <optional>

#include "roomcast/render/gl/gl_object.h"
#include "roomcast/render/view/offscreen_target.h"
#include "roomcast/viewer/xr/eye_picture.h"
#include "roomcast/viewer/xr/swapchain.h"

namespace roomcast::viewer::xr {

class EyeTarget {
 public:
  /// `depth_format` 0: the headset accepts no depth. `number`: index of the eye in the two-eye
  /// picture.
  /// Errors as Swapchain::create.
  static Result<EyeTarget> create(XrSession session, std::int64_t color_format,
                                  std::int64_t depth_format, PictureSize size, int number);

  /// Sets the eye's view for the coming frame. Errors as eye_picture.
  Status look(const XrView& view);
  /// The camera of the picture to draw, in the space of look()'s view.
  [[nodiscard]] render::ViewCamera camera() const;

  /// Copies this eye's part.
  void show(const render::OffscreenTarget& picture);

  /// The result of the last show(): false if the headset gave no image for it in time, so that this
  /// frame has no picture. Errors as Swapchain's.
  [[nodiscard]] const Result<bool>& shown() const { return shown_; }
  /// For xrEndFrame, after show(); contains pointers into this object.
  [[nodiscard]] XrCompositionLayerProjectionView layer();

 private:
  EyeTarget(Swapchain color, int number) : color_(std::move(color)), number_(number) {}
  friend void draw_alike(EyeTarget& left, EyeTarget& right);
  Result<bool> copy(const render::OffscreenTarget& picture);
  Status release();

  Swapchain color_;
  int number_;
  std::optional<Swapchain> depth_;
  render::GlFramebuffer framebuffer_ = render::GlFramebuffer::create();
  EyePicture picture_;
  XrPosef pose_{};
  Result<bool> shown_ = false;
  XrCompositionLayerDepthInfoKHR depth_info_{};
};

/// Call it after look(): gives both pictures the larger size, so that they fit side by side.
void draw_alike(EyeTarget& left, EyeTarget& right);

}  // namespace roomcast::viewer::xr
