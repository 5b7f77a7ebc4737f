// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/point_renderer.h"

#include <algorithm>

#include "roomcast/render/shader_sources.h"

namespace roomcast {
namespace {

constexpr GLint kSizeAtEqualDistance = 2;  // shaders/points.vert
// Squares that only just touch would leave gaps: they are not turned the way the surface is, and
// depth is noisy.
constexpr double kOverlap = 1.2;

}  // namespace

Result<PointRenderer> PointRenderer::create() {
  Result<GlProgram> program =
      make_program({{GL_VERTEX_SHADER, {shaders::sensor_surface_glsl, shaders::points_vert}},
                    {GL_FRAGMENT_SHADER, {shaders::points_frag}}});
  if (!program) return std::move(program).error();
  return PointRenderer(std::move(program).value());
}

PointRenderer::PointRenderer(GlProgram program)
    : program_(std::move(program)), no_attributes_(GlVertexArray::create()) {}

void PointRenderer::draw(const SensorSurface& surface, const SurfaceView& view,
                         PointSize size) const {
  const double sensor_focal_px = std::min(surface.intrinsics().fx, surface.intrinsics().fy);
  set_surface_view(program_, view);
  const double size_px =
      size == PointSize::kAsSurface ? kOverlap * view.focal_px / sensor_focal_px : 0;
  glProgramUniform1f(program_.name(), kSizeAtEqualDistance, static_cast<float>(size_px));
  surface.bind();
  glUseProgram(program_.name());
  glBindVertexArray(no_attributes_.name());
  glEnable(GL_PROGRAM_POINT_SIZE);
  glDrawArrays(GL_POINTS, 0, surface.pixel_count());
}

}  // namespace roomcast
