// SPDX-License-Identifier: Apache-2.0
// GraphicsBinding: describes the GL context to an OpenXR runtime: the one current on this thread,
// made by GLX (XR_KHR_opengl_enable) or by EGL (XR_MNDX_egl_enable).
#pragma once

#include <memory>

#include "roomcast/core/result.h"

namespace roomcast::viewer::xr {

class GraphicsBinding {
 public:
  /// kUnavailable if there is neither.
  static Result<GraphicsBinding> of_current_context();
  ~GraphicsBinding();
  GraphicsBinding(GraphicsBinding&&) noexcept;
  GraphicsBinding& operator=(GraphicsBinding&&) noexcept;

  /// The extension required in addition to XR_KHR_opengl_enable; null for GLX.
  [[nodiscard]] const char* extension() const;
  /// For XrSessionCreateInfo::next.
  [[nodiscard]] const void* chain() const;

 private:
  struct Handles;
  explicit GraphicsBinding(std::unique_ptr<Handles> handles);
  std::unique_ptr<Handles> handles_;
};

}  // namespace roomcast::viewer::xr
