// SPDX-License-Identifier: Apache-2.0
// EglContext: an OpenGL 4.5 core context without a window, on a graphics card or in software
// (egl_display.h). Threading: a context is current on one thread at a time; all code in render/
// uses the context that is current on the calling thread. Source: EGL_KHR_surfaceless_context,
// EGL_KHR_no_config_context, KHR_debug.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/core/result.h"

namespace roomcast::render {

/// Messages of the driver. Only errors, undefined behaviour and deprecated use are kept.
struct GlComplaints {
  static constexpr std::size_t kMaxTexts = 16;
  std::uint64_t count = 0;
  std::vector<std::string> texts;  // the first kMaxTexts messages
};

/// Must outlive every GL object made while it was current.
class EglContext {
 public:
  /// Makes a new context and makes it current on the calling thread. kUnavailable if none can be
  /// made; the message says what to install.
  static Result<EglContext> create();

  ~EglContext();
  EglContext(EglContext&& other) noexcept;
  EglContext& operator=(EglContext&& other) noexcept;

  /// Makes the context current on the calling thread. kUnavailable while it is current on another
  /// one.
  Status make_current();

  [[nodiscard]] const GlComplaints& complaints() const { return *complaints_; }
  /// The driver's name and version, for logs: "llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Core Profile)
  /// Mesa 22.3.6".
  [[nodiscard]] std::string driver_name() const;

 private:
  EglContext(void* display, void* context);
  Status start();

  void* display_ = nullptr;
  void* context_ = nullptr;
  std::unique_ptr<GlComplaints> complaints_;  // on the heap: the driver keeps its address
};

/// Whether a driver with this name, or GL_RENDERER, draws on the processor.
[[nodiscard]] bool is_in_software(std::string_view driver_name);

}  // namespace roomcast::render
