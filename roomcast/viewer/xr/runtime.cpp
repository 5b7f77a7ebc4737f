// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/xr/runtime.h"

#include <algorithm>
#include <cstring>
#include <string_view>
#include <vector>

#include <epoxy/gl.h>

#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr_platform.h>

#include "roomcast/viewer/xr/controllers.h"
#include "roomcast/viewer/xr/xr_status.h"
#include "roomcast/viewer/xr/xr_struct.h"

namespace roomcast::viewer::xr {
namespace {

constexpr const char* kOpenGl = XR_KHR_OPENGL_ENABLE_EXTENSION_NAME;

Result<std::vector<XrExtensionProperties>> offered_extensions() {
  std::uint32_t count = 0;
  ROOMCAST_XR_TRY(xrEnumerateInstanceExtensionProperties(nullptr, 0, &count, nullptr),
                  "asking the headset's software what it can");
  std::vector<XrExtensionProperties> offered(count, {XR_TYPE_EXTENSION_PROPERTIES, nullptr, {}, 0});
  ROOMCAST_XR_TRY(xrEnumerateInstanceExtensionProperties(nullptr, count, &count, offered.data()),
                  "asking the headset's software what it can");
  return offered;
}

bool is_among(const std::vector<XrExtensionProperties>& offered, std::string_view name) {
  return std::ranges::any_of(
      offered, [&](const XrExtensionProperties& e) { return name == e.extensionName; });
}

std::vector<const char*> helpful_extensions() {
  std::vector<const char*> names = {kDepth, kLocalFloor};
  for (const Controller& controller : kControllers) {
    if (controller.extension != nullptr) names.push_back(controller.extension);
  }
  return names;
}

Result<XrInstance> create_instance(const std::vector<const char*>& extensions) {
  auto info = xr_struct<XrInstanceCreateInfo>(XR_TYPE_INSTANCE_CREATE_INFO);
  std::strncpy(info.applicationInfo.applicationName, "roomcast", XR_MAX_APPLICATION_NAME_SIZE - 1);
  info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 0);
  info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
  info.enabledExtensionNames = extensions.data();
  XrInstance instance = XR_NULL_HANDLE;
  const XrResult created = xrCreateInstance(&info, &instance);
  if (created == XR_ERROR_RUNTIME_FAILURE || created == XR_ERROR_INITIALIZATION_FAILED)
    return unavailable(
        "the headset's software does not answer: start its service (SteamVR, monado-service, ...), "
        "and connect the headset");
  ROOMCAST_XR_TRY(created, "connecting to the headset's software");
  return instance;
}

}  // namespace

Result<Runtime> Runtime::open(const char* binding_extension) {
  auto offered = offered_extensions();
  if (!offered) return offered.error();
  std::vector<const char*> wanted = {kOpenGl};
  if (binding_extension != nullptr) wanted.push_back(binding_extension);
  for (const char* name : wanted) {
    if (!is_among(*offered, name)) {
      const bool is_for_egl = name == binding_extension;
      return unavailable(std::string("the headset's software does not offer ") + name +
                         (is_for_egl ? ", which this window needs; start the viewer with "
                                       "SDL_VIDEODRIVER=x11 and without SDL_VIDEO_X11_FORCE_EGL"
                                     : ", which all windows need"));
    }
  }
  Runtime runtime;
  for (const char* name : helpful_extensions()) {
    if (is_among(*offered, name) && runtime.extensions_.insert(name).second) wanted.push_back(name);
  }
  auto instance = create_instance(wanted);
  if (!instance) return instance.error();
  runtime.instance_ = *instance;
  if (auto status = runtime.find_headset(); !status) return status.error();
  if (auto status = runtime.ask_for_graphics_requirements(); !status) return status.error();
  return runtime;
}

Status Runtime::find_headset() {
  auto wanted = xr_struct<XrSystemGetInfo>(XR_TYPE_SYSTEM_GET_INFO);
  wanted.formFactor = XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY;
  ROOMCAST_XR_TRY(xrGetSystem(instance_, &wanted, &system_), "looking for a headset");
  auto headset = xr_struct<XrSystemProperties>(XR_TYPE_SYSTEM_PROPERTIES);
  ROOMCAST_XR_TRY(xrGetSystemProperties(instance_, system_, &headset), "asking the headset");
  auto software = xr_struct<XrInstanceProperties>(XR_TYPE_INSTANCE_PROPERTIES);
  ROOMCAST_XR_TRY(xrGetInstanceProperties(instance_, &software), "asking the headset's software");
  name_ = std::string(headset.systemName) + " (" + software.runtimeName + ")";
  return {};
}

/// OpenXR requires this call before a session is created. kUnavailable if the driver's OpenGL is
/// too old for the headset.
Status Runtime::ask_for_graphics_requirements() const {
  PFN_xrGetOpenGLGraphicsRequirementsKHR ask = nullptr;
  ROOMCAST_XR_TRY(xrGetInstanceProcAddr(instance_, "xrGetOpenGLGraphicsRequirementsKHR",
                                        reinterpret_cast<PFN_xrVoidFunction*>(&ask)),
                  "asking which OpenGL the headset needs");
  auto needs = xr_struct<XrGraphicsRequirementsOpenGLKHR>(XR_TYPE_GRAPHICS_REQUIREMENTS_OPENGL_KHR);
  ROOMCAST_XR_TRY(ask(instance_, system_, &needs), "asking which OpenGL the headset needs");
  const int version = epoxy_gl_version();
  if (XR_MAKE_VERSION(version / 10, version % 10, 0) >= needs.minApiVersionSupported) return {};
  return Error{ErrorCode::kUnavailable, "the headset needs a newer OpenGL than this driver has"};
}

Runtime::~Runtime() {
  if (instance_ != XR_NULL_HANDLE) xrDestroyInstance(instance_);
}

Runtime::Runtime(Runtime&& other) noexcept
    : instance_(std::exchange(other.instance_, XR_NULL_HANDLE)),
      system_(other.system_),
      extensions_(std::move(other.extensions_)),
      name_(std::move(other.name_)) {}

Runtime& Runtime::operator=(Runtime&& other) noexcept {
  std::swap(instance_, other.instance_);
  std::swap(system_, other.system_);
  std::swap(extensions_, other.extensions_);
  std::swap(name_, other.name_);
  return *this;
}

}  // namespace roomcast::viewer::xr
