// SPDX-License-Identifier: Apache-2.0
// X11's headers define common words as macros; they are included here and the macros undefined
// again.
#include <epoxy/egl.h>
#include <epoxy/glx.h>

#undef Status
#undef None
#undef Success
#undef Bool
#undef Always

#define XR_USE_PLATFORM_XLIB
#define XR_USE_PLATFORM_EGL
#define XR_USE_GRAPHICS_API_OPENGL
#include <utility>
#include <variant>

#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>

#include "roomcast/viewer/xr/graphics_binding.h"
#include "roomcast/viewer/xr/xr_struct.h"

namespace roomcast::viewer::xr {
namespace {

XrGraphicsBindingEGLMNDX egl_binding(EGLContext context) {
  auto binding = xr_struct<XrGraphicsBindingEGLMNDX>(XR_TYPE_GRAPHICS_BINDING_EGL_MNDX);
  // libepoxy's names are macros for variables that hold the functions: the value, not its address.
  binding.getProcAddress = reinterpret_cast<decltype(binding.getProcAddress)>(eglGetProcAddress);
  binding.display = eglGetCurrentDisplay();
  binding.context = context;
  EGLint id = 0;
  if (eglQueryContext(binding.display, context, EGL_CONFIG_ID, &id) && id != 0) {
    const EGLint wanted[] = {EGL_CONFIG_ID, id, EGL_NONE};
    EGLint count = 0;
    eglChooseConfig(binding.display, wanted, &binding.config, 1, &count);
  }
  return binding;
}

XrGraphicsBindingOpenGLXlibKHR glx_binding(GLXContext context) {
  auto binding =
      xr_struct<XrGraphicsBindingOpenGLXlibKHR>(XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR);
  binding.xDisplay = glXGetCurrentDisplay();
  binding.glxDrawable = glXGetCurrentDrawable();
  binding.glxContext = context;
  int id = 0;
  glXQueryContext(binding.xDisplay, context, GLX_FBCONFIG_ID, &id);
  const int wanted[] = {GLX_FBCONFIG_ID, id, 0};
  int count = 0;
  GLXFBConfig* const configs =
      glXChooseFBConfig(binding.xDisplay, DefaultScreen(binding.xDisplay), wanted, &count);
  if (configs == nullptr) return binding;
  if (count > 0) binding.glxFBConfig = configs[0];
  XFree(configs);
  XVisualInfo* const visual = glXGetVisualFromFBConfig(binding.xDisplay, binding.glxFBConfig);
  if (visual == nullptr) return binding;
  binding.visualid = static_cast<std::uint32_t>(visual->visualid);
  XFree(visual);
  return binding;
}

}  // namespace

struct GraphicsBinding::Handles {
  std::variant<XrGraphicsBindingEGLMNDX, XrGraphicsBindingOpenGLXlibKHR> binding;
};

Result<GraphicsBinding> GraphicsBinding::of_current_context() {
  auto handles = std::make_unique<Handles>();
  if (const EGLContext egl = eglGetCurrentContext(); egl != EGL_NO_CONTEXT) {
    handles->binding = egl_binding(egl);
  } else if (const GLXContext glx = glXGetCurrentContext(); glx != nullptr) {
    handles->binding = glx_binding(glx);
  } else {
    return Error{ErrorCode::kUnavailable, "headsets need OpenGL by GLX or EGL; here is neither"};
  }
  return GraphicsBinding(std::move(handles));
}

GraphicsBinding::GraphicsBinding(std::unique_ptr<Handles> handles) : handles_(std::move(handles)) {}
GraphicsBinding::~GraphicsBinding() = default;
GraphicsBinding::GraphicsBinding(GraphicsBinding&&) noexcept = default;
GraphicsBinding& GraphicsBinding::operator=(GraphicsBinding&&) noexcept = default;

const char* GraphicsBinding::extension() const {
  const bool is_egl = std::holds_alternative<XrGraphicsBindingEGLMNDX>(handles_->binding);
  return is_egl ? XR_MNDX_EGL_ENABLE_EXTENSION_NAME : nullptr;
}

const void* GraphicsBinding::chain() const {
  return std::visit([](const auto& binding) -> const void* { return &binding; }, handles_->binding);
}

}  // namespace roomcast::viewer::xr
