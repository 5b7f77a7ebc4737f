// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/gl/gl_program.h"

#include <string>
#include <vector>

namespace roomcast::render {
namespace {

constexpr std::string_view kVersionLine = "#version 450 core\n";

struct GlShaderKind {
  static void destroy(GLuint name) { glDeleteShader(name); }
};
using GlShader = GlObject<GlShaderKind>;

using GetInteger = PFNGLGETSHADERIVPROC;
using GetLog = PFNGLGETSHADERINFOLOGPROC;

Error with_log(const char* what, GLuint name, GetInteger get_integer, GetLog get_log) {
  GLint length = 0;
  get_integer(name, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  GLsizei written = 0;
  get_log(name, length, &written, log.data());
  log.resize(static_cast<std::size_t>(written));
  return Error{ErrorCode::kUnsupported, std::string(what) + ": " + log};
}

Result<GlShader> compile(const GlStage& stage) {
  std::vector<const GLchar*> texts = {kVersionLine.data()};
  std::vector<GLint> lengths = {static_cast<GLint>(kVersionLine.size())};
  for (std::string_view source : stage.sources) {
    texts.push_back(source.data());
    lengths.push_back(static_cast<GLint>(source.size()));
  }
  GlShader shader(glCreateShader(stage.kind));
  glShaderSource(shader.name(), static_cast<GLsizei>(texts.size()), texts.data(), lengths.data());
  glCompileShader(shader.name());
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
  if (compiled) return shader;
  return with_log("the driver does not compile a shader", shader.name(), glGetShaderiv,
                  glGetShaderInfoLog);
}

}  // namespace

GLuint GlProgramKind::create() {
  return glCreateProgram();
}
void GlProgramKind::destroy(GLuint name) {
  glDeleteProgram(name);
}

Result<GlProgram> make_program(std::initializer_list<GlStage> stages) {
  GlProgram program = GlProgram::create();
  for (const GlStage& stage : stages) {
    Result<GlShader> shader = compile(stage);
    if (!shader) return std::move(shader).error();
    glAttachShader(program.name(), shader->name());  // the program keeps the shader alive
  }
  glLinkProgram(program.name());
  GLint linked = GL_FALSE;
  glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
  if (linked) return program;
  return with_log("the driver does not link a program", program.name(), glGetProgramiv,
                  glGetProgramInfoLog);
}

void set_uniform(GLuint program, GLint location, GLsizei count, const float* values) {
  glProgramUniform1fv(program, location, count, values);
}
void set_uniform(GLuint program, GLint location, GLsizei count, const GLint* values) {
  glProgramUniform1iv(program, location, count, values);
}
void set_uniform(GLuint program, GLint location, GLsizei count, const GLuint* values) {
  glProgramUniform1uiv(program, location, count, values);
}
void set_uniform(GLuint program, GLint location, GLsizei count, const Eigen::Vector2i* values) {
  glProgramUniform2iv(program, location, count, values->data());
}
void set_uniform(GLuint program, GLint location, GLsizei count, const Eigen::Vector2f* values) {
  glProgramUniform2fv(program, location, count, values->data());
}
void set_uniform(GLuint program, GLint location, GLsizei count, const Eigen::Vector3f* values) {
  glProgramUniform3fv(program, location, count, values->data());
}
void set_uniform(GLuint program, GLint location, GLsizei count, const Eigen::Vector4f* values) {
  glProgramUniform4fv(program, location, count, values->data());
}
void set_uniform(GLuint program, GLint location, GLsizei count, const Eigen::Matrix3f* values) {
  glProgramUniformMatrix3fv(program, location, count, GL_FALSE, values->data());
}
void set_uniform(GLuint program, GLint location, GLsizei count, const Eigen::Matrix4f* values) {
  glProgramUniformMatrix4fv(program, location, count, GL_FALSE, values->data());
}

void dispatch(const std::array<int, 3>& size, const std::array<int, 2>& group,
              GLbitfield barriers) {
  const auto groups = [](int pixels, int per_group) {
    return static_cast<GLuint>((pixels + per_group - 1) / per_group);
  };
  glDispatchCompute(groups(size[0], group[0]), groups(size[1], group[1]),
                    static_cast<GLuint>(size[2]));
  glMemoryBarrier(barriers);
}

}  // namespace roomcast::render
