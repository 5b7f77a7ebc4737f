// SPDX-License-Identifier: Apache-2.0
// SurfaceLayer: a cleaned surface and its pose in the room. LayerPainter draws its triangles. Needs
// the GL context it was made with.
#pragma once

#include <string_view>

#include "roomcast/core/ids.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/render/blend/clean_surface.h"
#include "roomcast/render/view/eyes.h"

namespace roomcast::render {

struct SurfaceLayer {
  SensorId sensor;
  RigidTransform world_from_depth;
  const CleanSurface* surface = nullptr;
  const GlTexture* rays = nullptr;
  bool is_background = false;  // drawn farther back, with a lower weight than live surfaces
};

/// A program for LayerPainter. Both shaders are preceded by shaders/blend/blend_surface.glsl, the
/// vertex shader also by the sources that transform points to the view. Errors as make_program.
[[nodiscard]] Result<GlProgram> make_layer_program(std::string_view vertex_shader,
                                                   std::string_view fragment_shader);

class LayerPainter {
 public:
  LayerPainter() : vertices_(GlVertexArray::create()) {}

  /// Draws into the bound framebuffer with the current depth test and write masks.
  void draw(const GlProgram& program, const SurfaceLayer& layer, const Eyes& eyes) const;

 private:
  GlVertexArray vertices_;
};

}  // namespace roomcast::render
