// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/gl/gl_object.h"

namespace roomcast::render {

GLuint GlBufferKind::create() {
  GLuint name = 0;
  glCreateBuffers(1, &name);
  return name;
}
void GlBufferKind::destroy(GLuint name) {
  glDeleteBuffers(1, &name);
}

GLuint GlFramebufferKind::create() {
  GLuint name = 0;
  glCreateFramebuffers(1, &name);
  return name;
}
void GlFramebufferKind::destroy(GLuint name) {
  glDeleteFramebuffers(1, &name);
}

GLuint GlVertexArrayKind::create() {
  GLuint name = 0;
  glCreateVertexArrays(1, &name);
  return name;
}
void GlVertexArrayKind::destroy(GLuint name) {
  glDeleteVertexArrays(1, &name);
}

GLuint GlLayersKind::create() {
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &name);
  return name;
}
void GlLayersKind::destroy(GLuint name) {
  glDeleteTextures(1, &name);
}

GLuint GlTextureKind::create() {
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &name);
  return name;
}
void GlTextureKind::destroy(GLuint name) {
  glDeleteTextures(1, &name);
}

namespace {

void read_by(GLint filter, GLuint texture) {
  glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, filter);
  glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, filter);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

}  // namespace

GlTexture make_texture(GLenum internal_format, int width, int height) {
  GlTexture texture = GlTexture::create();
  glTextureStorage2D(texture.name(), 1, internal_format, width, height);
  read_by(GL_NEAREST, texture.name());
  return texture;
}

GlTexture make_smooth_texture(GLenum internal_format, int width, int height) {
  GlTexture texture = make_texture(internal_format, width, height);
  read_by(GL_LINEAR, texture.name());
  return texture;
}

GlLayers make_smooth_layers(GLenum internal_format, int width, int height, int count) {
  GlLayers layers = GlLayers::create();
  glTextureStorage3D(layers.name(), 1, internal_format, width, height, count);
  read_by(GL_LINEAR, layers.name());
  return layers;
}

GlBuffer make_buffer(GLsizeiptr bytes) {
  GlBuffer buffer = GlBuffer::create();
  glNamedBufferStorage(buffer.name(), bytes, nullptr, 0);
  return buffer;
}

}  // namespace roomcast::render
