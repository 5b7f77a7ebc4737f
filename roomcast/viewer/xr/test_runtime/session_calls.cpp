// SPDX-License-Identifier: Apache-2.0
// TestRuntime: sessions, spaces and swapchains (OpenXR 1.0, sections 7, 9 and 10.1).
#include <algorithm>
#include <memory>

#define XR_USE_PLATFORM_EGL
#define XR_USE_GRAPHICS_API_OPENGL
#include <epoxy/egl.h>
#include <openxr/openxr_platform.h>

#include "roomcast/viewer/xr/test_runtime/session_record.h"
#include "roomcast/viewer/xr/test_runtime/test_runtime.h"

namespace roomcast::viewer::xr {
namespace {

void send_state(XrSessionState state) {
  SessionRecord& session = session_record();
  session.state = state;
  session.events.push_back(packed(XrEventDataSessionStateChanged{
      XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED, nullptr, kTheSession, state, session.display}));
}

/// Runtimes find their own GL functions through the client's eglGetProcAddress.
bool finds_gl(const XrGraphicsBindingEGLMNDX& binding) {
  if (binding.getProcAddress == nullptr) return false;
  auto* const get_string =
      reinterpret_cast<const GLubyte* (*)(GLenum)>(binding.getProcAddress("glGetString"));
  return get_string != nullptr && get_string(GL_VERSION) != nullptr;
}

XRAPI_ATTR XrResult XRAPI_CALL create_session(XrInstance, const XrSessionCreateInfo* info,
                                              XrSession* made) {
  SessionRecord& session = session_record();
  if (!session.asked_for_requirements)
    return violation("a session before its graphics requirements",
                     XR_ERROR_GRAPHICS_REQUIREMENTS_CALL_MISSING);
  const auto* binding = static_cast<const XrBaseInStructure*>(info->next);
  const bool is_egl = binding != nullptr && binding->type == XR_TYPE_GRAPHICS_BINDING_EGL_MNDX;
  const bool is_glx =
      binding != nullptr && binding->type == XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR;
  if (!is_egl && !is_glx)
    return violation("a session without a GL context", XR_ERROR_GRAPHICS_DEVICE_INVALID);
  if (is_egl && !finds_gl(*reinterpret_cast<const XrGraphicsBindingEGLMNDX*>(binding)))
    return violation("an EGL context without its functions", XR_ERROR_GRAPHICS_DEVICE_INVALID);
  TestRuntime::instance().uses_egl = is_egl;
  session.exists = true;
  session.display = TestRuntime::kBegin_ns;
  *made = kTheSession;
  send_state(XR_SESSION_STATE_IDLE);
  send_state(XR_SESSION_STATE_READY);
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL destroy_session(XrSession) {
  session_record() = {};
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL begin_session(XrSession, const XrSessionBeginInfo*) {
  SessionRecord& session = session_record();
  if (session.running) return violation("a session begun twice", XR_ERROR_SESSION_RUNNING);
  if (session.state != XR_SESSION_STATE_READY)
    return violation("a session begun before it is ready", XR_ERROR_SESSION_NOT_READY);
  session.running = true;
  send_state(XR_SESSION_STATE_SYNCHRONIZED);
  send_state(XR_SESSION_STATE_VISIBLE);
  send_state(XR_SESSION_STATE_FOCUSED);
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL end_session(XrSession) {
  SessionRecord& session = session_record();
  if (!session.running)
    return violation("a session ended that does not run", XR_ERROR_SESSION_NOT_RUNNING);
  session.running = false;
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL request_exit(XrSession) {
  if (!session_record().running)
    return violation("an end asked for that has come", XR_ERROR_SESSION_NOT_RUNNING);
  TestRuntime::instance().ask_for_end();
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL enumerate_spaces(XrSession, std::uint32_t capacity,
                                                std::uint32_t* count, XrReferenceSpaceType* out) {
  return fill<XrReferenceSpaceType>(capacity, count, out, TestRuntime::instance().spaces);
}

XRAPI_ATTR XrResult XRAPI_CALL create_space(XrSession, const XrReferenceSpaceCreateInfo* info,
                                            XrSpace* space) {
  const auto& offered = TestRuntime::instance().spaces;
  if (std::find(offered.begin(), offered.end(), info->referenceSpaceType) == offered.end())
    return violation("a space that is not offered", XR_ERROR_REFERENCE_SPACE_UNSUPPORTED);
  ++TestRuntime::instance().open_handles;
  *space = handle_from<XrSpace>(
      new SpaceRecord{info->poseInReferenceSpace, -1, info->referenceSpaceType});
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL destroy_space(XrSpace space) {
  --TestRuntime::instance().open_handles;
  delete reinterpret_cast<SpaceRecord*>(space);
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL enumerate_formats(XrSession, std::uint32_t capacity,
                                                 std::uint32_t* count, std::int64_t* out) {
  return fill<std::int64_t>(
      capacity, count, out,
      {GL_RGBA16F, GL_SRGB8_ALPHA8, GL_RGBA8, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32F});
}

XRAPI_ATTR XrResult XRAPI_CALL create_swapchain(XrSession, const XrSwapchainCreateInfo* info,
                                                XrSwapchain* made) {
  constexpr GLsizei kImages = 3;
  auto chain = std::make_unique<SwapchainRecord>();
  chain->info = *info;
  chain->textures.resize(kImages);
  glCreateTextures(GL_TEXTURE_2D, kImages, chain->textures.data());
  for (const GLuint texture : chain->textures) {
    glTextureStorage2D(texture, 1, static_cast<GLenum>(info->format),
                       static_cast<GLsizei>(info->width), static_cast<GLsizei>(info->height));
  }
  ++TestRuntime::instance().open_handles;
  *made = handle_from<XrSwapchain>(chain.release());
  return XR_SUCCESS;
}

SwapchainRecord& record_of(XrSwapchain chain) {
  return *reinterpret_cast<SwapchainRecord*>(chain);
}

XRAPI_ATTR XrResult XRAPI_CALL destroy_swapchain(XrSwapchain handle) {
  const std::unique_ptr<SwapchainRecord> chain(&record_of(handle));
  if (chain->acquired >= 0) --TestRuntime::instance().acquired_images;
  glDeleteTextures(static_cast<GLsizei>(chain->textures.size()), chain->textures.data());
  --TestRuntime::instance().open_handles;
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL acquire_image(XrSwapchain handle, const XrSwapchainImageAcquireInfo*,
                                             std::uint32_t* index) {
  SwapchainRecord& chain = record_of(handle);
  if (chain.acquired >= 0)
    return violation("a picture acquired before the last was released",
                     XR_ERROR_CALL_ORDER_INVALID);
  ++TestRuntime::instance().acquired_images;
  chain.acquired = static_cast<int>(chain.next);
  chain.waited = false;
  *index = chain.next;
  chain.next = (chain.next + 1) % static_cast<std::uint32_t>(chain.textures.size());
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL wait_image(XrSwapchain handle, const XrSwapchainImageWaitInfo*) {
  SwapchainRecord& chain = record_of(handle);
  if (chain.acquired < 0)
    return violation("a picture waited for before it was acquired", XR_ERROR_CALL_ORDER_INVALID);
  if (chain.waited) return violation("a picture waited for twice", XR_ERROR_CALL_ORDER_INVALID);
  auto& scripted = TestRuntime::instance().image_waits;
  const XrResult result = scripted.empty() ? XR_SUCCESS : scripted.front();
  if (!scripted.empty()) scripted.pop_front();
  chain.waited = result == XR_SUCCESS;
  return result;
}

XRAPI_ATTR XrResult XRAPI_CALL release_image(XrSwapchain handle,
                                             const XrSwapchainImageReleaseInfo*) {
  SwapchainRecord& chain = record_of(handle);
  if (chain.acquired < 0 || !chain.waited)
    return violation("a picture released without a wait", XR_ERROR_CALL_ORDER_INVALID);
  --TestRuntime::instance().acquired_images;
  chain.released = chain.acquired;
  chain.acquired = -1;
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL enumerate_images(XrSwapchain handle, std::uint32_t capacity,
                                                std::uint32_t* count,
                                                XrSwapchainImageBaseHeader* out) {
  const SwapchainRecord& chain = record_of(handle);
  *count = static_cast<std::uint32_t>(chain.textures.size());
  if (capacity == 0) return XR_SUCCESS;
  auto* const images = reinterpret_cast<XrSwapchainImageOpenGLKHR*>(out);
  for (std::size_t i = 0; i < chain.textures.size(); ++i) images[i].image = chain.textures[i];
  return XR_SUCCESS;
}

}  // namespace

PFN_xrVoidFunction session_function(const std::string& name) {
  static const std::map<std::string, PFN_xrVoidFunction> functions = {
      {"xrCreateSession", untyped(create_session)},
      {"xrDestroySession", untyped(destroy_session)},
      {"xrBeginSession", untyped(begin_session)},
      {"xrEndSession", untyped(end_session)},
      {"xrRequestExitSession", untyped(request_exit)},
      {"xrEnumerateReferenceSpaces", untyped(enumerate_spaces)},
      {"xrCreateReferenceSpace", untyped(create_space)},
      {"xrDestroySpace", untyped(destroy_space)},
      {"xrEnumerateSwapchainFormats", untyped(enumerate_formats)},
      {"xrCreateSwapchain", untyped(create_swapchain)},
      {"xrDestroySwapchain", untyped(destroy_swapchain)},
      {"xrEnumerateSwapchainImages", untyped(enumerate_images)},
      {"xrAcquireSwapchainImage", untyped(acquire_image)},
      {"xrWaitSwapchainImage", untyped(wait_image)},
      {"xrReleaseSwapchainImage", untyped(release_image)}};
  const auto found = functions.find(name);
  return found != functions.end() ? found->second : nullptr;
}

}  // namespace roomcast::viewer::xr
