// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/compute_pass.h"

#include <array>
#include <utility>

namespace roomcast::render {

Result<ComputePass> ComputePass::create(std::initializer_list<std::string_view> sources) {
  auto program = make_program({{GL_COMPUTE_SHADER, sources}});
  if (!program) return std::move(program).error();
  return ComputePass(*std::move(program));
}

ComputePass::ComputePass(GlProgram program) : program_(std::move(program)) {
  std::array<GLint, 3> size{};
  glGetProgramiv(program_.name(), GL_COMPUTE_WORK_GROUP_SIZE, size.data());
  group_width_ = size[0];
  group_height_ = size[1];
}

void ComputePass::run(int width, int height, int layers) const {
  const auto groups = [](int pixels, int per_group) {
    return static_cast<GLuint>((pixels + per_group - 1) / per_group);
  };
  glUseProgram(program_.name());
  glDispatchCompute(groups(width, group_width_), groups(height, group_height_),
                    static_cast<GLuint>(layers));
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                  GL_TEXTURE_UPDATE_BARRIER_BIT);
}

void bind_image(GLuint unit, const GlTexture& texture, ImageAccess access, GLenum format) {
  glBindImageTexture(unit, texture.name(), 0, GL_FALSE, 0, static_cast<GLenum>(access), format);
}

void bind_image(GLuint unit, const GlLayers& layers, ImageAccess access, GLenum format) {
  glBindImageTexture(unit, layers.name(), 0, GL_TRUE, 0, static_cast<GLenum>(access), format);
}

}  // namespace roomcast::render
