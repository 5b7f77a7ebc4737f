// SPDX-License-Identifier: Apache-2.0
// FloorGrid: faint lines every metre on the world's floor (y = 0). They show up, down and scale
// where the room is empty. Drawn behind everything: writes no depth and no sensor. Draws into the
// bound framebuffer; needs the GL context it was made with.
#pragma once

#include "roomcast/core/image.h"
#include "roomcast/render/view/eyes.h"

namespace roomcast::render {

class FloorGrid {
 public:
  /// kUnsupported with the driver's log if it rejects the shaders.
  static Result<FloorGrid> create();

  void draw(const Eyes& eyes, Rgb8 line) const;

 private:
  using Program = DrawProgram<Vertex<shaders::eyes_glsl, shaders::floor_grid_vert>,
                              Fragment<shaders::floor_grid_frag>>;

  explicit FloorGrid(Program program);
  void set_uniforms(const Eyes& eyes, Rgb8 line) const;

  Program program_;
  GlVertexArray no_attributes_;
};

}  // namespace roomcast::render
