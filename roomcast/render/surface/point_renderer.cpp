// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/surface/point_renderer.h"

#include <algorithm>
#include <array>
#include <utility>

namespace roomcast::render {
namespace {

// Larger than the distance between points. Squares that only touched would leave gaps, because they
// are not turned with the surface and depth is noisy.
constexpr double kOverlap = 1.2;

}  // namespace

Result<PointRenderer> PointRenderer::create() {
  Result<Programs> programs = create_parts(&Programs::for_one_eye, &Programs::for_two_eyes);
  if (!programs) return std::move(programs).error();
  return PointRenderer(*std::move(programs));
}

PointRenderer::PointRenderer(Programs programs)
    : programs_(std::move(programs)), no_attributes_(GlVertexArray::create()) {}

PointRenderer::AnyProgram PointRenderer::program_for(const Eyes& eyes) const {
  if (eyes.count() == 1) return programs_.for_one_eye;
  return programs_.for_two_eyes;
}

void PointRenderer::draw(const SensorSurface& surface, const SurfaceView& view,
                         PointSize size) const {
  const AnyProgram program = program_for(view.eyes);
  const double sensor_focal_px = std::min(surface.intrinsics().fx, surface.intrinsics().fy);
  set_surface_view(program, view);
  std::array<GLfloat, kMaxEyes> size_px{};
  for (std::size_t eye = 0; eye < size_px.size() && size == PointSize::kAsSurface; ++eye) {
    size_px[eye] = static_cast<float>(kOverlap * focal_length_px(view.eyes[eye]) / sensor_focal_px);
  }
  program.set(shaders::points_vert::size_at_equal_distance_px, size_px);
  program.set(shaders::points_frag::eye_width_px, static_cast<float>(view.eyes.width()));
  surface.bind_to(program);
  program.use();
  glBindVertexArray(no_attributes_.name());
  glEnable(GL_PROGRAM_POINT_SIZE);
  glDrawArraysInstanced(GL_POINTS, 0, surface.pixel_count(), view.eyes.count());
}

}  // namespace roomcast::render
