// SPDX-License-Identifier: Apache-2.0
// An OpenGL 4.5 core context without a window: EGL's surfaceless platform, which Mesa's software
// driver (llvmpipe) offers on any machine and a graphics card's driver where there is one. A
// context is current on one thread at a time; everything in render/ works on the calling thread's
// current one. Source: EGL_MESA_platform_surfaceless, EGL_KHR_surfaceless_context,
// EGL_KHR_no_config_context, KHR_debug.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "roomcast/core/result.h"

namespace roomcast::render {

/// What the driver had to complain about. Only errors, undefined behaviour and deprecated use are
/// kept.
struct GlComplaints {
  static constexpr std::size_t kMaxTexts = 16;
  std::uint64_t count = 0;
  std::vector<std::string> texts;  // the first kMaxTexts of them
};

/// Must outlive every GL object made while it was current.
class EglContext {
 public:
  /// A new context, current on the calling thread. kUnavailable, with what to install, when there
  /// is none to be had.
  static Result<EglContext> create();

  ~EglContext();
  EglContext(EglContext&& other) noexcept;
  EglContext& operator=(EglContext&& other) noexcept;

  /// Makes it current on the calling thread. kUnavailable while it is current on another one.
  Status make_current();

  [[nodiscard]] const GlComplaints& complaints() const { return *complaints_; }
  /// The driver's own words, for logs: "llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Core Profile)
  /// Mesa 22.3.6".
  [[nodiscard]] std::string driver_name() const;

 private:
  EglContext(void* display, void* context);
  Status start();

  void* display_ = nullptr;
  void* context_ = nullptr;
  std::unique_ptr<GlComplaints> complaints_;  // on the heap: the driver keeps its address
};

}  // namespace roomcast::render
