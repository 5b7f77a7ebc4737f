// SPDX-License-Identifier: Apache-2.0
// GL programs as types, after Magnum's AbstractShaderProgram. embed_shaders.cmake makes a struct of
// every file in shaders/ (roomcast/render/gl/shaders.h, made by the build): its text, and a
// constant for each uniform, texture, image and buffer. So a shader's `layout` is the only place
// for a location or binding. The type of a program is the list of its files; to set what is not
// declared in one of them, or to a value of another type, does not compile. Needs the GL context
// that a program was made with.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

#include <Eigen/Core>

#include "roomcast/core/result.h"
#include "roomcast/render/gl/gl_program.h"

namespace roomcast::render {

/// What shaders.h says in GLSL's words.
namespace glsl {

using uint = GLuint;
using vec2 = Eigen::Vector2f;
using vec3 = Eigen::Vector3f;
using vec4 = Eigen::Vector4f;
using ivec2 = Eigen::Vector2i;
using mat3 = Eigen::Matrix3f;
using mat4 = Eigen::Matrix4f;

template <class Bound>
struct PictureType {
  using Texture = Bound;
};
struct sampler2D : PictureType<GlTexture> {};
struct usampler2D : PictureType<GlTexture> {};
struct sampler2DArray : PictureType<GlLayers> {};
struct image2D : PictureType<GlTexture> {};
struct uimage2D : PictureType<GlTexture> {};
struct image2DArray : PictureType<GlLayers> {};

enum Access : GLenum {
  readonly = GL_READ_ONLY,
  writeonly = GL_WRITE_ONLY,
  readwrite = GL_READ_WRITE,
};
enum Format : GLenum {
  r8ui = GL_R8UI,
  r16f = GL_R16F,
  r32f = GL_R32F,
  rgba16f = GL_RGBA16F,
  rgba32f = GL_RGBA32F,
};

// What a shader file, `Source`, declares.
template <class Source, class T>
struct Uniform {
  GLint location;
};
template <class Source, class Type>
struct Sampler {
  GLuint unit;
};
template <class Source, class Type>
struct ImageUnit {
  GLuint unit;
  Access access;
  Format format;
};
template <class Source>
struct StorageBlock {
  GLuint binding;
};
template <class Source, class T>
struct VertexInput {
  GLuint location;
};

}  // namespace glsl

template <class Source, class... Sources>
concept OneOf = (std::same_as<Source, Sources> || ...);

/// Any linked program with `Sources` among its files: a reference that must not outlive it.
template <class... Sources>
class ProgramWith {
 public:
  template <class... More>
  requires(OneOf<Sources, More...>&&...)
      ProgramWith(const ProgramWith<More...>& program)  // NOLINT(google-explicit-constructor)
      : name_(program.name()) {}

  template <OneOf<Sources...> Source, class T>
  void set(glsl::Uniform<Source, T> uniform, const T& value) const {
    set_uniform(name_, uniform.location, 1, &value);
  }
  template <OneOf<Sources...> Source>
  void set(glsl::Uniform<Source, bool> uniform, bool value) const {
    const GLint number = value;
    set_uniform(name_, uniform.location, 1, &number);
  }
  template <OneOf<Sources...> Source, class T, std::size_t kCount>
  void set(glsl::Uniform<Source, std::array<T, kCount>> uniform,
           const std::array<T, kCount>& values) const {
    set_uniform(name_, uniform.location, kCount, values.data());
  }

  // Textures, images and buffers are bound for all programs: bind those of a program just before it
  // runs.
  template <OneOf<Sources...> Source, class Type>
  void bind(glsl::Sampler<Source, Type> sampler, const typename Type::Texture& texture) const {
    glBindTextureUnit(sampler.unit, texture.name());
  }
  template <OneOf<Sources...> Source, class Type>
  void bind(glsl::ImageUnit<Source, Type> image, const typename Type::Texture& texture) const {
    constexpr GLboolean kAllLayers = std::same_as<typename Type::Texture, GlLayers>;
    glBindImageTexture(image.unit, texture.name(), 0, kAllLayers, 0, image.access, image.format);
  }
  template <OneOf<Sources...> Source>
  void bind(glsl::StorageBlock<Source> block, const GlBuffer& buffer) const {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, block.binding, buffer.name());
  }

  void use() const { glUseProgram(name_); }
  [[nodiscard]] GLuint name() const { return name_; }

 protected:
  explicit ProgramWith(GLuint name) : name_(name) {}

 private:
  GLuint name_;
};

template <class... Sources>
struct Vertex {};
template <class... Sources>
struct Fragment {};

/// A program that draws: DrawProgram<Vertex<Sources...>, Fragment<Sources...>>. A source is a
/// struct of shaders.h, or any other with a `text`.
template <class VertexStage, class FragmentStage>
class DrawProgram;
template <class... VertexSources, class... FragmentSources>
class DrawProgram<Vertex<VertexSources...>, Fragment<FragmentSources...>>
    : public ProgramWith<VertexSources..., FragmentSources...> {
 public:
  /// As make_program.
  static Result<DrawProgram> create() {
    Result<GlProgram> program = make_program({{GL_VERTEX_SHADER, {VertexSources::text...}},
                                              {GL_FRAGMENT_SHADER, {FragmentSources::text...}}});
    if (!program) return std::move(program).error();
    return DrawProgram(*std::move(program));
  }

 private:
  explicit DrawProgram(GlProgram program)
      : ProgramWith<VertexSources..., FragmentSources...>(program.name()),
        program_(std::move(program)) {}

  GlProgram program_;
};

/// A program that computes. The last source has the size of its work groups.
template <class... Sources>
class ComputeProgram : public ProgramWith<Sources...> {
 public:
  using Main = typename decltype((std::type_identity<Sources>{}, ...))::type;
  static constexpr std::array<int, 2> kGroupSize = Main::local_size;

  /// As make_program.
  static Result<ComputeProgram> create() {
    Result<GlProgram> program = make_program({{GL_COMPUTE_SHADER, {Sources::text...}}});
    if (!program) return std::move(program).error();
    return ComputeProgram(*std::move(program));
  }

  /// One invocation per pixel of a picture, or of several layers. `barriers`: glMemoryBarrier's,
  /// for what reads the output; by default it can be fetched, loaded and copied as a picture.
  void run(int width, int height, int layers = 1, GLbitfield barriers = kPictureBarriers) const {
    this->use();
    dispatch({width, height, layers}, kGroupSize, barriers);
  }

 private:
  explicit ComputeProgram(GlProgram program)
      : ProgramWith<Sources...>(program.name()), program_(std::move(program)) {}

  GlProgram program_;
};

/// Creates the members of an aggregate, all of which have a `create()`; pass each of them, in
/// order: create_parts(&Programs::nearest, &Programs::mix). The first error if one fails.
template <class Parts, class... Part>
Result<Parts> create_parts(Part Parts::*... /*members*/) {
  const auto join = [](Result<Part>... parts) -> Result<Parts> {
    for (const Error* error : {(parts.ok() ? nullptr : &parts.error())...}) {
      if (error != nullptr) return *error;
    }
    return Parts{*std::move(parts)...};
  };
  return std::apply(join, std::tuple<Result<Part>...>{Part::create()...});
}

}  // namespace roomcast::render
