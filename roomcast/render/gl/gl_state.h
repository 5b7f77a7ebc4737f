// SPDX-License-Identifier: Apache-2.0
// GL state that differs from its default for the lifetime of an object. Needs a current GL context.
#pragma once

#include <epoxy/gl.h>

namespace roomcast::render {

/// Enables a capability, such as GL_CULL_FACE.
class Enabled {
 public:
  explicit Enabled(GLenum capability) : capability_(capability) { glEnable(capability); }
  ~Enabled() { glDisable(capability_); }
  Enabled(const Enabled&) = delete;
  Enabled& operator=(const Enabled&) = delete;

 private:
  GLenum capability_;
};

/// Blends into the framebuffer's first attachment.
class Blending {
 public:
  Blending(GLenum source_factor, GLenum target_factor) {
    glEnablei(GL_BLEND, 0);
    glBlendFunc(source_factor, target_factor);
  }
  ~Blending() { glDisablei(GL_BLEND, 0); }
  Blending(const Blending&) = delete;
  Blending& operator=(const Blending&) = delete;
};

/// Leaves one of the framebuffer's colour attachments as it is.
class AttachmentKept {
 public:
  explicit AttachmentKept(GLuint attachment) : attachment_(attachment) { write(GL_FALSE); }
  ~AttachmentKept() { write(GL_TRUE); }
  AttachmentKept(const AttachmentKept&) = delete;
  AttachmentKept& operator=(const AttachmentKept&) = delete;

 private:
  void write(GLboolean all) const { glColorMaski(attachment_, all, all, all, all); }

  GLuint attachment_;
};

/// Leaves the framebuffer's depth as it is.
class DepthKept {
 public:
  DepthKept() { glDepthMask(GL_FALSE); }
  ~DepthKept() { glDepthMask(GL_TRUE); }
  DepthKept(const DepthKept&) = delete;
  DepthKept& operator=(const DepthKept&) = delete;
};

}  // namespace roomcast::render
