// SPDX-License-Identifier: Apache-2.0
// Faint lines every metre on the world's floor (y = 0), so that an empty part of the room still has
// an up, a down and a scale. Behind everything: it leaves no depth and belongs to no sensor. Draws
// into the bound framebuffer; needs the GL context it was made with.
#pragma once

#include "roomcast/core/image.h"
#include "roomcast/render/gl/gl_program.h"
#include "roomcast/render/view/eyes.h"

namespace roomcast::render {

class FloorGrid {
 public:
  /// kUnsupported with the driver's log when it does not take the shaders.
  static Result<FloorGrid> create();

  void draw(const Eyes& eyes, Rgb8 line) const;

 private:
  explicit FloorGrid(GlProgram program);

  GlProgram program_;
  GlVertexArray no_attributes_;
};

}  // namespace roomcast::render
