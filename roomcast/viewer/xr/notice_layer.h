// SPDX-License-Identifier: Apache-2.0
// NoticeLayer: sentences before the wearer's eyes, on a board that goes with the head, below the
// line of sight. Needs the GL context of the session.
// Source: OpenXR 1.0, section 10.5 (XrCompositionLayerQuad).
#pragma once

#include <memory>
#include <vector>

#include "roomcast/viewer/report/toasts.h"
#include "roomcast/viewer/text/text_picture.h"
#include "roomcast/viewer/xr/swapchain.h"

namespace roomcast::viewer::xr {

class NoticeLayer {
 public:
  /// Errors as xr_status.
  static Result<std::unique_ptr<NoticeLayer>> create(XrSession session, std::int64_t color_format);
  ~NoticeLayer();
  NoticeLayer(const NoticeLayer&) = delete;
  NoticeLayer& operator=(const NoticeLayer&) = delete;

  /// Shows these sentences instead of the earlier ones. Errors as Swapchain's.
  Status show(const std::vector<Toast>& sentences);
  [[nodiscard]] bool is_shown() const { return !shown_.empty(); }
  /// For xrEndFrame, while is_shown().
  [[nodiscard]] XrCompositionLayerQuad layer() const;

 private:
  explicit NoticeLayer(Swapchain images);
  Status create_space(XrSession session);

  Swapchain images_;
  TextPicture text_;
  XrSpace head_ = XR_NULL_HANDLE;
  std::vector<Toast> shown_;
  int height_px_ = 0;  // of the image's part with the text
};

}  // namespace roomcast::viewer::xr
