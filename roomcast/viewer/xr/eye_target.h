// SPDX-License-Identifier: Apache-2.0
// EyeTarget: one eye of a headset: of the finished picture of both eyes what this one sees is
// copied into the headset's image, with its depth where the headset takes that. Needs the GL
// context of the session.
#pragma once

#include <optional>

#include "roomcast/render/gl/gl_object.h"
#include "roomcast/render/view/offscreen_target.h"
#include "roomcast/viewer/xr/eye_picture.h"
#include "roomcast/viewer/xr/swapchain.h"

namespace roomcast::viewer::xr {

class EyeTarget {
 public:
  /// `depth_format` 0: the headset takes no depth. `number`: of this eye in the picture of both.
  /// Errors as Swapchain::create.
  static Result<EyeTarget> create(XrSession session, std::int64_t color_format,
                                  std::int64_t depth_format, PictureSize size, int number);

  /// What the eye sees in the coming frame. Errors as eye_picture.
  Status look(const XrView& view);
  /// Of the picture to draw, in the space in which look()'s view was located.
  [[nodiscard]] render::ViewCamera camera() const;

  /// Copies this eye's part.
  void show(const render::OffscreenTarget& picture);

  /// Whether the frame's picture has been shown, or why not.
  [[nodiscard]] const Status& shown() const { return shown_; }
  /// For xrEndFrame, after show(); points into this.
  [[nodiscard]] XrCompositionLayerProjectionView layer();

 private:
  EyeTarget(Swapchain color, int number) : color_(std::move(color)), number_(number) {}
  friend void draw_alike(EyeTarget& left, EyeTarget& right);
  Status copy(const render::OffscreenTarget& picture);

  Swapchain color_;
  int number_;
  std::optional<Swapchain> depth_;
  render::GlFramebuffer framebuffer_ = render::GlFramebuffer::create();
  EyePicture picture_;
  XrPosef pose_{};
  Status shown_;
  XrCompositionLayerDepthInfoKHR depth_info_{};
};

/// After look(): gives both pictures the size of the larger, to be drawn side by side.
void draw_alike(EyeTarget& left, EyeTarget& right);

}  // namespace roomcast::viewer::xr
