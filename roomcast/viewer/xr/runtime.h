// SPDX-License-Identifier: Apache-2.0
// Runtime: the connection to a headset's software through the Khronos loader, and its headset.
// Source: OpenXR 1.0, sections 4 and 5.
#pragma once

#include <string>
#include <utility>

#include <openxr/openxr.h>

#include "roomcast/core/result.h"

namespace roomcast::viewer::xr {

class Runtime {
 public:
  /// `binding_extension`: how the headset gets at the current GL context, beside
  /// XR_KHR_opengl_enable; may be null. kUnavailable, with what to do, when there is no headset or
  /// its software cannot work with OpenGL.
  static Result<Runtime> open(const char* binding_extension);
  ~Runtime();
  Runtime(Runtime&& other) noexcept;
  Runtime& operator=(Runtime&& other) noexcept;

  [[nodiscard]] XrInstance instance() const { return instance_; }
  [[nodiscard]] XrSystemId system() const { return system_; }
  /// It can use the depth of pictures, to move them to where the head is when they are seen.
  [[nodiscard]] bool takes_depth() const { return takes_depth_; }
  /// Of the headset and of the software.
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  Runtime() = default;
  Status find_headset();
  Status ask_for_graphics_requirements() const;

  XrInstance instance_ = XR_NULL_HANDLE;
  XrSystemId system_ = XR_NULL_SYSTEM_ID;
  bool takes_depth_ = false;
  std::string name_;
};

}  // namespace roomcast::viewer::xr
