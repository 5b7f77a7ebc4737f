// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/surface/floor_grid.h"

#include <array>

#include "roomcast/render/gl/shader_sources.h"

namespace roomcast::render {
namespace {

// As in shaders/floor_grid.*.
enum UniformLocation : GLint { kClipFromWorld = 0, kEye = 2, kReach = 4, kLine = 5 };
constexpr float kReachM = 15;
constexpr float kStrength = 0.35F;

void set_uniforms(const GlProgram& program, const Eyes& eyes, Rgb8 line) {
  set_eyes(program, eyes);
  set_matrices(program, kClipFromWorld, clip_from_world(eyes));
  std::array<Eigen::Vector3f, kMaxEyes> places_m;
  for (std::size_t eye = 0; eye < places_m.size(); ++eye) {
    places_m[eye] = eyes[eye].world_from_view.translation_m.cast<float>();
  }
  glProgramUniform3fv(program.name(), kEye, kMaxEyes, places_m[0].data());
  glProgramUniform1f(program.name(), kReach, kReachM);
  glProgramUniform4f(program.name(), kLine, static_cast<float>(line.r) / 255,
                     static_cast<float>(line.g) / 255, static_cast<float>(line.b) / 255, kStrength);
}

}  // namespace

Result<FloorGrid> FloorGrid::create() {
  Result<GlProgram> program =
      make_program({{GL_VERTEX_SHADER, {shaders::eyes_glsl, shaders::floor_grid_vert}},
                    {GL_FRAGMENT_SHADER, {shaders::floor_grid_frag}}});
  if (!program) return std::move(program).error();
  return FloorGrid(std::move(program).value());
}

FloorGrid::FloorGrid(GlProgram program)
    : program_(std::move(program)), no_attributes_(GlVertexArray::create()) {}

void FloorGrid::draw(const Eyes& eyes, Rgb8 line) const {
  constexpr GLuint kPicture = 0, kSensors = 1;
  const EyeBorders borders(eyes);
  set_uniforms(program_, eyes, line);
  glUseProgram(program_.name());
  glBindVertexArray(no_attributes_.name());
  glDisable(GL_DEPTH_TEST);
  glColorMaski(kSensors, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glEnablei(GL_BLEND, kPicture);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, eyes.count());
  glDisablei(GL_BLEND, kPicture);
  glColorMaski(kSensors, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace roomcast::render
