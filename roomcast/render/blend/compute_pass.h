// SPDX-License-Identifier: Apache-2.0
// ComputePass: a compute shader that runs once per pixel of a picture, or of several layers. Needs
// the GL context it was made with.
#pragma once

#include <initializer_list>
#include <string_view>

#include "roomcast/core/result.h"
#include "roomcast/render/gl/gl_program.h"

namespace roomcast::render {

class ComputePass {
 public:
  /// kUnsupported with the driver's log if it rejects the shader.
  static Result<ComputePass> create(std::initializer_list<std::string_view> sources);

  /// The pass's textures and images must be bound. Its output can be fetched and copied afterwards.
  void run(int width, int height, int layers = 1) const;

  [[nodiscard]] const GlProgram& program() const { return program_; }

 private:
  explicit ComputePass(GlProgram program);

  GlProgram program_;
  int group_width_ = 1, group_height_ = 1;
};

enum class ImageAccess : GLenum {
  kRead = GL_READ_ONLY,
  kWrite = GL_WRITE_ONLY,
  kBoth = GL_READ_WRITE,
};

void bind_image(GLuint unit, const GlTexture& texture, ImageAccess access, GLenum format);
/// Binds all layers.
void bind_image(GLuint unit, const GlLayers& layers, ImageAccess access, GLenum format);

}  // namespace roomcast::render
