// SPDX-License-Identifier: Apache-2.0
// Owners of GL names. Each type owns one name, can be moved but not copied, and deletes the name in
// its destructor. A default-constructed object owns no name. Create and destroy objects while their
// context is current.
#pragma once

#include <utility>

#include <epoxy/gl.h>

namespace roomcast::render {

template <class Kind>
class GlObject {
 public:
  GlObject() = default;
  explicit GlObject(GLuint name) : name_(name) {}
  ~GlObject() {
    if (name_ != 0) Kind::destroy(name_);
  }
  GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }

  static GlObject create() { return GlObject(Kind::create()); }

  [[nodiscard]] GLuint name() const { return name_; }

 private:
  GLuint name_ = 0;
};

struct GlBufferKind {
  static GLuint create();
  static void destroy(GLuint name);
};
struct GlFramebufferKind {
  static GLuint create();
  static void destroy(GLuint name);
};
struct GlVertexArrayKind {
  static GLuint create();
  static void destroy(GLuint name);
};
struct GlLayersKind {
  static GLuint create();  // GL_TEXTURE_2D_ARRAY
  static void destroy(GLuint name);
};
struct GlTextureKind {
  static GLuint create();  // GL_TEXTURE_2D
  static void destroy(GLuint name);
};

using GlBuffer = GlObject<GlBufferKind>;
using GlFramebuffer = GlObject<GlFramebufferKind>;
using GlVertexArray = GlObject<GlVertexArrayKind>;
using GlLayers = GlObject<GlLayersKind>;
using GlTexture = GlObject<GlTextureKind>;

/// A 2D texture of fixed size with one level, for texelFetch: nearest filter, no wrap. Its content
/// is undefined. (Integer textures with another filter are incomplete: they read as zero, without
/// an error.)
[[nodiscard]] GlTexture make_texture(GLenum internal_format, int width, int height);

/// As make_texture, with a linear filter. Not for integer formats.
[[nodiscard]] GlTexture make_smooth_texture(GLenum internal_format, int width, int height);

/// An array of `count` layers of one size, with a linear filter.
[[nodiscard]] GlLayers make_smooth_layers(GLenum internal_format, int width, int height, int count);

/// A buffer of fixed size that the CPU does not access. Its content is undefined.
[[nodiscard]] GlBuffer make_buffer(GLsizeiptr bytes);

}  // namespace roomcast::render
