// SPDX-License-Identifier: Apache-2.0
// A linked GL program. A stage consists of several sources, compiled as one text, so that shaders
// can share code. make_program adds the line "#version 450 core".
#pragma once

#include <array>
#include <initializer_list>
#include <string_view>

#include <Eigen/Core>

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

// Set `count` elements of a program's uniform, one after the other in memory.
void set_uniform(GLuint program, GLint location, GLsizei count, const float* values);
void set_uniform(GLuint program, GLint location, GLsizei count, const GLint* values);
void set_uniform(GLuint program, GLint location, GLsizei count, const GLuint* values);
void set_uniform(GLuint program, GLint location, GLsizei count, const Eigen::Vector2i* values);
void set_uniform(GLuint program, GLint location, GLsizei count, const Eigen::Vector2f* values);
void set_uniform(GLuint program, GLint location, GLsizei count, const Eigen::Vector3f* values);
void set_uniform(GLuint program, GLint location, GLsizei count, const Eigen::Vector4f* values);
void set_uniform(GLuint program, GLint location, GLsizei count, const Eigen::Matrix3f* values);
void set_uniform(GLuint program, GLint location, GLsizei count, const Eigen::Matrix4f* values);

inline constexpr GLbitfield kPictureBarriers = GL_TEXTURE_FETCH_BARRIER_BIT |
                                               GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                                               GL_TEXTURE_UPDATE_BARRIER_BIT;
/// Runs the compute program in use for at least `size` invocations in groups of width and height
/// `group`, and sets the memory barriers after it.
void dispatch(const std::array<int, 3>& size, const std::array<int, 2>& group, GLbitfield barriers);

}  // namespace roomcast::render
