// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/clean_surface.h"

#include <bit>
#include <utility>

#include "roomcast/render/gl/shader_sources.h"

namespace roomcast::render {
namespace {

// As in shaders/blend/.
enum TextureUnit : GLuint {
  kDepth = 0,
  kRays = 1,
  kColor = 2,
  kSeen = 3,
  kEdges = 4,    // in quality.comp
  kQuality = 4,  // in weighted_color.comp
  kBackgroundColor = 5,
  kReadings = 6,
};
constexpr int kLostAtRims_px = 2;
enum ColorUniform : GLint { kColorShift = 0, kGain = 1 };

void bind_texture(GLuint unit, const GlTexture& texture) {
  glBindTextureUnit(unit, texture.name());
}

}  // namespace

CleanSurface::CleanSurface(const CameraIntrinsics& lens)
    : width(lens.width),
      height(lens.height),
      depth_m(make_texture(GL_R32F, lens.width, lens.height)),
      quality(make_smooth_texture(GL_R16F, lens.width, lens.height)),
      between(make_texture(GL_R32F, lens.width, lens.height)),
      edge_in_row(make_texture(GL_R8UI, lens.width, lens.height)) {
  glClearTexImage(depth_m.name(), 0, GL_RED, GL_FLOAT, nullptr);
  set_color_scale(1);
}

void CleanSurface::set_color_scale(int scale) {
  color_scale = scale;
  weighted_color = make_smooth_texture(GL_RGBA16F, scale * width, scale * height);
  still_color = make_texture(GL_RGBA16F, scale * width, scale * height);
}

Result<SurfaceCleaner> SurfaceCleaner::create() {
  auto fill = ComputePass::create({shaders::fill_small_comp});
  if (!fill) return std::move(fill).error();
  auto extend = ComputePass::create({shaders::extend_edges_comp});
  if (!extend) return std::move(extend).error();
  auto smooth = ComputePass::create({shaders::depth_noise_glsl, shaders::smooth_comp});
  if (!smooth) return std::move(smooth).error();
  auto edges = ComputePass::create({shaders::edge_distance_comp});
  if (!edges) return std::move(edges).error();
  auto quality = ComputePass::create({shaders::quality_comp});
  if (!quality) return std::move(quality).error();
  auto still = ComputePass::create({shaders::depth_noise_glsl, shaders::still_color_comp});
  if (!still) return std::move(still).error();
  auto color = ComputePass::create({shaders::weighted_color_comp});
  if (!color) return std::move(color).error();
  auto mesher = AdaptiveMesher::create();
  if (!mesher) return std::move(mesher).error();
  return SurfaceCleaner(
      {*std::move(fill), *std::move(extend), *std::move(smooth), *std::move(edges),
       *std::move(quality), *std::move(still), *std::move(color)},
      *std::move(mesher));
}

SurfaceCleaner::SurfaceCleaner(Passes passes, AdaptiveMesher mesher)
    : passes_(std::move(passes)), mesher_(std::move(mesher)) {}

void SurfaceCleaner::filter(const ComputePass& pass, CleanSurface& surface) {
  bind_texture(kDepth, surface.depth_m);
  bind_image(0, surface.between, ImageAccess::kWrite, GL_R32F);
  pass.run(surface.width, surface.height);
  std::swap(surface.between, surface.depth_m);
}

void SurfaceCleaner::repair(Shows shows, CleanSurface& surface) {
  filter(passes_.fill, surface);
  if (shows == Shows::kBackground) return filter(passes_.fill, surface);
  for (int px = 0; px < kLostAtRims_px; ++px) filter(passes_.extend, surface);
}

void SurfaceCleaner::finish(const SensorSurface& sensor, const Known& known, Shows shows,
                            const Options& options, CleanSurface& surface) {
  filter(passes_.smooth, surface);

  bind_texture(kDepth, surface.depth_m);
  bind_image(0, surface.edge_in_row, ImageAccess::kWrite, GL_R8UI);
  passes_.edges.run(surface.width, surface.height);

  bind_texture(kRays, sensor.rays());
  bind_texture(kEdges, surface.edge_in_row);
  bind_image(0, surface.quality, ImageAccess::kWrite, GL_R16F);
  passes_.quality.run(surface.width, surface.height);
  if (shows == Shows::kNewest) still_colors(sensor, known, surface);
  weigh_colors(shows == Shows::kNewest ? surface.still_color : known.color, options.gain, surface);

  mesher_.build(surface.depth_m, options.covering != nullptr ? &options.covering->depth_m : nullptr,
                surface.width, surface.height, options.mesh, surface.mesh);
}

void SurfaceCleaner::still_colors(const SensorSurface& sensor, const Known& known,
                                  CleanSurface& surface) {
  bind_texture(kColor, sensor.color());
  bind_texture(kSeen, known.seen);
  bind_texture(kBackgroundColor, known.color);
  bind_texture(kReadings, known.readings);
  bind_image(0, surface.still_color, ImageAccess::kWrite, GL_RGBA16F);
  run_on_colors(passes_.still, surface);
}

void SurfaceCleaner::weigh_colors(const GlTexture& color, const Eigen::Vector3f& gain,
                                  CleanSurface& surface) {
  bind_texture(kColor, color);
  bind_texture(kQuality, surface.quality);
  glProgramUniform3fv(passes_.color.program().name(), kGain, 1, gain.data());
  bind_image(0, surface.weighted_color, ImageAccess::kWrite, GL_RGBA16F);
  run_on_colors(passes_.color, surface);
}

void SurfaceCleaner::run_on_colors(const ComputePass& pass, const CleanSurface& surface) {
  glProgramUniform1i(pass.program().name(), kColorShift,
                     std::countr_zero(static_cast<unsigned>(surface.color_scale)));
  pass.run(surface.color_scale * surface.width, surface.color_scale * surface.height);
}

}  // namespace roomcast::render
