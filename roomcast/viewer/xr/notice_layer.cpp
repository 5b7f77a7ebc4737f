// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/xr/notice_layer.h"

#include <algorithm>
#include <utility>

#include "roomcast/viewer/xr/xr_status.h"
#include "roomcast/viewer/xr/xr_struct.h"

namespace roomcast::viewer::xr {
namespace {

// At this distance a letter is 1.3 degrees high, and the board 36 degrees wide.
constexpr float kDistance_m = 1.25F, kWidth_m = 0.8F, kTopBelowEyes_m = 0.2F;
constexpr int kWidth_px = 1024, kTallest_px = 400;
constexpr float kLetterHeight_px = 36;

Rgb8 ink_of(Toast::Kind kind) {
  switch (kind) {
    case Toast::Kind::kError:
      return {255, 130, 118};
    case Toast::Kind::kNotice:
      return {250, 210, 110};
    case Toast::Kind::kGood:
      return {130, 225, 155};
  }
  return {255, 255, 255};
}

ColorImage picture_of(const std::vector<Toast>& sentences, const TextPicture& text) {
  std::vector<ColoredSentence> colored;
  for (const Toast& toast : sentences) colored.push_back({toast.sentence, ink_of(toast.kind)});
  return text.draw(colored, kWidth_px, kTallest_px);
}

/// OpenGL's rows begin at the bottom.
void upload(const ColorImage& picture, GLuint texture) {
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (int y = 0; y < picture.height(); ++y) {
    glTextureSubImage2D(texture, 0, 0, picture.height() - 1 - y, picture.width(), 1, GL_RGB,
                        GL_UNSIGNED_BYTE, picture.view().row(y));
  }
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

}  // namespace

Result<std::unique_ptr<NoticeLayer>> NoticeLayer::create(XrSession session,
                                                         std::int64_t color_format) {
  auto images =
      Swapchain::create(session, color_format, {kWidth_px, kTallest_px},
                        XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT | XR_SWAPCHAIN_USAGE_SAMPLED_BIT);
  if (!images) return images.error();
  std::unique_ptr<NoticeLayer> made(new NoticeLayer(std::move(*images)));
  if (auto status = made->create_space(session); !status) return status.error();
  return made;
}

NoticeLayer::NoticeLayer(Swapchain images) : images_(std::move(images)), text_(kLetterHeight_px) {}

Status NoticeLayer::create_space(XrSession session) {
  auto info = xr_struct<XrReferenceSpaceCreateInfo>(XR_TYPE_REFERENCE_SPACE_CREATE_INFO);
  info.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_VIEW;
  info.poseInReferenceSpace.orientation.w = 1;
  return xr_status(xrCreateReferenceSpace(session, &info, &head_), "asking for the head");
}

NoticeLayer::~NoticeLayer() {
  if (head_ != XR_NULL_HANDLE) xrDestroySpace(head_);
}

/// While the headset keeps all images to itself, the earlier sentences stay.
Status NoticeLayer::show(const std::vector<Toast>& sentences) {
  if (sentences == shown_) return {};
  if (!sentences.empty()) {
    const auto texture = images_.acquire();
    if (!texture) return texture.error();
    if (!*texture) return {};
    const ColorImage picture = picture_of(sentences, text_);
    upload(picture, **texture);
    height_px_ = picture.height();
    if (auto status = images_.release(); !status) return status;
  }
  shown_ = sentences;
  return {};
}

XrCompositionLayerQuad NoticeLayer::layer() const {
  auto layer = xr_struct<XrCompositionLayerQuad>(XR_TYPE_COMPOSITION_LAYER_QUAD);
  layer.space = head_;
  layer.eyeVisibility = XR_EYE_VISIBILITY_BOTH;
  layer.subImage.swapchain = images_.handle();
  layer.subImage.imageRect = {{0, 0}, {kWidth_px, height_px_}};
  layer.size = {kWidth_m, kWidth_m * static_cast<float>(height_px_) / kWidth_px};
  layer.pose.orientation.w = 1;
  layer.pose.position = {0, -kTopBelowEyes_m - layer.size.height / 2, -kDistance_m};
  return layer;
}

}  // namespace roomcast::viewer::xr
