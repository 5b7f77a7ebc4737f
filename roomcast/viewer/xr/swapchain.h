// SPDX-License-Identifier: Apache-2.0
// Swapchain: the images of one eye that the OpenXR runtime shows in turn.
// Source: OpenXR 1.0, section 10.1.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <epoxy/gl.h>
#include <openxr/openxr.h>

#include "roomcast/core/result.h"
#include "roomcast/viewer/view/view_target.h"

namespace roomcast::viewer::xr {

/// The first of `wanted` that the session offers; 0: none.
[[nodiscard]] Result<std::int64_t> choose_format(XrSession session,
                                                 std::span<const std::int64_t> wanted);

class Swapchain {
 public:
  /// `format`: an OpenGL format that the session offers. `use`: XR_SWAPCHAIN_USAGE_...
  static Result<Swapchain> create(XrSession session, std::int64_t format, PictureSize size,
                                  XrSwapchainUsageFlags use);
  ~Swapchain();
  Swapchain(Swapchain&& other) noexcept;
  Swapchain& operator=(Swapchain&& other) noexcept;

  [[nodiscard]] XrSwapchain handle() const { return handle_; }
  [[nodiscard]] PictureSize size() const { return size_; }

  /// The texture to draw into, once the headset no longer shows it. Empty if the headset does not
  /// give it up in time: then draw nothing, and call acquire() again for the next frame; the same
  /// after a texture that was not released. Errors as xr_status.
  Result<std::optional<GLuint>> acquire();
  /// Marks the image as ready to show. Only after acquire() gave a texture.
  Status release();

 private:
  Swapchain(XrSwapchain handle, PictureSize size) : handle_(handle), size_(size) {}
  Status find_textures();

  XrSwapchain handle_ = XR_NULL_HANDLE;
  PictureSize size_;
  std::vector<GLuint> textures_;
  std::optional<std::uint32_t> acquired_;  // from acquire() to release()
  bool may_be_drawn_ = false;              // the acquired one: waited for
};

}  // namespace roomcast::viewer::xr
