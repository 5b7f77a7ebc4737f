// SPDX-License-Identifier: Apache-2.0
// SurfaceLayer: a cleaned surface and its pose in the room. LayerPainter draws its triangles. Needs
// the GL context it was made with.
#pragma once

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

/// A program for LayerPainter that ends with these two shaders.
template <class VertexShader, class FragmentShader>
using LayerProgram =
    DrawProgram<Vertex<shaders::eyes_glsl, shaders::surface_view_glsl, shaders::blend_surface_glsl,
                       shaders::blend_in_view_glsl, VertexShader>,
                Fragment<shaders::blend_surface_glsl, FragmentShader>>;
using AnyLayerProgram = ProgramWith<shaders::eyes_glsl, shaders::surface_view_glsl,
                                    shaders::blend_surface_glsl, shaders::blend_in_view_glsl>;

class LayerPainter {
 public:
  LayerPainter() : vertices_(GlVertexArray::create()) {}

  /// Draws into the bound framebuffer with the current depth test and write masks.
  void draw(AnyLayerProgram program, const SurfaceLayer& layer, const Eyes& eyes) const;

 private:
  GlVertexArray vertices_;
};

}  // namespace roomcast::render
