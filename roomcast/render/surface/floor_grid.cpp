// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/surface/floor_grid.h"

#include <utility>

#include "roomcast/render/gl/gl_state.h"
#include "roomcast/render/view/offscreen_target.h"

namespace roomcast::render {
namespace {

constexpr float kReachM = 15;
constexpr float kStrength = 0.35F;

}  // namespace

Result<FloorGrid> FloorGrid::create() {
  Result<Program> program = Program::create();
  if (!program) return std::move(program).error();
  return FloorGrid(*std::move(program));
}

FloorGrid::FloorGrid(Program program)
    : program_(std::move(program)), no_attributes_(GlVertexArray::create()) {}

void FloorGrid::set_uniforms(const Eyes& eyes, Rgb8 line) const {
  using shaders::floor_grid_frag;
  using shaders::floor_grid_vert;
  set_eyes(program_, eyes);
  program_.set(floor_grid_vert::clip_from_world, clip_from_world(eyes));
  program_.set(floor_grid_vert::eye_m, {eyes[0].world_from_view.translation_m.cast<float>(),
                                        eyes[1].world_from_view.translation_m.cast<float>()});
  program_.set(floor_grid_vert::reach_m, kReachM);
  const Eigen::Vector3f color(line.r, line.g, line.b);
  program_.set(floor_grid_frag::line,
               {color.x() / 255, color.y() / 255, color.z() / 255, kStrength});
}

void FloorGrid::draw(const Eyes& eyes, Rgb8 line) const {
  const EyeBorders borders(eyes);
  const AttachmentKept sensors(OffscreenTarget::kSensorsAttachment);
  const Blending blending(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  set_uniforms(eyes, line);
  program_.use();
  glBindVertexArray(no_attributes_.name());
  glDisable(GL_DEPTH_TEST);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, eyes.count());
}

}  // namespace roomcast::render
