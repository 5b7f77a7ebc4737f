// SPDX-License-Identifier: Apache-2.0
// A linked GL program. A stage consists of several sources, compiled as one text, so that shaders
// can share code. make_program adds the line "#version 450 core".
#pragma once

#include <initializer_list>
#include <string_view>

#include "roomcast/core/result.h"
#include "roomcast/render/gl/gl_object.h"

namespace roomcast::render {

struct GlProgramKind {
  static GLuint create();
  static void destroy(GLuint name);
};
using GlProgram = GlObject<GlProgramKind>;

struct GlStage {
  GLenum kind;  // GL_VERTEX_SHADER, GL_FRAGMENT_SHADER, GL_COMPUTE_SHADER
  std::initializer_list<std::string_view> sources;
};

/// Compiles and links the stages. kUnsupported with the log of the compiler or linker.
[[nodiscard]] Result<GlProgram> make_program(std::initializer_list<GlStage> stages);

}  // namespace roomcast::render
