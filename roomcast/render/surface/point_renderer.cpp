// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/surface/point_renderer.h"

#include <algorithm>
#include <array>

#include "roomcast/render/gl/shader_sources.h"

namespace roomcast::render {
namespace {

// As in shaders/points.*.
enum UniformLocation : GLint { kSizeAtEqualDistance = 5, kEyeWidth = 7 };
// Larger than the distance between points. Squares that only touched would leave gaps, because they
// are not turned with the surface and depth is noisy.
constexpr double kOverlap = 1.2;

Result<GlProgram> make_points(std::string_view two_eyes) {
  return make_program(
      {{GL_VERTEX_SHADER,
        {shaders::eyes_glsl, shaders::surface_view_glsl, shaders::sensor_surface_glsl,
         shaders::newest_in_view_glsl, shaders::points_vert}},
       {GL_FRAGMENT_SHADER, {two_eyes, shaders::points_frag}}});
}

}  // namespace

Result<PointRenderer> PointRenderer::create() {
  Result<GlProgram> for_one_eye = make_points("const bool kTwoEyes = false;\n");
  if (!for_one_eye) return std::move(for_one_eye).error();
  Result<GlProgram> for_two = make_points("const bool kTwoEyes = true;\n");
  if (!for_two) return std::move(for_two).error();
  return PointRenderer(*std::move(for_one_eye), *std::move(for_two));
}

PointRenderer::PointRenderer(GlProgram for_one_eye, GlProgram for_two)
    : programs_{std::move(for_one_eye), std::move(for_two)},
      no_attributes_(GlVertexArray::create()) {}

void PointRenderer::draw(const SensorSurface& surface, const SurfaceView& view,
                         PointSize size) const {
  const GlProgram& program = programs_[static_cast<std::size_t>(view.eyes.count() - 1)];
  const double sensor_focal_px = std::min(surface.intrinsics().fx, surface.intrinsics().fy);
  set_surface_view(program, view);
  std::array<GLfloat, kMaxEyes> size_px{};
  for (std::size_t eye = 0; eye < size_px.size() && size == PointSize::kAsSurface; ++eye) {
    size_px[eye] = static_cast<float>(kOverlap * focal_length_px(view.eyes[eye]) / sensor_focal_px);
  }
  glProgramUniform1fv(program.name(), kSizeAtEqualDistance, kMaxEyes, size_px.data());
  glProgramUniform1f(program.name(), kEyeWidth, static_cast<float>(view.eyes.width()));
  surface.bind();
  glUseProgram(program.name());
  glBindVertexArray(no_attributes_.name());
  glEnable(GL_PROGRAM_POINT_SIZE);
  glDrawArraysInstanced(GL_POINTS, 0, surface.pixel_count(), view.eyes.count());
}

}  // namespace roomcast::render
