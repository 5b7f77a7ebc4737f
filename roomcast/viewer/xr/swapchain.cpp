// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/xr/swapchain.h"

#include <algorithm>
#include <utility>

#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr_platform.h>

#include "roomcast/viewer/xr/xr_status.h"
#include "roomcast/viewer/xr/xr_struct.h"

namespace roomcast::viewer::xr {
namespace {

constexpr XrDuration kImageWithin_ns = 100'000'000;  // a few frames of the slowest headset

}  // namespace

Result<std::int64_t> choose_format(XrSession session, std::span<const std::int64_t> wanted) {
  const char* const what = "asking for the headset's picture formats";
  std::uint32_t count = 0;
  ROOMCAST_XR_TRY(xrEnumerateSwapchainFormats(session, 0, &count, nullptr), what);
  std::vector<std::int64_t> offered(count);
  ROOMCAST_XR_TRY(xrEnumerateSwapchainFormats(session, count, &count, offered.data()), what);
  for (const std::int64_t format : wanted) {
    if (std::ranges::find(offered, format) != offered.end()) return format;
  }
  return std::int64_t{0};
}

Result<Swapchain> Swapchain::create(XrSession session, std::int64_t format, PictureSize size,
                                    XrSwapchainUsageFlags use) {
  auto info = xr_struct<XrSwapchainCreateInfo>(XR_TYPE_SWAPCHAIN_CREATE_INFO);
  info.usageFlags = use;
  info.format = format;
  info.width = static_cast<std::uint32_t>(size.width);
  info.height = static_cast<std::uint32_t>(size.height);
  info.sampleCount = info.faceCount = info.arraySize = info.mipCount = 1;
  XrSwapchain handle = XR_NULL_HANDLE;
  ROOMCAST_XR_TRY(xrCreateSwapchain(session, &info, &handle), "making pictures for the headset");
  Swapchain made(handle, size);
  if (auto status = made.find_textures(); !status) return status.error();
  return made;
}

Status Swapchain::find_textures() {
  const char* const what = "asking for the headset's pictures";
  std::uint32_t count = 0;
  ROOMCAST_XR_TRY(xrEnumerateSwapchainImages(handle_, 0, &count, nullptr), what);
  std::vector<XrSwapchainImageOpenGLKHR> images(count,
                                                {XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR, nullptr, 0});
  ROOMCAST_XR_TRY(
      xrEnumerateSwapchainImages(handle_, count, &count,
                                 reinterpret_cast<XrSwapchainImageBaseHeader*>(images.data())),
      what);
  for (const auto& image : images) textures_.push_back(image.image);
  return {};
}

Result<std::optional<GLuint>> Swapchain::acquire() {
  if (!acquired_) {
    std::uint32_t index = 0;
    ROOMCAST_XR_TRY(xrAcquireSwapchainImage(handle_, nullptr, &index),
                    "asking for the next picture");
    if (index >= textures_.size())
      return Error{ErrorCode::kUnavailable,
                   "the headset's software names a picture it has not got"};
    acquired_ = index;
    may_be_drawn_ = false;
  }
  if (!may_be_drawn_) {
    auto wait = xr_struct<XrSwapchainImageWaitInfo>(XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO);
    wait.timeout = kImageWithin_ns;
    const XrResult waited = xrWaitSwapchainImage(handle_, &wait);
    if (waited == XR_TIMEOUT_EXPIRED) return std::optional<GLuint>();
    ROOMCAST_XR_TRY(waited, "waiting for the next picture");
    may_be_drawn_ = true;
  }
  return std::optional(textures_[*acquired_]);
}

Status Swapchain::release() {
  acquired_.reset();
  return xr_status(xrReleaseSwapchainImage(handle_, nullptr), "handing over a picture");
}

Swapchain::~Swapchain() {
  if (handle_ != XR_NULL_HANDLE) xrDestroySwapchain(handle_);
}

Swapchain::Swapchain(Swapchain&& other) noexcept
    : handle_(std::exchange(other.handle_, XR_NULL_HANDLE)),
      size_(other.size_),
      textures_(std::move(other.textures_)),
      acquired_(other.acquired_),
      may_be_drawn_(other.may_be_drawn_) {}

Swapchain& Swapchain::operator=(Swapchain&& other) noexcept {
  std::swap(handle_, other.handle_);
  std::swap(size_, other.size_);
  std::swap(textures_, other.textures_);
  std::swap(acquired_, other.acquired_);
  std::swap(may_be_drawn_, other.may_be_drawn_);
  return *this;
}

}  // namespace roomcast::viewer::xr
