// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/clean_surface.h"

#include <bit>
#include <utility>

namespace roomcast::render {
namespace {

constexpr int kLostAtRims_px = 2;

/// Replaces the depth of `surface` by what `program` makes of it.
template <class Program>
void filter(const Program& program, CleanSurface& surface) {
  program.bind(Program::Main::depth_in, surface.depth_m);
  program.bind(Program::Main::depth_out, surface.between);
  program.run(surface.width, surface.height);
  std::swap(surface.between, surface.depth_m);
}

/// Runs `program` for each pixel of colour.
template <class Program>
void run_on_colors(const Program& program, const CleanSurface& surface) {
  program.set(Program::Main::color_shift,
              std::countr_zero(static_cast<unsigned>(surface.color_scale)));
  program.run(surface.color_scale * surface.width, surface.color_scale * surface.height);
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
  auto parts = create_parts(&Parts::fill, &Parts::extend, &Parts::smooth, &Parts::edges,
                            &Parts::quality, &Parts::still, &Parts::color, &Parts::mesher);
  if (!parts) return std::move(parts).error();
  return SurfaceCleaner(*std::move(parts));
}

void SurfaceCleaner::repair(Shows shows, CleanSurface& surface) {
  filter(parts_.fill, surface);
  if (shows == Shows::kBackground) return filter(parts_.fill, surface);
  for (int px = 0; px < kLostAtRims_px; ++px) filter(parts_.extend, surface);
}

void SurfaceCleaner::finish(const SensorSurface& sensor, const Known& known, Shows shows,
                            const Options& options, CleanSurface& surface) {
  filter(parts_.smooth, surface);
  weigh_pixels(sensor.rays(), surface);
  if (shows == Shows::kNewest) still_colors(sensor, known, surface);
  weigh_colors(shows == Shows::kNewest ? surface.still_color : known.color, options.gain, surface);
  parts_.mesher.build(surface.depth_m,
                      {options.covering != nullptr ? &options.covering->depth_m : nullptr},
                      surface.width, surface.height, options.mesh, surface.mesh);
}

void SurfaceCleaner::find_foreground(const CleanSurface& background,
                                     const SurfaceMeshOptions& options, const GlTexture& velocities,
                                     CleanSurface& surface) {
  parts_.mesher.build(surface.depth_m, {&background.depth_m, true, &velocities}, surface.width,
                      surface.height, options, surface.foreground);
}

void SurfaceCleaner::weigh_pixels(const GlTexture& rays, CleanSurface& surface) {
  using shaders::edge_distance_comp;
  using shaders::quality_comp;
  parts_.edges.bind(edge_distance_comp::depth_in, surface.depth_m);
  parts_.edges.bind(edge_distance_comp::in_row, surface.edge_in_row);
  parts_.edges.run(surface.width, surface.height);

  parts_.quality.bind(quality_comp::depth_in, surface.depth_m);
  parts_.quality.bind(quality_comp::rays, rays);
  parts_.quality.bind(quality_comp::edge_in_row, surface.edge_in_row);
  parts_.quality.bind(quality_comp::quality, surface.quality);
  parts_.quality.run(surface.width, surface.height);
}

void SurfaceCleaner::still_colors(const SensorSurface& sensor, const Known& known,
                                  CleanSurface& surface) {
  using shaders::still_color_comp;
  parts_.still.bind(still_color_comp::depth_in, surface.depth_m);
  parts_.still.bind(still_color_comp::color, sensor.color());
  parts_.still.bind(still_color_comp::seen, known.seen);
  parts_.still.bind(still_color_comp::background_color, known.color);
  parts_.still.bind(still_color_comp::background, known.readings);
  parts_.still.bind(still_color_comp::still_color, surface.still_color);
  run_on_colors(parts_.still, surface);
}

void SurfaceCleaner::weigh_colors(const GlTexture& color, const Eigen::Vector3f& gain,
                                  CleanSurface& surface) {
  using shaders::weighted_color_comp;
  parts_.color.bind(weighted_color_comp::depth_in, surface.depth_m);
  parts_.color.bind(weighted_color_comp::color, color);
  parts_.color.bind(weighted_color_comp::quality, surface.quality);
  parts_.color.set(weighted_color_comp::gain, gain);
  parts_.color.bind(weighted_color_comp::weighted_color, surface.weighted_color);
  run_on_colors(parts_.color, surface);
}

}  // namespace roomcast::render
