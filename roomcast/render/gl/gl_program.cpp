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

}  // namespace roomcast::render
