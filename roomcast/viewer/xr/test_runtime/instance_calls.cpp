// SPDX-License-Identifier: Apache-2.0
// TestRuntime: the runtime, its headset and its events (OpenXR 1.0, sections 4 and 5), and the
// loader's entry point.
#include <cstdio>
#include <cstring>

#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr_platform.h>

#include "roomcast/viewer/xr/test_runtime/session_record.h"
#include "roomcast/viewer/xr/test_runtime/test_runtime.h"

namespace roomcast::viewer::xr {
namespace {

using XrAnswer = XrResult;

std::vector<std::string> offered() {
  std::vector<std::string> names = {"XR_KHR_opengl_enable"};
  const TestRuntime& runtime = TestRuntime::instance();
  if (runtime.offers_egl) names.emplace_back("XR_MNDX_egl_enable");
  if (runtime.offers_depth) names.emplace_back("XR_KHR_composition_layer_depth");
  names.insert(names.end(), runtime.more_extensions.begin(), runtime.more_extensions.end());
  return names;
}

XRAPI_ATTR XrAnswer XRAPI_CALL enumerate_extensions(const char*, std::uint32_t capacity,
                                                    std::uint32_t* count,
                                                    XrExtensionProperties* items) {
  const auto names = offered();
  *count = static_cast<std::uint32_t>(names.size());
  if (capacity == 0) return XR_SUCCESS;
  if (capacity < names.size()) return XR_ERROR_SIZE_INSUFFICIENT;
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::strncpy(items[i].extensionName, names[i].c_str(), XR_MAX_EXTENSION_NAME_SIZE - 1);
    items[i].extensionVersion = 1;
  }
  return XR_SUCCESS;
}

XRAPI_ATTR XrAnswer XRAPI_CALL create_instance(const XrInstanceCreateInfo* info,
                                               XrInstance* instance) {
  if (!TestRuntime::instance().service_runs) return XR_ERROR_RUNTIME_FAILURE;
  TestRuntime::instance().extensions.clear();
  for (std::uint32_t i = 0; i < info->enabledExtensionCount; ++i) {
    bool known = false;
    for (const std::string& name : offered()) known |= name == info->enabledExtensionNames[i];
    if (!known) return XR_ERROR_EXTENSION_NOT_PRESENT;
    TestRuntime::instance().extensions.emplace(info->enabledExtensionNames[i]);
  }
  *instance = kTheInstance;
  return XR_SUCCESS;
}

XRAPI_ATTR XrAnswer XRAPI_CALL destroy_instance(XrInstance) {
  if (session_record().exists)
    return violation("instance destroyed before its session", XR_SUCCESS);
  return XR_SUCCESS;
}

XRAPI_ATTR XrAnswer XRAPI_CALL get_instance_properties(XrInstance, XrInstanceProperties* out) {
  out->runtimeVersion = XR_MAKE_VERSION(1, 0, 0);
  std::strcpy(out->runtimeName, "roomcast test runtime");
  return XR_SUCCESS;
}

XRAPI_ATTR XrAnswer XRAPI_CALL poll_event(XrInstance, XrEventDataBuffer* event) {
  auto& events = session_record().events;
  if (events.empty()) return XR_EVENT_UNAVAILABLE;
  std::memcpy(event, &events.front(), sizeof events.front());
  events.pop_front();
  return XR_SUCCESS;
}

XRAPI_ATTR XrAnswer XRAPI_CALL result_to_string(XrInstance, XrResult value, char* text) {
  std::snprintf(text, XR_MAX_RESULT_STRING_SIZE, "XR_RESULT_%d", static_cast<int>(value));
  return XR_SUCCESS;
}

XRAPI_ATTR XrAnswer XRAPI_CALL type_to_string(XrInstance, XrStructureType value, char* text) {
  std::snprintf(text, XR_MAX_STRUCTURE_NAME_SIZE, "XR_TYPE_%d", static_cast<int>(value));
  return XR_SUCCESS;
}

XRAPI_ATTR XrAnswer XRAPI_CALL get_system(XrInstance, const XrSystemGetInfo* wanted,
                                          XrSystemId* system) {
  if (wanted->formFactor != XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY)
    return XR_ERROR_FORM_FACTOR_UNSUPPORTED;
  if (!TestRuntime::instance().is_connected) return XR_ERROR_FORM_FACTOR_UNAVAILABLE;
  *system = 1;
  return XR_SUCCESS;
}

XRAPI_ATTR XrAnswer XRAPI_CALL get_system_properties(XrInstance, XrSystemId,
                                                     XrSystemProperties* out) {
  out->systemId = 1;
  out->vendorId = 0;
  std::strcpy(out->systemName, "test headset");
  out->graphicsProperties = {4096, 4096, 16};
  out->trackingProperties = {XR_TRUE, XR_TRUE};
  return XR_SUCCESS;
}

XRAPI_ATTR XrAnswer XRAPI_CALL enumerate_blend_modes(XrInstance, XrSystemId,
                                                     XrViewConfigurationType,
                                                     std::uint32_t capacity, std::uint32_t* count,
                                                     XrEnvironmentBlendMode* out) {
  return fill<XrEnvironmentBlendMode>(capacity, count, out, TestRuntime::instance().blend_modes);
}

XRAPI_ATTR XrAnswer XRAPI_CALL enumerate_view_configurations(XrInstance, XrSystemId,
                                                             std::uint32_t capacity,
                                                             std::uint32_t* count,
                                                             XrViewConfigurationType* out) {
  return fill<XrViewConfigurationType>(capacity, count, out,
                                       {XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO});
}

XRAPI_ATTR XrAnswer XRAPI_CALL get_view_configuration(XrInstance, XrSystemId,
                                                      XrViewConfigurationType type,
                                                      XrViewConfigurationProperties* out) {
  out->viewConfigurationType = type;
  out->fovMutable = XR_FALSE;
  return XR_SUCCESS;
}

XRAPI_ATTR XrAnswer XRAPI_CALL enumerate_views(XrInstance, XrSystemId, XrViewConfigurationType,
                                               std::uint32_t capacity, std::uint32_t* count,
                                               XrViewConfigurationView* out) {
  constexpr std::uint32_t kMax = 4096;
  const XrViewConfigurationView view = {XR_TYPE_VIEW_CONFIGURATION_VIEW,
                                        nullptr,
                                        TestRuntime::kEyeWidth,
                                        kMax,
                                        TestRuntime::kEyeHeight,
                                        kMax,
                                        1,
                                        1};
  return fill<XrViewConfigurationView>(capacity, count, out, {view, view});
}

XRAPI_ATTR XrAnswer XRAPI_CALL get_gl_requirements(XrInstance, XrSystemId,
                                                   XrGraphicsRequirementsOpenGLKHR* out) {
  out->minApiVersionSupported = XR_MAKE_VERSION(4, 3, 0);
  out->maxApiVersionSupported = XR_MAKE_VERSION(4, 6, 0);
  session_record().asked_for_requirements = true;
  return XR_SUCCESS;
}

XRAPI_ATTR XrAnswer XRAPI_CALL get_function(XrInstance, const char* name,
                                            PFN_xrVoidFunction* function);

}  // namespace

PFN_xrVoidFunction instance_function(const std::string& name) {
  static const std::map<std::string, PFN_xrVoidFunction> functions = {
      {"xrGetInstanceProcAddr", untyped(get_function)},
      {"xrEnumerateInstanceExtensionProperties", untyped(enumerate_extensions)},
      {"xrCreateInstance", untyped(create_instance)},
      {"xrDestroyInstance", untyped(destroy_instance)},
      {"xrGetInstanceProperties", untyped(get_instance_properties)},
      {"xrPollEvent", untyped(poll_event)},
      {"xrResultToString", untyped(result_to_string)},
      {"xrStructureTypeToString", untyped(type_to_string)},
      {"xrGetSystem", untyped(get_system)},
      {"xrGetSystemProperties", untyped(get_system_properties)},
      {"xrEnumerateEnvironmentBlendModes", untyped(enumerate_blend_modes)},
      {"xrEnumerateViewConfigurations", untyped(enumerate_view_configurations)},
      {"xrGetViewConfigurationProperties", untyped(get_view_configuration)},
      {"xrEnumerateViewConfigurationViews", untyped(enumerate_views)},
      {"xrGetOpenGLGraphicsRequirementsKHR", untyped(get_gl_requirements)}};
  const auto found = functions.find(name);
  return found != functions.end() ? found->second : nullptr;
}

namespace {

XRAPI_ATTR XrAnswer XRAPI_CALL get_function(XrInstance, const char* name,
                                            PFN_xrVoidFunction* function) {
  for (const auto find : {instance_function, session_function, frame_function, input_function}) {
    *function = find(name);
    if (*function != nullptr) return XR_SUCCESS;
  }
  return XR_ERROR_FUNCTION_UNSUPPORTED;
}

// Version 1 of the OpenXR loader's interface with runtimes.
struct LoaderInfo {
  std::uint32_t type, version;
  std::size_t size;
  std::uint32_t min_interface, max_interface;
  XrVersion min_api, max_api;
};
struct RuntimeRequest {
  std::uint32_t type, version;
  std::size_t size;
  std::uint32_t interface_version;
  XrVersion api_version;
  PFN_xrGetInstanceProcAddr get_function;
};

}  // namespace
}  // namespace roomcast::viewer::xr

extern "C" __attribute__((visibility("default"))) XrResult xrNegotiateLoaderRuntimeInterface(
    const roomcast::viewer::xr::LoaderInfo* loader, roomcast::viewer::xr::RuntimeRequest* request) {
  constexpr std::uint32_t kInterface = 1;
  if (loader->min_interface > kInterface || loader->max_interface < kInterface)
    return XR_ERROR_INITIALIZATION_FAILED;
  request->interface_version = kInterface;
  request->api_version = XR_CURRENT_API_VERSION;
  request->get_function = roomcast::viewer::xr::get_function;
  return XR_SUCCESS;
}
