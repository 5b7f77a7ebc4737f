// SPDX-License-Identifier: Apache-2.0
// DrawingOver: while it lives, what is drawn lies among the surfaces of the room that is already in
// the bound framebuffer (OffscreenTarget): hidden by what is nearer, in its colour only, of no
// sensor. Leaves the GL state as RoomRenderer expects it.
#pragma once

#include <epoxy/gl.h>

namespace roomcast::viewer {

class DrawingOver {
 public:
  enum Kind {
    kSolid,        // hides what is farther
    kTransparent,  // mixed with what is behind it, and hides nothing
  };

  explicit DrawingOver(Kind kind) {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(kind == kSolid ? GL_TRUE : GL_FALSE);
    glColorMaski(kSensors, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    if (kind == kSolid) return;
    glEnablei(GL_BLEND, kPicture);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  }
  ~DrawingOver() {
    glDisablei(GL_BLEND, kPicture);
    glColorMaski(kSensors, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
  }
  DrawingOver(const DrawingOver&) = delete;
  DrawingOver& operator=(const DrawingOver&) = delete;

 private:
  static constexpr GLuint kPicture = 0, kSensors = 1;  // attachments of an OffscreenTarget
};

}  // namespace roomcast::viewer
