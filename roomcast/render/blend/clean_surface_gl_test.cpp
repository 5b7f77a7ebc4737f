// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/clean_surface.h"
#include "roomcast/render/gl/gl_fixture.h"
#include "roomcast/render/surface/sensor_pictures_fixture.h"

namespace roomcast::render {
namespace {

const CameraIntrinsics kCleanSurfaceLens = pinhole(40, 30, 40);

class CleanSurfaceTest : public GlTest {
 protected:
  struct Cleaned {
    Image<float> depth_m, quality;
  };

  /// Cleans a surface of this depth whose colours were all seen.
  Cleaned clean(const Image<float>& depth_m) {
    Result<SensorSurface> sensor = SensorSurface::create(kCleanSurfaceLens);
    Result<SurfaceCleaner> cleaner = SurfaceCleaner::create();
    EXPECT_TRUE(cleaner.ok()) << cleaner.error().message;
    const SensorPictures pictures = wall(kCleanSurfaceLens, 2000, kRed);
    EXPECT_TRUE(sensor->upload(pictures.depth_mm, pictures.color, pictures.seen).ok());
    CleanSurface surface(kCleanSurfaceLens);
    glTextureSubImage2D(surface.depth_m.name(), 0, 0, 0, kCleanSurfaceLens.width,
                        kCleanSurfaceLens.height, GL_RED, GL_FLOAT, depth_m.data());
    const GlTexture nothing =
        make_texture(GL_RGBA32F, kCleanSurfaceLens.width, kCleanSurfaceLens.height);
    glClearTexImage(nothing.name(), 0, GL_RGBA, GL_FLOAT, nullptr);
    cleaner->repair(SurfaceCleaner::Shows::kNewest, surface);
    cleaner->finish(*sensor, {nothing, nothing, sensor->seen()}, SurfaceCleaner::Shows::kNewest, {},
                    surface);
    return {read(surface.depth_m), read(surface.quality)};
  }

  static Image<float> read(const GlTexture& texture) {
    Image<float> image(kCleanSurfaceLens.width, kCleanSurfaceLens.height);
    glGetTextureImage(texture.name(), 0, GL_RED, GL_FLOAT,
                      static_cast<GLsizei>(image.view().pixel_count() * sizeof(float)),
                      image.data());
    return image;
  }
};

TEST_F(CleanSurfaceTest, a_missing_reading_is_filled_and_a_large_gap_is_not) {
  Image<float> depth(kCleanSurfaceLens.width, kCleanSurfaceLens.height, 2.0F);
  depth.at(10, 10) = 0;
  fill_box(depth, 20, 10, 30, 20, 0.0F);
  const Cleaned cleaned = clean(depth);
  EXPECT_NEAR(cleaned.depth_m.at(10, 10), 2, 1e-3);
  EXPECT_EQ(cleaned.depth_m.at(25, 15), 0);
}

TEST_F(CleanSurfaceTest, nothing_is_filled_between_foreground_and_background) {
  Image<float> depth(kCleanSurfaceLens.width, kCleanSurfaceLens.height, 3.0F);
  fill_box(depth, 0, 0, 20, 30, 1.5F);
  fill_box(depth, 20, 0, 21, 30, 0.0F);
  EXPECT_EQ(clean(depth).depth_m.at(20, 15), 0);
}

TEST_F(CleanSurfaceTest, what_a_sensor_loses_at_the_rim_of_a_thing_is_put_back) {
  Image<float> depth(kCleanSurfaceLens.width, kCleanSurfaceLens.height, 0.0F);
  fill_box(depth, 10, 0, 20, 30, 1.5F);
  const Cleaned cleaned = clean(depth);
  EXPECT_NEAR(cleaned.depth_m.at(21, 15), 1.5, 1e-3);
  EXPECT_EQ(cleaned.depth_m.at(22, 15), 0);
}

TEST_F(CleanSurfaceTest, noise_is_smoothed_and_a_step_stays_sharp) {
  Image<float> depth(kCleanSurfaceLens.width, kCleanSurfaceLens.height);
  for (int y = 0; y < kCleanSurfaceLens.height; ++y) {
    for (int x = 0; x < kCleanSurfaceLens.width; ++x) {
      depth.at(x, y) = (x < 20 ? 1.5F : 3.0F) + ((x + y) % 2 ? 0.003F : -0.003F);
    }
  }
  const Cleaned cleaned = clean(depth);
  for (const int x : {5, 19, 20, 35}) {
    EXPECT_NEAR(cleaned.depth_m.at(x, 15), x < 20 ? 1.5 : 3.0, 0.001) << x;
  }
}

TEST_F(CleanSurfaceTest, quality_falls_with_distance_slant_and_towards_edges) {
  const auto quality_at = [&](const Image<float>& depth, int x) {
    return clean(depth).quality.at(x, 15);
  };
  const Image<float> near(kCleanSurfaceLens.width, kCleanSurfaceLens.height, 1.0F),
      far(kCleanSurfaceLens.width, kCleanSurfaceLens.height, 2.0F);
  EXPECT_NEAR(quality_at(near, 20) / quality_at(far, 20), 4, 0.05);
  EXPECT_LT(quality_at(far, 2), 0.7F * quality_at(far, 20)) << "beside the picture's border";
  Image<float> slanted(kCleanSurfaceLens.width, kCleanSurfaceLens.height);
  for (int i = 0; i < kCleanSurfaceLens.width * kCleanSurfaceLens.height; ++i) {
    slanted.data()[i] = 1 / (0.5F + 0.012F * static_cast<float>(i % kCleanSurfaceLens.width - 20));
  }
  EXPECT_LT(quality_at(slanted, 20), 0.8F * quality_at(far, 20));
}

}  // namespace
}  // namespace roomcast::render
