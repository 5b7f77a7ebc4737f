// SPDX-License-Identifier: Apache-2.0
// Tests the test runtime itself: it must detect the violations that real runtimes reject. Uses raw
// OpenXR, so that the client can violate the rules.
#include <cstdlib>
#include <cstring>

#include <gtest/gtest.h>

#include "roomcast/render/gl/gl_fixture.h"
#include "roomcast/viewer/xr/test_runtime/test_runtime.h"
#include "roomcast/viewer/xr/xr_struct.h"

#define XR_USE_PLATFORM_EGL
#define XR_USE_GRAPHICS_API_OPENGL
#include <epoxy/egl.h>
#include <openxr/openxr_platform.h>

namespace roomcast::viewer::xr {
namespace {

class TestRuntimeTest : public render::GlTest {
 protected:
  void SetUp() override {
    render::GlTest::SetUp();
    ::setenv("XR_RUNTIME_JSON", ROOMCAST_TEST_OPENXR, 1);
    ::setenv("XR_LOADER_DEBUG", "none", 1);
    runtime.reset();
    const char* const extensions[] = {XR_KHR_OPENGL_ENABLE_EXTENSION_NAME,
                                      XR_MNDX_EGL_ENABLE_EXTENSION_NAME};
    auto info = xr_struct<XrInstanceCreateInfo>(XR_TYPE_INSTANCE_CREATE_INFO);
    std::strcpy(info.applicationInfo.applicationName, "test");
    info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 0);
    info.enabledExtensionCount = 2;
    info.enabledExtensionNames = extensions;
    ASSERT_EQ(xrCreateInstance(&info, &instance), XR_SUCCESS);
  }
  void TearDown() override {
    if (session != XR_NULL_HANDLE) xrDestroySession(session);
    if (instance != XR_NULL_HANDLE) xrDestroyInstance(instance);
    render::GlTest::TearDown();
  }

  void ask_for_requirements() {
    PFN_xrGetOpenGLGraphicsRequirementsKHR ask = nullptr;
    ASSERT_EQ(xrGetInstanceProcAddr(instance, "xrGetOpenGLGraphicsRequirementsKHR",
                                    reinterpret_cast<PFN_xrVoidFunction*>(&ask)),
              XR_SUCCESS);
    auto needs =
        xr_struct<XrGraphicsRequirementsOpenGLKHR>(XR_TYPE_GRAPHICS_REQUIREMENTS_OPENGL_KHR);
    ASSERT_EQ(ask(instance, 1, &needs), XR_SUCCESS);
  }

  XrResult create_session(bool with_functions = true) {
    auto binding = xr_struct<XrGraphicsBindingEGLMNDX>(XR_TYPE_GRAPHICS_BINDING_EGL_MNDX);
    binding.display = eglGetCurrentDisplay();
    binding.context = eglGetCurrentContext();
    if (with_functions)
      binding.getProcAddress =
          reinterpret_cast<decltype(binding.getProcAddress)>(eglGetProcAddress);
    auto info = xr_struct<XrSessionCreateInfo>(XR_TYPE_SESSION_CREATE_INFO);
    info.next = &binding;
    info.systemId = 1;
    return xrCreateSession(instance, &info, &session);
  }

  void begin() {
    ask_for_requirements();
    ASSERT_EQ(create_session(), XR_SUCCESS);
    auto info = xr_struct<XrSessionBeginInfo>(XR_TYPE_SESSION_BEGIN_INFO);
    info.primaryViewConfigurationType = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
    ASSERT_EQ(xrBeginSession(session, &info), XR_SUCCESS);
  }

  XrSwapchain make_swapchain() {
    auto info = xr_struct<XrSwapchainCreateInfo>(XR_TYPE_SWAPCHAIN_CREATE_INFO);
    info.usageFlags = XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT;
    info.format = GL_RGBA8;
    info.width = info.height = 16;
    info.sampleCount = info.faceCount = info.arraySize = info.mipCount = 1;
    XrSwapchain swapchain = XR_NULL_HANDLE;
    EXPECT_EQ(xrCreateSwapchain(session, &info, &swapchain), XR_SUCCESS);
    return swapchain;
  }

  TestRuntime& runtime = TestRuntime::instance();
  XrInstance instance = XR_NULL_HANDLE;
  XrSession session = XR_NULL_HANDLE;
};

TEST_F(TestRuntimeTest, the_loader_and_the_test_speak_to_the_same_one) {
  begin();
  EXPECT_TRUE(runtime.uses_egl);
  EXPECT_TRUE(runtime.violations.empty());
}

TEST_F(TestRuntimeTest, notices_a_session_before_its_graphics_requirements) {
  EXPECT_EQ(create_session(), XR_ERROR_GRAPHICS_REQUIREMENTS_CALL_MISSING);
  EXPECT_EQ(runtime.violations.size(), 1U);
}

TEST_F(TestRuntimeTest, notices_an_egl_context_without_its_functions) {
  ask_for_requirements();
  EXPECT_EQ(create_session(false), XR_ERROR_GRAPHICS_DEVICE_INVALID);
  EXPECT_EQ(runtime.violations.size(), 1U);
}

TEST_F(TestRuntimeTest, notices_a_picture_that_is_released_without_a_wait) {
  begin();
  const XrSwapchain swapchain = make_swapchain();
  std::uint32_t index = 0;
  ASSERT_EQ(xrAcquireSwapchainImage(swapchain, nullptr, &index), XR_SUCCESS);
  EXPECT_EQ(xrReleaseSwapchainImage(swapchain, nullptr), XR_ERROR_CALL_ORDER_INVALID);
  ASSERT_EQ(runtime.violations.size(), 1U);
  EXPECT_EQ(runtime.violations[0], "a picture released without a wait");
  xrDestroySwapchain(swapchain);
}

TEST_F(TestRuntimeTest, notices_a_frame_that_is_begun_without_a_wait) {
  begin();
  EXPECT_EQ(xrBeginFrame(session, nullptr), XR_ERROR_CALL_ORDER_INVALID);
  EXPECT_EQ(runtime.violations.size(), 1U);
}

TEST_F(TestRuntimeTest, notices_a_frame_for_another_time) {
  begin();
  auto frame = xr_struct<XrFrameState>(XR_TYPE_FRAME_STATE);
  ASSERT_EQ(xrWaitFrame(session, nullptr, &frame), XR_SUCCESS);
  ASSERT_EQ(xrBeginFrame(session, nullptr), XR_SUCCESS);
  auto info = xr_struct<XrFrameEndInfo>(XR_TYPE_FRAME_END_INFO);
  info.displayTime = frame.predictedDisplayTime + 5;
  info.environmentBlendMode = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
  EXPECT_EQ(xrEndFrame(session, &info), XR_ERROR_TIME_INVALID);
  EXPECT_EQ(runtime.violations.size(), 1U);
}

TEST_F(TestRuntimeTest, notices_a_rectangle_that_leaves_its_picture) {
  begin();
  const XrSwapchain swapchain = make_swapchain();
  std::uint32_t index = 0;
  auto wait = xr_struct<XrSwapchainImageWaitInfo>(XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO);
  ASSERT_EQ(xrAcquireSwapchainImage(swapchain, nullptr, &index), XR_SUCCESS);
  ASSERT_EQ(xrWaitSwapchainImage(swapchain, &wait), XR_SUCCESS);
  ASSERT_EQ(xrReleaseSwapchainImage(swapchain, nullptr), XR_SUCCESS);
  auto frame = xr_struct<XrFrameState>(XR_TYPE_FRAME_STATE);
  ASSERT_EQ(xrWaitFrame(session, nullptr, &frame), XR_SUCCESS);
  ASSERT_EQ(xrBeginFrame(session, nullptr), XR_SUCCESS);
  XrCompositionLayerProjectionView views[2];
  for (auto& view : views) {
    view = xr_struct<XrCompositionLayerProjectionView>(XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW);
    view.pose.orientation.w = 1;
    view.subImage.swapchain = swapchain;
    view.subImage.imageRect = {{1, 0}, {16, 16}};
  }
  auto layer = xr_struct<XrCompositionLayerProjection>(XR_TYPE_COMPOSITION_LAYER_PROJECTION);
  layer.viewCount = 2;
  layer.views = views;
  const auto* const base = reinterpret_cast<const XrCompositionLayerBaseHeader*>(&layer);
  auto info = xr_struct<XrFrameEndInfo>(XR_TYPE_FRAME_END_INFO);
  info.displayTime = frame.predictedDisplayTime;
  info.environmentBlendMode = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
  info.layerCount = 1;
  info.layers = &base;
  EXPECT_EQ(xrEndFrame(session, &info), XR_ERROR_SWAPCHAIN_RECT_INVALID);
  EXPECT_EQ(runtime.violations.size(), 1U);
  xrDestroySwapchain(swapchain);
}

}  // namespace
}  // namespace roomcast::viewer::xr
