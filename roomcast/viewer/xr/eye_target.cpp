// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/xr/eye_target.h"

#include <algorithm>
#include <utility>

#include "roomcast/viewer/xr/xr_struct.h"

namespace roomcast::viewer::xr {
namespace {

XrSwapchainSubImage part_of(const Swapchain& images, const EyePicture& picture) {
  XrSwapchainSubImage part{};
  part.swapchain = images.handle();
  part.imageRect = {{0, 0}, {picture.part.width, picture.part.height}};
  return part;
}

}  // namespace

Result<EyeTarget> EyeTarget::create(XrSession session, std::int64_t color_format,
                                    std::int64_t depth_format, PictureSize size, int number) {
  auto color =
      Swapchain::create(session, color_format, size,
                        XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT | XR_SWAPCHAIN_USAGE_SAMPLED_BIT);
  if (!color) return color.error();
  EyeTarget eye(std::move(*color), number);
  if (depth_format == 0) return eye;
  auto depth = Swapchain::create(
      session, depth_format, size,
      XR_SWAPCHAIN_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | XR_SWAPCHAIN_USAGE_SAMPLED_BIT);
  if (!depth) return depth.error();
  eye.depth_ = std::move(*depth);
  return eye;
}

Status EyeTarget::look(const XrView& view) {
  auto picture = eye_picture(view.fov, color_.size());
  if (!picture) return picture.error();
  picture_ = *picture;
  pose_ = view.pose;
  shown_ = Error{ErrorCode::kUnavailable, "an eye of the headset was given no picture"};
  return {};
}

void draw_alike(EyeTarget& left, EyeTarget& right) {
  const PictureSize &a = left.picture_.drawn, &b = right.picture_.drawn;
  const PictureSize size = {std::max(a.width, b.width), std::max(a.height, b.height)};
  left.picture_ = with_size(left.picture_, size);
  right.picture_ = with_size(right.picture_, size);
}

render::ViewCamera EyeTarget::camera() const {
  render::ViewCamera camera;
  camera.world_from_view = transform_from_pose(pose_);
  camera.vertical_fov_rad = picture_.vertical_fov_rad;
  camera.width = picture_.drawn.width;
  camera.height = picture_.drawn.height;
  return camera;
}

void EyeTarget::show(const render::OffscreenTarget& picture) {
  shown_ = copy(picture);
}

/// Copies without conversion: both images contain sRGB bytes, whatever the destination's format.
/// Images that were acquired without a picture are used in the next frame.
Result<bool> EyeTarget::copy(const render::OffscreenTarget& picture) {
  const auto color = color_.acquire();
  if (!color) return color.error();
  const auto depth = depth_ && *color ? depth_->acquire() : Result(std::optional<GLuint>());
  if (!depth) return depth.error();
  if (!*color || (depth_ && !*depth)) return false;
  const GLuint framebuffer = framebuffer_.name();
  glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, **color, 0);
  if (depth_) glNamedFramebufferTexture(framebuffer, GL_DEPTH_ATTACHMENT, **depth, 0);
  const GLbitfield parts = GL_COLOR_BUFFER_BIT | (depth_ ? GL_DEPTH_BUFFER_BIT : 0);
  glDisable(GL_FRAMEBUFFER_SRGB);
  glDisable(GL_SCISSOR_TEST);
  const auto [width, height] = picture_.part;
  const int left = number_ * picture.width() + picture_.left, bottom = picture_.bottom;
  glBlitNamedFramebuffer(picture.framebuffer(), framebuffer, left, bottom, left + width,
                         bottom + height, 0, 0, width, height, parts, GL_NEAREST);
  if (auto status = release(); !status) return status.error();
  return true;
}

Status EyeTarget::release() {
  Status depth = depth_ ? depth_->release() : Status();
  Status color = color_.release();
  return depth ? color : depth;
}

XrCompositionLayerProjectionView EyeTarget::layer() {
  auto view =
      xr_struct<XrCompositionLayerProjectionView>(XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW);
  view.pose = pose_;
  view.fov = picture_.fov;
  view.subImage = part_of(color_, picture_);
  if (!depth_) return view;
  const render::ViewCamera eye = camera();
  depth_info_ = xr_struct<XrCompositionLayerDepthInfoKHR>(XR_TYPE_COMPOSITION_LAYER_DEPTH_INFO_KHR);
  depth_info_.subImage = part_of(*depth_, picture_);
  depth_info_.minDepth = 0;
  depth_info_.maxDepth = 1;
  depth_info_.nearZ = static_cast<float>(eye.near_m);
  depth_info_.farZ = static_cast<float>(eye.far_m);
  view.next = &depth_info_;
  return view;
}

}  // namespace roomcast::viewer::xr
