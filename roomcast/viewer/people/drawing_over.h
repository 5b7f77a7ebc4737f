// SPDX-License-Identifier: Apache-2.0
// DrawingOver: GL state for drawing into a room that is already in the bound framebuffer
// (OffscreenTarget), for the lifetime of this object. Nearer surfaces hide the drawing; it writes
// colour but no sensor. Leaves the GL state as RoomRenderer expects it.
#pragma once

#include "roomcast/render/view/offscreen_target.h"

namespace roomcast::viewer {

class DrawingOver {
 public:
  enum Kind {
    kSolid,        // hides farther surfaces
    kTransparent,  // blended with the surfaces behind it; hides nothing
  };

  explicit DrawingOver(Kind kind) {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(kind == kSolid ? GL_TRUE : GL_FALSE);
    glColorMaski(render::OffscreenTarget::kSensorsAttachment, GL_FALSE, GL_FALSE, GL_FALSE,
                 GL_FALSE);
    if (kind == kSolid) return;
    glEnablei(GL_BLEND, render::OffscreenTarget::kColorAttachment);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  }
  ~DrawingOver() {
    glDisablei(GL_BLEND, render::OffscreenTarget::kColorAttachment);
    glColorMaski(render::OffscreenTarget::kSensorsAttachment, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
  }
  DrawingOver(const DrawingOver&) = delete;
  DrawingOver& operator=(const DrawingOver&) = delete;
};

}  // namespace roomcast::viewer
