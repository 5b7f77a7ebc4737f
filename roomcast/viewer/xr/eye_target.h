// SPDX-License-Identifier: Apache-2.0
// EyeTarget: one eye of a headset as a ViewTarget: the finished picture's part that the eye sees is
// copied into the headset's image, with its depth where the headset takes that. Needs the GL
// context of the session.
#pragma once

#include <optional>

#include "roomcast/render/gl_object.h"
#include "roomcast/viewer/view_target.h"
#include "roomcast/viewer/xr/eye_picture.h"
#include "roomcast/viewer/xr/swapchain.h"

namespace roomcast::xr {

class EyeTarget final : public ViewTarget {
 public:
  /// `depth_format` 0: the headset takes no depth. Errors as Swapchain::create.
  static Result<EyeTarget> create(XrSession session, std::int64_t color_format,
                                  std::int64_t depth_format, PictureSize size);

  /// What the eye sees in the coming frame. Errors as eye_picture.
  Status look(const XrView& view);
  /// Of the picture to draw, in the space in which look()'s view was located.
  [[nodiscard]] ViewCamera camera() const;

  [[nodiscard]] PictureSize size() const override { return picture_.drawn; }
  void show(const OffscreenTarget& picture) override;

  /// Whether the frame's picture has been shown, or why not.
  [[nodiscard]] const Status& shown() const { return shown_; }
  /// For xrEndFrame, after show(); points into this.
  [[nodiscard]] XrCompositionLayerProjectionView layer();

 private:
  explicit EyeTarget(Swapchain color) : color_(std::move(color)) {}
  Status copy(const OffscreenTarget& picture);

  Swapchain color_;
  std::optional<Swapchain> depth_;
  GlFramebuffer framebuffer_ = GlFramebuffer::create();
  EyePicture picture_;
  XrPosef pose_{};
  Status shown_;
  XrCompositionLayerDepthInfoKHR depth_info_{};
};

}  // namespace roomcast::xr
