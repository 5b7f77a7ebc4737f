// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/gl/gl_context.h"

#include <algorithm>
#include <array>
#include <utility>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include "roomcast/render/gl/egl_display.h"
#include "roomcast/render/gl/gl_libraries.h"

namespace roomcast::render {
namespace {

constexpr int kGlMajor = 4;
constexpr int kGlMinor = 5;

bool worth_keeping(GLenum source, GLenum type) {
  if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) return false;  // make_program returns these
  return type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR ||
         type == GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR;
}

void GLAPIENTRY keep_complaint(GLenum source, GLenum type, GLuint /*id*/, GLenum /*severity*/,
                               GLsizei length, const GLchar* text, const void* user) {
  if (!worth_keeping(source, type)) return;
  auto* complaints = static_cast<GlComplaints*>(const_cast<void*>(user));
  ++complaints->count;
  if (complaints->texts.size() < GlComplaints::kMaxTexts) {
    complaints->texts.emplace_back(text, static_cast<std::size_t>(length));
  }
}

EGLContext core_context(EGLDisplay display) {
  constexpr std::array<EGLint, 9> kAttributes = {EGL_CONTEXT_MAJOR_VERSION,
                                                 kGlMajor,
                                                 EGL_CONTEXT_MINOR_VERSION,
                                                 kGlMinor,
                                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                 EGL_CONTEXT_OPENGL_DEBUG,
                                                 EGL_TRUE,
                                                 EGL_NONE};
  return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kAttributes.data());
}

}  // namespace

Result<EglContext> EglContext::create() {
  if (auto found = find_gl_libraries(); !found) return found.error();
  const auto display = display_without_window();
  if (!display) return display.error();
  const EGLContext context = core_context(*display);
  if (context == EGL_NO_CONTEXT)
    return no_drawing_without_window("the driver refused a 4.5 core context");

  EglContext made(*display, context);
  if (Status started = made.start(); !started) return std::move(started).error();
  return made;
}

EglContext::EglContext(void* display, void* context)
    : display_(display), context_(context), complaints_(std::make_unique<GlComplaints>()) {}

Status EglContext::start() {
  if (Status current = make_current(); !current) return current;
  if (!epoxy_is_desktop_gl() || epoxy_gl_version() < 10 * kGlMajor + kGlMinor) {
    return no_drawing_without_window("the driver gave an older OpenGL");
  }
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(keep_complaint, complaints_.get());
  return {};
}

EglContext::~EglContext() {
  if (context_ == nullptr) return;
  if (eglGetCurrentContext() == context_) {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  eglDestroyContext(display_, context_);
  // The display belongs to the whole process: terminating it would destroy other contexts.
}

EglContext::EglContext(EglContext&& other) noexcept
    : display_(std::exchange(other.display_, nullptr)),
      context_(std::exchange(other.context_, nullptr)),
      complaints_(std::move(other.complaints_)) {}

EglContext& EglContext::operator=(EglContext&& other) noexcept {
  std::swap(display_, other.display_);
  std::swap(context_, other.context_);
  std::swap(complaints_, other.complaints_);
  return *this;
}

Status EglContext::make_current() {
  if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) return {};
  return no_drawing_without_window("the context could not be made current");
}

std::string EglContext::driver_name() const {
  const auto text = [](GLenum name) {
    const GLubyte* words = glGetString(name);
    return std::string(words ? reinterpret_cast<const char*>(words) : "unknown");
  };
  return text(GL_RENDERER) + ", " + text(GL_VERSION);
}

bool is_in_software(std::string_view driver_name) {
  constexpr std::array<std::string_view, 3> kDrivers = {"llvmpipe", "softpipe", "swrast"};
  return std::ranges::any_of(kDrivers, [&](std::string_view name) {
    return driver_name.find(name) != std::string_view::npos;
  });
}

}  // namespace roomcast::render
