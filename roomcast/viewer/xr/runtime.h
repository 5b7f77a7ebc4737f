// SPDX-License-Identifier: Apache-2.0
// Runtime: the connection to an OpenXR runtime through the Khronos loader, and its headset. Source:
// OpenXR 1.0, sections 4 and 5.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <openxr/openxr.h>

#include "roomcast/core/result.h"

namespace roomcast::viewer::xr {

/// The runtime can use pictures' depth to reproject them to the head's pose at display time.
inline constexpr const char* kDepth = XR_KHR_COMPOSITION_LAYER_DEPTH_EXTENSION_NAME;
/// A space with its origin on the floor where the wearer was at first, without a stage; younger
/// than Debian 12's headers.
inline constexpr const char* kLocalFloor = "XR_EXT_local_floor";

class Runtime {
 public:
  /// `binding_extension`: required in addition to XR_KHR_opengl_enable to share the current GL
  /// context; may be null. kUnavailable, with advice, if there is no headset or the runtime does
  /// not support OpenGL.
  static Result<Runtime> open(const char* binding_extension);
  ~Runtime();
  Runtime(Runtime&& other) noexcept;
  Runtime& operator=(Runtime&& other) noexcept;

  [[nodiscard]] XrInstance instance() const { return instance_; }
  [[nodiscard]] XrSystemId system() const { return system_; }
  /// Whether this extension is in use: kDepth, kLocalFloor or a controller's.
  [[nodiscard]] bool has(std::string_view extension) const {
    return extensions_.contains(extension);
  }
  /// Names of the headset and of the runtime.
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  Runtime() = default;
  Status find_headset();
  Status ask_for_graphics_requirements() const;

  XrInstance instance_ = XR_NULL_HANDLE;
  XrSystemId system_ = XR_NULL_SYSTEM_ID;
  std::set<std::string, std::less<>> extensions_;
  std::string name_;
};

}  // namespace roomcast::viewer::xr
