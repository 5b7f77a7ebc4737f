// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/surface/sensor_surface.h"

#include <cmath>
#include <string>

namespace roomcast::render {
namespace {

constexpr float kNoRay = 1e6F;  // as in shaders/sensor_surface.glsl

void clear(const GlTexture& texture, GLenum format, GLenum type) {
  glClearTexImage(texture.name(), 0, format, type, nullptr);
}

template <class T>
void replace(const GlTexture& texture, ImageView<const T> image, GLenum format, GLenum type) {
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, static_cast<GLint>(image.stride));
  glTextureSubImage2D(texture.name(), 0, 0, 0, image.width, image.height, format, type, image.data);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

// GLSL does not guarantee NaN, so a large number marks "no ray".
Image<Eigen::Vector2f> rays_without_nan(const CameraIntrinsics& depth) {
  Image<Eigen::Vector2f> rays = ray_table(depth);
  Eigen::Vector2f* ray = rays.data();
  for (std::size_t i = 0; i < rays.view().pixel_count(); ++i) {
    if (!ray[i].allFinite()) ray[i] = Eigen::Vector2f::Constant(kNoRay);
  }
  return rays;
}

template <class Picture>
Error wrong_size(const char* name, const Picture& picture, const CameraIntrinsics& wanted) {
  const auto size = [](const auto& of) {
    return std::to_string(of.width) + "x" + std::to_string(of.height);
  };
  return Error{ErrorCode::kInvalidArgument, std::string("the ") + name + " picture is " +
                                                size(picture) + " but the sensor's is " +
                                                size(wanted)};
}

}  // namespace

Result<SensorSurface> SensorSurface::create(const CameraIntrinsics& depth) {
  if (Status legal = depth.check(); !legal) return std::move(legal).error();
  if (static_cast<std::int64_t>(depth.width) * depth.height > kMaxSurfacePixels) {
    return Error{ErrorCode::kTooLarge, "the sensor's depth picture has more than 4 million pixels"};
  }
  return SensorSurface(depth);
}

SensorSurface::SensorSurface(const CameraIntrinsics& depth)
    : intrinsics_(depth),
      widest_radius_squared_(roomcast::widest_radius_squared(depth)),
      depth_mm_(make_texture(GL_R16UI, depth.width, depth.height)),
      rays_(make_texture(GL_RG32F, depth.width, depth.height)),
      color_(make_texture(GL_RGB8, depth.width, depth.height)),
      seen_(make_texture(GL_R8UI, depth.width, depth.height)) {
  clear(depth_mm_, GL_RED_INTEGER, GL_UNSIGNED_SHORT);
  clear(color_, GL_RGB, GL_UNSIGNED_BYTE);
  clear(seen_, GL_RED_INTEGER, GL_UNSIGNED_BYTE);
  const Image<Eigen::Vector2f> rays = rays_without_nan(depth);
  replace<Eigen::Vector2f>(rays_, rays, GL_RG, GL_FLOAT);
}

Status SensorSurface::upload(DepthView depth_mm, ColorView color, MaskView seen) {
  const bool without_color = color.pixel_count() == 0 && seen.pixel_count() == 0;
  if (!same_size(depth_mm, intrinsics_)) return wrong_size("depth", depth_mm, intrinsics_);
  const int scale = color.width == 2 * intrinsics_.width ? 2 : 1;
  if (!without_color &&
      (color.width != scale * intrinsics_.width || color.height != scale * intrinsics_.height)) {
    return wrong_size("colour", color, intrinsics_);
  }
  if (!without_color && !same_size(seen, intrinsics_)) {
    return wrong_size("mask", seen, intrinsics_);
  }
  replace(depth_mm_, depth_mm, GL_RED_INTEGER, GL_UNSIGNED_SHORT);
  if (without_color) {
    clear(seen_, GL_RED_INTEGER, GL_UNSIGNED_BYTE);
  } else {
    set_color_scale(scale);
    replace(color_, color, GL_RGB, GL_UNSIGNED_BYTE);
    replace(seen_, seen, GL_RED_INTEGER, GL_UNSIGNED_BYTE);
  }
  ++revision_;
  return {};
}

void SensorSurface::set_color_scale(int scale) {
  if (scale == color_scale_) return;
  color_scale_ = scale;
  color_ = make_texture(GL_RGB8, scale * intrinsics_.width, scale * intrinsics_.height);
}

void SensorSurface::bind_to(ProgramWith<shaders::sensor_surface_glsl> program) const {
  program.bind(shaders::sensor_surface_glsl::depth_mm, depth_mm_);
  program.bind(shaders::sensor_surface_glsl::rays, rays_);
  program.bind(shaders::sensor_surface_glsl::color, color_);
  program.bind(shaders::sensor_surface_glsl::seen, seen_);
}

}  // namespace roomcast::render
