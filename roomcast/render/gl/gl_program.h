// SPDX-License-Identifier: Apache-2.0
// A linked GL program. Stages are given as several sources that the compiler sees one after the
// other, so that what shaders share is written once; the "#version 450 core" line is added here.
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

/// kUnsupported with the compiler's or linker's own log.
[[nodiscard]] Result<GlProgram> make_program(std::initializer_list<GlStage> stages);

}  // namespace roomcast::render
