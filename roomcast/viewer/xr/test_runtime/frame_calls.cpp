// SPDX-License-Identifier: Apache-2.0
// TestRuntime: frames, views and layers (OpenXR 1.0, section 10).
#include <algorithm>
#include <cmath>

#include "roomcast/viewer/xr/test_runtime/session_record.h"
#include "roomcast/viewer/xr/test_runtime/test_runtime.h"

namespace roomcast::viewer::xr {
namespace {

XRAPI_ATTR XrResult XRAPI_CALL wait_frame(XrSession, const XrFrameWaitInfo*, XrFrameState* frame) {
  SessionRecord& session = session_record();
  if (session.lost) return XR_ERROR_SESSION_LOST;
  if (!session.running)
    return violation("a frame waited for without a session", XR_ERROR_SESSION_NOT_RUNNING);
  session.display += TestRuntime::kPeriod_ns;
  session.frame_waited = true;
  frame->predictedDisplayTime = session.display;
  frame->predictedDisplayPeriod = TestRuntime::kPeriod_ns;
  frame->shouldRender = TestRuntime::instance().is_seen ? XR_TRUE : XR_FALSE;
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL begin_frame(XrSession, const XrFrameBeginInfo*) {
  SessionRecord& session = session_record();
  if (!session.frame_waited)
    return violation("a frame begun without a wait", XR_ERROR_CALL_ORDER_INVALID);
  session.frame_waited = false;
  session.frame_begun = true;
  return XR_SUCCESS;
}

/// Rotates a vector.
XrVector3f turned(const XrQuaternionf& q, const XrVector3f& v) {
  const XrVector3f t = {2 * (q.y * v.z - q.z * v.y), 2 * (q.z * v.x - q.x * v.z),
                        2 * (q.x * v.y - q.y * v.x)};
  return {v.x + q.w * t.x + q.y * t.z - q.z * t.y, v.y + q.w * t.y + q.z * t.x - q.x * t.z,
          v.z + q.w * t.z + q.x * t.y - q.y * t.x};
}

XrQuaternionf product(const XrQuaternionf& a, const XrQuaternionf& b) {
  return {
      a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
      a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

XRAPI_ATTR XrResult XRAPI_CALL locate_views(XrSession, const XrViewLocateInfo* info,
                                            XrViewState* state, std::uint32_t capacity,
                                            std::uint32_t* count, XrView* views) {
  TestRuntime& runtime = TestRuntime::instance();
  runtime.stage = reinterpret_cast<const SpaceRecord*>(info->space)->type;
  *count = 2;
  state->viewStateFlags =
      runtime.is_tracked ? XR_VIEW_STATE_POSITION_VALID_BIT | XR_VIEW_STATE_ORIENTATION_VALID_BIT
                         : 0;
  if (capacity == 0) return XR_SUCCESS;
  const XrPosef head = runtime.head_at(info->displayTime);
  for (int eye = 0; eye < 2; ++eye) {
    const float side = eye == 0 ? -1.F : 1.F;
    const XrVector3f offset =
        turned(head.orientation, {side * TestRuntime::kHalfEyeDistance_m, 0, 0});
    const float half_cant = -side * runtime.cant_rad / 2;  // +y turns to the left
    views[eye].pose = head;
    views[eye].pose.orientation =
        product(head.orientation, {0, std::sin(half_cant), 0, std::cos(half_cant)});
    views[eye].pose.position.x += offset.x;
    views[eye].pose.position.y += offset.y;
    views[eye].pose.position.z += offset.z;
    views[eye].fov = TestRuntime::kFov[eye];
  }
  return XR_SUCCESS;
}

/// Checks that the part's image has been released and that the part is inside the image.
XrResult check_part(const XrSwapchainSubImage& part) {
  const auto& chain = *reinterpret_cast<const SwapchainRecord*>(part.swapchain);
  if (chain.released < 0)
    return violation("a layer of a picture that was never released", XR_ERROR_LAYER_INVALID);
  const XrRect2Di& rect = part.imageRect;
  const bool fits = rect.offset.x >= 0 && rect.offset.y >= 0 && rect.extent.width > 0 &&
                    rect.extent.height > 0 &&
                    rect.offset.x + rect.extent.width <= static_cast<int>(chain.info.width) &&
                    rect.offset.y + rect.extent.height <= static_cast<int>(chain.info.height);
  if (!fits)
    return violation("a layer's rectangle leaves its picture", XR_ERROR_SWAPCHAIN_RECT_INVALID);
  return XR_SUCCESS;
}

template <class Pixel>
Image<Pixel> read_part(const XrSwapchainSubImage& part, GLenum format, GLenum type) {
  const auto& chain = *reinterpret_cast<const SwapchainRecord*>(part.swapchain);
  const GLuint texture = chain.textures[static_cast<std::size_t>(chain.released)];
  const auto& rect = part.imageRect;
  Image<Pixel> image(rect.extent.width, rect.extent.height);
  const auto bytes = static_cast<GLsizei>(image.view().pixel_count() * sizeof(Pixel));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureSubImage(texture, 0, rect.offset.x, rect.offset.y, 0, rect.extent.width,
                       rect.extent.height, 1, format, type, bytes, image.data());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  for (int y = 0; y < image.height() / 2; ++y) {
    Pixel* const row = image.view().row(y);
    std::swap_ranges(row, row + image.width(), image.view().row(image.height() - 1 - y));
  }
  return image;
}

const XrCompositionLayerDepthInfoKHR* depth_of(const XrCompositionLayerProjectionView& view) {
  const auto* next = static_cast<const XrBaseInStructure*>(view.next);
  const bool is_depth = next != nullptr && next->type == XR_TYPE_COMPOSITION_LAYER_DEPTH_INFO_KHR;
  return is_depth ? reinterpret_cast<const XrCompositionLayerDepthInfoKHR*>(next) : nullptr;
}

XrResult take_eye(const XrCompositionLayerProjectionView& view, bool has_alpha, GivenEye& given) {
  if (const XrResult checked = check_part(view.subImage); checked != XR_SUCCESS) return checked;
  const XrQuaternionf& q = view.pose.orientation;
  if (std::abs(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w - 1) > 0.01F)
    return violation("an eye's orientation is not of unit length", XR_ERROR_POSE_INVALID);
  given = {};
  given.pose = view.pose;
  given.fov = view.fov;
  given.color = read_part<Rgb8>(view.subImage, GL_RGB, GL_UNSIGNED_BYTE);
  if (has_alpha) given.alpha = read_part<std::uint8_t>(view.subImage, GL_ALPHA, GL_UNSIGNED_BYTE);
  const auto* const depth = depth_of(view);
  if (depth == nullptr) return XR_SUCCESS;
  if (const XrResult checked = check_part(depth->subImage); checked != XR_SUCCESS) return checked;
  given.depth = read_part<float>(depth->subImage, GL_DEPTH_COMPONENT, GL_FLOAT);
  given.near_m = depth->nearZ;
  given.far_m = depth->farZ;
  return XR_SUCCESS;
}

XrResult take_eyes(const XrCompositionLayerBaseHeader* base) {
  const auto* const layer = reinterpret_cast<const XrCompositionLayerProjection*>(base);
  if (layer->type != XR_TYPE_COMPOSITION_LAYER_PROJECTION || layer->viewCount != 2)
    return violation("a first layer that is not one of two eyes", XR_ERROR_LAYER_INVALID);
  TestRuntime& runtime = TestRuntime::instance();
  ++runtime.frames_with_layer;
  for (std::size_t eye = 0; eye < 2; ++eye) {
    const bool has_alpha =
        (layer->layerFlags & XR_COMPOSITION_LAYER_BLEND_TEXTURE_SOURCE_ALPHA_BIT) != 0;
    const XrResult taken = take_eye(layer->views[eye], has_alpha, runtime.given[eye]);
    if (taken != XR_SUCCESS) return taken;
  }
  return XR_SUCCESS;
}

XrResult take_board(const XrCompositionLayerBaseHeader* base) {
  const auto* const layer = reinterpret_cast<const XrCompositionLayerQuad*>(base);
  if (layer->type != XR_TYPE_COMPOSITION_LAYER_QUAD || layer->space == XR_NULL_HANDLE)
    return violation("a second layer that is no board in a space", XR_ERROR_LAYER_INVALID);
  if (const XrResult checked = check_part(layer->subImage); checked != XR_SUCCESS) return checked;
  const auto& space = *reinterpret_cast<const SpaceRecord*>(layer->space);
  TestRuntime::instance().given_board = {read_part<Rgb8>(layer->subImage, GL_RGB, GL_UNSIGNED_BYTE),
                                         layer->pose, layer->size,
                                         space.type == XR_REFERENCE_SPACE_TYPE_VIEW};
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL end_frame(XrSession, const XrFrameEndInfo* info) {
  SessionRecord& session = session_record();
  TestRuntime& runtime = TestRuntime::instance();
  if (!session.frame_begun)
    return violation("a frame ended that was not begun", XR_ERROR_CALL_ORDER_INVALID);
  session.frame_begun = false;
  ++runtime.frames;
  if (info->displayTime != session.display)
    return violation("a frame for another time", XR_ERROR_TIME_INVALID);
  if (std::ranges::find(runtime.blend_modes, info->environmentBlendMode) ==
      runtime.blend_modes.end())
    return violation("a blend mode that is not offered",
                     XR_ERROR_ENVIRONMENT_BLEND_MODE_UNSUPPORTED);
  runtime.blend_mode = info->environmentBlendMode;
  runtime.given_board.reset();
  if (info->layerCount == 0) return XR_SUCCESS;
  const XrResult eyes = take_eyes(info->layers[0]);
  return eyes != XR_SUCCESS || info->layerCount == 1 ? eyes : take_board(info->layers[1]);
}

}  // namespace

PFN_xrVoidFunction frame_function(const std::string& name) {
  static const std::map<std::string, PFN_xrVoidFunction> functions = {
      {"xrWaitFrame", untyped(wait_frame)},
      {"xrBeginFrame", untyped(begin_frame)},
      {"xrEndFrame", untyped(end_frame)},
      {"xrLocateViews", untyped(locate_views)}};
  const auto found = functions.find(name);
  return found != functions.end() ? found->second : nullptr;
}

}  // namespace roomcast::viewer::xr
