// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/floor_grid.h"

#include "roomcast/render/shader_sources.h"
#include "roomcast/render/surface_view.h"

namespace roomcast {
namespace {

// As in shaders/floor_grid.*.
enum UniformLocation : GLint { kClipFromWorld = 0, kEye = 1, kReach = 2, kLine = 3 };
constexpr float kReachM = 15;
constexpr float kStrength = 0.35F;

void set_uniforms(GLuint program, const ViewCamera& camera, Rgb8 line) {
  const Eigen::Matrix4f clip_from_world =
      clip_from_view(camera) * matrix_from_transform(camera.world_from_view.inverse());
  const Eigen::Vector3f eye = camera.world_from_view.translation_m.cast<float>();
  glProgramUniformMatrix4fv(program, kClipFromWorld, 1, GL_FALSE, clip_from_world.data());
  glProgramUniform3fv(program, kEye, 1, eye.data());
  glProgramUniform1f(program, kReach, kReachM);
  glProgramUniform4f(program, kLine, static_cast<float>(line.r) / 255,
                     static_cast<float>(line.g) / 255, static_cast<float>(line.b) / 255, kStrength);
}

}  // namespace

Result<FloorGrid> FloorGrid::create() {
  Result<GlProgram> program = make_program({{GL_VERTEX_SHADER, {shaders::floor_grid_vert}},
                                            {GL_FRAGMENT_SHADER, {shaders::floor_grid_frag}}});
  if (!program) return std::move(program).error();
  return FloorGrid(std::move(program).value());
}

FloorGrid::FloorGrid(GlProgram program)
    : program_(std::move(program)), no_attributes_(GlVertexArray::create()) {}

void FloorGrid::draw(const ViewCamera& camera, Rgb8 line) const {
  constexpr GLuint kPicture = 0, kSensors = 1;
  set_uniforms(program_.name(), camera, line);
  glUseProgram(program_.name());
  glBindVertexArray(no_attributes_.name());
  glDisable(GL_DEPTH_TEST);
  glColorMaski(kSensors, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glEnablei(GL_BLEND, kPicture);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDisablei(GL_BLEND, kPicture);
  glColorMaski(kSensors, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace roomcast
