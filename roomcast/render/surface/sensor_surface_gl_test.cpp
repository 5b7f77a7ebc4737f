// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include "roomcast/render/gl/gl_fixture.h"
#include "roomcast/render/surface/sensor_pictures_fixture.h"
#include "roomcast/render/surface/sensor_surface.h"

namespace roomcast::render {
namespace {

using SensorSurfaceTest = GlTest;

constexpr int kWidth = 5, kHeight = 3;  // a row of colour is not a multiple of four bytes

struct ReadsNothing {
  static constexpr std::string_view text = "layout(local_size_x = 1) in; void main() {}";
  static constexpr std::array<int, 2> local_size = {1, 1};
};

void bind_for_shaders(const SensorSurface& surface) {
  const auto reader = ComputeProgram<shaders::sensor_surface_glsl, ReadsNothing>::create();
  ASSERT_TRUE(reader.ok()) << reader.error().message;
  surface.bind_to(*reader);
}

/// The texture that shaders read by this sampler.
template <class T, class Sampler>
Image<T> bound_texture(Sampler sampler, GLenum format, GLenum type) {
  GLint name = 0;
  glActiveTexture(GL_TEXTURE0 + sampler.unit);
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &name);
  Image<T> image(kWidth, kHeight);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureImage(static_cast<GLuint>(name), 0, format, type, kWidth * kHeight * sizeof(T),
                    image.data());
  return image;
}

SensorPictures numbered_pictures() {
  SensorPictures pictures{DepthImage(kWidth, kHeight), ColorImage(kWidth, kHeight),
                          MaskImage(kWidth, kHeight)};
  for (int i = 0; i < kWidth * kHeight; ++i) {
    const auto n = static_cast<std::uint8_t>(i);
    pictures.depth_mm.data()[i] = static_cast<std::uint16_t>(4000 + 4111 * i);
    pictures.color.data()[i] = {n, static_cast<std::uint8_t>(100 + n),
                                static_cast<std::uint8_t>(255 - n)};
    pictures.seen.data()[i] = i % 2 ? 255 : 0;
  }
  return pictures;
}

void expect_bound(const SensorSurface& surface, const SensorPictures& pictures) {
  using shaders::sensor_surface_glsl;
  bind_for_shaders(surface);
  EXPECT_EQ(bound_texture<std::uint16_t>(sensor_surface_glsl::depth_mm, GL_RED_INTEGER,
                                         GL_UNSIGNED_SHORT),
            pictures.depth_mm);
  EXPECT_EQ(bound_texture<Rgb8>(sensor_surface_glsl::color, GL_RGB, GL_UNSIGNED_BYTE),
            pictures.color);
  EXPECT_EQ(
      bound_texture<std::uint8_t>(sensor_surface_glsl::seen, GL_RED_INTEGER, GL_UNSIGNED_BYTE),
      pictures.seen);
}

TEST_F(SensorSurfaceTest, begins_without_depth) {
  const Result<SensorSurface> surface = SensorSurface::create(pinhole(kWidth, kHeight, 4));
  ASSERT_TRUE(surface.ok());
  expect_bound(*surface, {DepthImage(kWidth, kHeight), ColorImage(kWidth, kHeight),
                          MaskImage(kWidth, kHeight)});
  EXPECT_EQ(surface->revision(), 0U);
}

TEST_F(SensorSurfaceTest, the_gpu_gets_every_bit_of_the_pictures) {
  Result<SensorSurface> surface = SensorSurface::create(pinhole(kWidth, kHeight, 4));
  ASSERT_TRUE(surface.ok());
  const SensorPictures pictures = numbered_pictures();
  ASSERT_TRUE(surface->upload(pictures.depth_mm, pictures.color, pictures.seen).ok());
  EXPECT_EQ(surface->revision(), 1U);
  expect_bound(*surface, pictures);
}

TEST_F(SensorSurfaceTest, a_frame_without_color_leaves_nothing_seen) {
  Result<SensorSurface> surface = SensorSurface::create(pinhole(kWidth, kHeight, 4));
  ASSERT_TRUE(surface.ok());
  SensorPictures pictures = numbered_pictures();
  ASSERT_TRUE(surface->upload(pictures.depth_mm, pictures.color, pictures.seen).ok());
  pictures.depth_mm.at(1, 1) = 1;
  ASSERT_TRUE(surface->upload(pictures.depth_mm, ColorImage(), MaskImage()).ok());
  EXPECT_FALSE(surface->upload(pictures.depth_mm, pictures.color, MaskImage()).ok());
  EXPECT_FALSE(surface->upload(pictures.depth_mm, ColorImage(), pictures.seen).ok());
  pictures.seen = MaskImage(kWidth, kHeight, 0);
  expect_bound(*surface, pictures);
}

TEST_F(SensorSurfaceTest, color_may_be_twice_as_fine_as_depth_and_nothing_between) {
  Result<SensorSurface> surface = SensorSurface::create(pinhole(kWidth, kHeight, 4));
  ASSERT_TRUE(surface.ok());
  const SensorPictures pictures = numbered_pictures();
  const ColorImage fine(2 * kWidth, 2 * kHeight);
  EXPECT_TRUE(surface->upload(pictures.depth_mm, fine, pictures.seen).ok());
  EXPECT_EQ(surface->color_scale(), 2);
  const ColorImage half(2 * kWidth, kHeight), huge(3 * kWidth, 3 * kHeight);
  EXPECT_FALSE(surface->upload(pictures.depth_mm, half, pictures.seen).ok());
  EXPECT_FALSE(surface->upload(pictures.depth_mm, huge, pictures.seen).ok());
  ASSERT_TRUE(surface->upload(pictures.depth_mm, pictures.color, pictures.seen).ok());
  expect_bound(*surface, pictures);
}

TEST_F(SensorSurfaceTest, the_gpu_gets_the_ray_table) {
  CameraIntrinsics lens = pinhole(kWidth, kHeight, 4);
  lens.k1 = 0.1;
  const Result<SensorSurface> surface = SensorSurface::create(lens);
  ASSERT_TRUE(surface.ok());
  bind_for_shaders(*surface);
  const auto on_gpu =
      bound_texture<std::array<float, 2>>(shaders::sensor_surface_glsl::rays, GL_RG, GL_FLOAT);
  const Image<Eigen::Vector2f> expected = ray_table(lens);
  for (int i = 0; i < kWidth * kHeight; ++i) {
    EXPECT_EQ(on_gpu.data()[i][0], expected.data()[i].x());
    EXPECT_EQ(on_gpu.data()[i][1], expected.data()[i].y());
  }
}

TEST_F(SensorSurfaceTest, a_refused_picture_leaves_the_last_one) {
  Result<SensorSurface> surface = SensorSurface::create(pinhole(kWidth, kHeight, 4));
  ASSERT_TRUE(surface.ok());
  const SensorPictures pictures = numbered_pictures();
  ASSERT_TRUE(surface->upload(pictures.depth_mm, pictures.color, pictures.seen).ok());
  const MaskImage narrow(kWidth - 1, kHeight);
  const DepthImage other_depth(kWidth, kHeight, 1);
  EXPECT_FALSE(surface->upload(other_depth, pictures.color, narrow).ok());
  EXPECT_EQ(surface->revision(), 1U);
  expect_bound(*surface, pictures);
}

TEST_F(SensorSurfaceTest, illegal_and_oversized_lenses_are_refused) {
  EXPECT_EQ(SensorSurface::create(pinhole(0, 3, 4)).error().code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(SensorSurface::create(pinhole(5, 3, NAN)).error().code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(SensorSurface::create(pinhole(8192, 513, 4)).error().code, ErrorCode::kTooLarge);
}

}  // namespace
}  // namespace roomcast::render
