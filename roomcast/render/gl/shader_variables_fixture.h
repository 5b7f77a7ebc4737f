// SPDX-License-Identifier: Apache-2.0
// Compares what shaders.h says of the variables of GL programs with what the driver has linked. For
// tests; needs the GL context that the programs were made with.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "roomcast/render/gl/shaders.h"

namespace roomcast::render {

/// `place`: location, texture unit, image unit or binding.
struct ShaderVariable {
  GLenum interface;  // GL_UNIFORM, GL_PROGRAM_INPUT, GL_SHADER_STORAGE_BLOCK
  GLenum type;       // 0 for a block
  GLint count;       // elements of an array, else 1
  GLint place;

  friend bool operator==(const ShaderVariable&, const ShaderVariable&) = default;
  friend std::ostream& operator<<(std::ostream& out, const ShaderVariable& is) {
    return out << std::hex << "interface 0x" << is.interface << ", type 0x" << is.type << std::dec
               << ", count " << is.count << ", at " << is.place;
  }
};
using ShaderVariables = std::map<std::string, ShaderVariable>;

template <class T>
inline constexpr GLenum kTypeInGl = GL_NONE;
template <>
inline constexpr GLenum kTypeInGl<bool> = GL_BOOL;
template <>
inline constexpr GLenum kTypeInGl<int> = GL_INT;
template <>
inline constexpr GLenum kTypeInGl<glsl::uint> = GL_UNSIGNED_INT;
template <>
inline constexpr GLenum kTypeInGl<float> = GL_FLOAT;
template <>
inline constexpr GLenum kTypeInGl<glsl::vec2> = GL_FLOAT_VEC2;
template <>
inline constexpr GLenum kTypeInGl<glsl::vec3> = GL_FLOAT_VEC3;
template <>
inline constexpr GLenum kTypeInGl<glsl::vec4> = GL_FLOAT_VEC4;
template <>
inline constexpr GLenum kTypeInGl<glsl::ivec2> = GL_INT_VEC2;
template <>
inline constexpr GLenum kTypeInGl<glsl::mat3> = GL_FLOAT_MAT3;
template <>
inline constexpr GLenum kTypeInGl<glsl::mat4> = GL_FLOAT_MAT4;
template <>
inline constexpr GLenum kTypeInGl<glsl::sampler2D> = GL_SAMPLER_2D;
template <>
inline constexpr GLenum kTypeInGl<glsl::usampler2D> = GL_UNSIGNED_INT_SAMPLER_2D;
template <>
inline constexpr GLenum kTypeInGl<glsl::sampler2DArray> = GL_SAMPLER_2D_ARRAY;
template <>
inline constexpr GLenum kTypeInGl<glsl::image2D> = GL_IMAGE_2D;
template <>
inline constexpr GLenum kTypeInGl<glsl::uimage2D> = GL_UNSIGNED_INT_IMAGE_2D;
template <>
inline constexpr GLenum kTypeInGl<glsl::image2DArray> = GL_IMAGE_2D_ARRAY;

/// A visitor for the structs of shaders.h: collects the variables of those whose text is in `code`.
class DeclaredVariables {
 public:
  explicit DeclaredVariables(std::string code) : code_(std::move(code)) {}

  template <class Source>
  void operator()(Source) {
    if (code_.find(Source::text) != std::string::npos) Source::visit(*this);
  }
  template <class Source, class T>
  void operator()(const char* name, glsl::Uniform<Source, T> is) {
    add(name, {GL_UNIFORM, kTypeInGl<T>, 1, is.location});
  }
  template <class Source, class T, std::size_t kCount>
  void operator()(const char* name, glsl::Uniform<Source, std::array<T, kCount>> is) {
    add(name, {GL_UNIFORM, kTypeInGl<T>, kCount, is.location});
  }
  template <class Source, class Type>
  void operator()(const char* name, glsl::Sampler<Source, Type> is) {
    add(name, {GL_UNIFORM, kTypeInGl<Type>, 1, static_cast<GLint>(is.unit)});
  }
  template <class Source, class Type>
  void operator()(const char* name, glsl::ImageUnit<Source, Type> is) {
    add(name, {GL_UNIFORM, kTypeInGl<Type>, 1, static_cast<GLint>(is.unit)});
  }
  template <class Source>
  void operator()(const char* name, glsl::StorageBlock<Source> is) {
    add(name, {GL_SHADER_STORAGE_BLOCK, GL_NONE, 1, static_cast<GLint>(is.binding)});
  }
  template <class Source, class T>
  void operator()(const char* name, glsl::VertexInput<Source, T> is) {
    add(name, {GL_PROGRAM_INPUT, kTypeInGl<T>, 1, static_cast<GLint>(is.location)});
  }
  void operator()(const char* /*name*/, const std::array<int, 2>& local_size) {
    local_size_ = local_size;
  }

  [[nodiscard]] const ShaderVariables& variables() const { return variables_; }
  [[nodiscard]] const std::array<int, 2>& local_size() const { return local_size_; }

 private:
  /// Shaders of one program may declare the same variable, but not two of one name.
  void add(const char* name, const ShaderVariable& variable) {
    EXPECT_EQ(variables_.emplace(name, variable).first->second, variable) << name;
  }

  std::string code_;
  ShaderVariables variables_;
  std::array<int, 2> local_size_{};
};

/// The code of all shaders of a program.
inline std::string code_of(GLuint program) {
  std::array<GLuint, 2> shaders{};
  GLsizei count = 0;
  glGetAttachedShaders(program, shaders.size(), &count, shaders.data());
  std::string code;
  for (GLsizei i = 0; i < count; ++i) {
    const GLuint shader = shaders[static_cast<std::size_t>(i)];
    GLint length = 0;
    glGetShaderiv(shader, GL_SHADER_SOURCE_LENGTH, &length);
    std::string text(static_cast<std::size_t>(length), '\0');
    glGetShaderSource(shader, length, nullptr, text.data());
    code += text;
  }
  return code;
}

/// The `index`-th variable of one of a program's interfaces.
inline ShaderVariable linked_variable(GLuint program, GLenum interface, GLuint index) {
  ShaderVariable variable{interface, GL_NONE, 1, 0};
  const auto get = [&](GLenum property) {
    GLint value = 0;
    glGetProgramResourceiv(program, interface, index, 1, &property, 1, nullptr, &value);
    return value;
  };
  if (interface == GL_SHADER_STORAGE_BLOCK) {
    variable.place = get(GL_BUFFER_BINDING);
    return variable;
  }
  variable.type = static_cast<GLenum>(get(GL_TYPE));
  variable.count = get(GL_ARRAY_SIZE);
  variable.place = get(GL_LOCATION);
  for (const GLenum opaque :
       {kTypeInGl<glsl::sampler2D>, kTypeInGl<glsl::usampler2D>, kTypeInGl<glsl::sampler2DArray>,
        kTypeInGl<glsl::image2D>, kTypeInGl<glsl::uimage2D>, kTypeInGl<glsl::image2DArray>}) {
    if (variable.type == opaque) glGetUniformiv(program, variable.place, &variable.place);
  }
  return variable;
}

/// The variables that the driver found in use. Those of GLSL itself are left out.
inline ShaderVariables linked_variables(GLuint program) {
  ShaderVariables variables;
  for (const GLenum interface : {GL_UNIFORM, GL_SHADER_STORAGE_BLOCK, GL_PROGRAM_INPUT}) {
    GLint count = 0;
    glGetProgramInterfaceiv(program, interface, GL_ACTIVE_RESOURCES, &count);
    for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
      std::array<GLchar, 100> text{};
      glGetProgramResourceName(program, interface, i, text.size(), nullptr, text.data());
      std::string name = text.data();
      name = name.substr(0, name.find('['));
      if (name.starts_with("gl_")) continue;
      variables.emplace(name, linked_variable(program, interface, i));
    }
  }
  return variables;
}

/// Compares every program of the context with the structs that `visit_all` visits. Returns their
/// number.
template <class VisitAll>
int expect_programs_as_declared(VisitAll visit_all) {
  constexpr GLuint kMaxName = 1000;
  int programs = 0;
  for (GLuint program = 1; program < kMaxName; ++program) {
    if (!glIsProgram(program)) continue;
    ++programs;
    const std::string code = code_of(program);
    SCOPED_TRACE(code.substr(0, 300));
    DeclaredVariables declared(code);
    visit_all(declared);
    for (const auto& [name, is] : linked_variables(program)) {
      const auto found = declared.variables().find(name);
      if (found == declared.variables().end()) {
        ADD_FAILURE() << name << " is not declared";
      } else {
        EXPECT_EQ(found->second, is) << name;
      }
    }
    if (declared.local_size()[0] == 0) continue;
    std::array<GLint, 3> local_size{};
    glGetProgramiv(program, GL_COMPUTE_WORK_GROUP_SIZE, local_size.data());
    EXPECT_EQ(declared.local_size()[0], local_size[0]);
    EXPECT_EQ(declared.local_size()[1], local_size[1]);
  }
  return programs;
}

}  // namespace roomcast::render
