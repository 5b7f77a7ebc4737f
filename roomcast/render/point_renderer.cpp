// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/point_renderer.h"

#include <algorithm>
#include <array>

#include "roomcast/render/shader_sources.h"

namespace roomcast {
namespace {

// As in shaders/points.*.
enum UniformLocation : GLint { kSizeAtEqualDistance = 5, kEyeWidth = 7 };
// Squares that only just touch would leave gaps: they are not turned the way the surface is, and
// depth is noisy.
constexpr double kOverlap = 1.2;

}  // namespace

Result<PointRenderer> PointRenderer::create() {
  Result<GlProgram> program =
      make_program({{GL_VERTEX_SHADER,
                     {shaders::eyes_glsl, shaders::surface_view_glsl, shaders::sensor_surface_glsl,
                      shaders::newest_in_view_glsl, shaders::points_vert}},
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
  std::array<GLfloat, kMostEyes> size_px{};
  for (std::size_t eye = 0; eye < size_px.size() && size == PointSize::kAsSurface; ++eye) {
    size_px[eye] = static_cast<float>(kOverlap * focal_length_px(view.eyes[eye]) / sensor_focal_px);
  }
  glProgramUniform1fv(program_.name(), kSizeAtEqualDistance, kMostEyes, size_px.data());
  glProgramUniform1f(program_.name(), kEyeWidth, static_cast<float>(view.eyes.width()));
  surface.bind();
  glUseProgram(program_.name());
  glBindVertexArray(no_attributes_.name());
  glEnable(GL_PROGRAM_POINT_SIZE);
  glDrawArraysInstanced(GL_POINTS, 0, surface.pixel_count(), view.eyes.count());
}

}  // namespace roomcast
