// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/view/offscreen_target.h"

#include <algorithm>
#include <array>

#include "roomcast/core/assert.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/render/view/eyes.h"

namespace roomcast::render {
namespace {

// Flips the rows: OpenGL's images begin at the bottom.
template <class T>
void turn_upside_down(ImageView<T> image) {
  for (int y = 0; y < image.height / 2; ++y) {
    std::swap_ranges(image.row(y), image.row(y) + image.width, image.row(image.height - 1 - y));
  }
}

}  // namespace

template <class T>
Image<T> OffscreenTarget::read_back(const GlTexture& texture, int eye, GLenum format,
                                    GLenum type) const {
  ROOMCAST_ASSERT(eye >= 0 && eye < eyes_);
  Image<T> image(width_, height_);
  const std::size_t bytes = image.view().pixel_count() * sizeof(T);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureSubImage(texture.name(), 0, eye * width_, 0, 0, width_, height_, 1, format, type,
                       static_cast<GLsizei>(bytes), image.data());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  turn_upside_down(image.view());
  return image;
}

Result<OffscreenTarget> OffscreenTarget::create(int width, int height, int eyes) {
  ROOMCAST_ASSERT(eyes >= 1 && eyes <= kMaxEyes);
  if (!is_legal_side(width) || !is_legal_side(height)) {
    return Error{ErrorCode::kInvalidArgument,
                 "a picture's width and height must be 1 to 8192 pixels"};
  }
  OffscreenTarget target(width, height, eyes);
  const GLenum state =
      glCheckNamedFramebufferStatus(target.framebuffer_.name(), GL_DRAW_FRAMEBUFFER);
  if (state == GL_FRAMEBUFFER_COMPLETE) return target;
  return Error{ErrorCode::kUnavailable, "the driver cannot draw into an offscreen picture of " +
                                            std::to_string(width) + "x" + std::to_string(height)};
}

OffscreenTarget::OffscreenTarget(int width, int height, int eyes)
    : width_(width),
      height_(height),
      eyes_(eyes),
      color_(make_texture(GL_RGBA8, eyes * width, height)),
      depth_(make_texture(GL_DEPTH_COMPONENT32F, eyes * width, height)),
      sensors_(make_texture(GL_R32I, eyes * width, height)),
      framebuffer_(GlFramebuffer::create()) {
  const GLuint name = framebuffer_.name();
  glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT0, color_.name(), 0);
  glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT1, sensors_.name(), 0);
  glNamedFramebufferTexture(name, GL_DEPTH_ATTACHMENT, depth_.name(), 0);
  constexpr std::array<GLenum, 2> kOutputs = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  glNamedFramebufferDrawBuffers(name, kOutputs.size(), kOutputs.data());
}

void OffscreenTarget::bind() const {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.name());
  glViewport(0, 0, eyes_ * width_, height_);
}

void OffscreenTarget::clear(Rgb8 background, float alpha) const {
  bind();
  const auto share = [](std::uint8_t value) { return static_cast<float>(value) / 255.0F; };
  const std::array<float, 4> color = {share(background.r), share(background.g), share(background.b),
                                      alpha};
  const std::array<GLint, 4> nobody = {kDrawnByNoSensor, 0, 0, 0};
  constexpr float kFarthest = 1.0F;
  glClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, kColorAttachment, color.data());
  glClearNamedFramebufferiv(framebuffer_.name(), GL_COLOR, kSensorsAttachment, nobody.data());
  glClearNamedFramebufferfv(framebuffer_.name(), GL_DEPTH, 0, &kFarthest);
}

ColorImage OffscreenTarget::read_color(int eye) const {
  return read_back<Rgb8>(color_, eye, GL_RGB, GL_UNSIGNED_BYTE);
}

Image<float> OffscreenTarget::read_depth_m(const ViewCamera& camera, int eye) const {
  Image<float> depth = read_back<float>(depth_, eye, GL_DEPTH_COMPONENT, GL_FLOAT);
  const double near_m = camera.near_m, far_m = camera.far_m;
  float* const values = depth.data();
  for (std::size_t i = 0; i < depth.view().pixel_count(); ++i) {
    const double ndc = 2 * static_cast<double>(values[i]) - 1;
    const double z_m = 2 * far_m * near_m / (far_m + near_m - ndc * (far_m - near_m));
    values[i] = values[i] < 1 ? static_cast<float>(z_m) : 0;
  }
  return depth;
}

Image<std::int32_t> OffscreenTarget::read_sensors(int eye) const {
  return read_back<std::int32_t>(sensors_, eye, GL_RED_INTEGER, GL_INT);
}

}  // namespace roomcast::render
