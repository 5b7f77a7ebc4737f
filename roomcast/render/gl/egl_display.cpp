// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/gl/egl_display.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <epoxy/egl.h>

namespace roomcast::render {
namespace {

constexpr EGLint kMaxDevices = 64;

bool client_has(const char* extension) {
  return epoxy_has_egl_extension(EGL_NO_DISPLAY, extension);
}

bool draws_in_software(EGLDeviceEXT device) {
  const char* extensions = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
  return extensions != nullptr && epoxy_extension_in_string(extensions, "EGL_MESA_device_software");
}

std::vector<EGLDisplay> displays_of_cards() {
  const bool lists_devices =
      client_has("EGL_EXT_device_base") ||
      (client_has("EGL_EXT_device_enumeration") && client_has("EGL_EXT_device_query"));
  if (!lists_devices || !client_has("EGL_EXT_platform_device")) return {};
  std::array<EGLDeviceEXT, kMaxDevices> devices{};
  EGLint count = 0;
  if (!eglQueryDevicesEXT(kMaxDevices, devices.data(), &count)) return {};
  std::vector<EGLDisplay> displays;
  for (EGLint i = 0; i < std::min(count, kMaxDevices); ++i) {
    const auto device = devices.at(static_cast<std::size_t>(i));
    if (draws_in_software(device)) continue;
    displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
  }
  return displays;
}

EGLDisplay surfaceless_display() {
  if (!client_has("EGL_MESA_platform_surfaceless")) return EGL_NO_DISPLAY;
  return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
}

/// Starts it; nothing, or what it lacks.
const char* lack_of(EGLDisplay display) {
  if (display == EGL_NO_DISPLAY) return "EGL knows no surfaceless platform";
  if (!eglInitialize(display, nullptr, nullptr)) return "EGL did not start";
  const bool needs_no_config = epoxy_has_egl_extension(display, "EGL_KHR_no_config_context") ||
                               epoxy_has_egl_extension(display, "EGL_MESA_configless_context");
  if (!needs_no_config || !epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context"))
    return "EGL insists on a surface";
  if (!eglBindAPI(EGL_OPENGL_API)) return "EGL offers no desktop OpenGL";
  return nullptr;
}

}  // namespace

Error no_drawing_without_window(const char* what_failed) {
  char code[16];
  std::snprintf(code, sizeof code, "0x%04x", static_cast<unsigned>(eglGetError()));
  return Error{ErrorCode::kUnavailable,
               std::string("OpenGL 4.5 without a window is not to be had here (") + what_failed +
                   ", EGL code " + code +
                   "); install Mesa's drivers: apt install libegl1 libgl1 libgl1-mesa-dri"};
}

Result<void*> display_without_window() {
  if (!client_has("EGL_EXT_platform_base"))
    return no_drawing_without_window("EGL knows no platforms");
  std::vector<EGLDisplay> displays = displays_of_cards();
  const bool in_software = std::getenv("LIBGL_ALWAYS_SOFTWARE") != nullptr;
  displays.insert(in_software ? displays.begin() : displays.end(), surfaceless_display());
  const char* lack = nullptr;
  for (const EGLDisplay display : displays) {
    const char* its_lack = lack_of(display);
    if (its_lack == nullptr) return display;
    if (display != EGL_NO_DISPLAY || lack == nullptr) lack = its_lack;
  }
  return no_drawing_without_window(lack);
}

}  // namespace roomcast::render
