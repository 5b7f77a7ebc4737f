// SPDX-License-Identifier: Apache-2.0
// SurfaceLayer: a cleaned surface and its pose in the room. LayerPainter draws its triangles. Needs
// the GL context it was made with.
#pragma once

#include "roomcast/core/ids.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/render/blend/clean_surface.h"
#include "roomcast/render/blend/surface_flow.h"
#include "roomcast/render/view/eyes.h"

namespace roomcast::render {

struct SurfaceLayer {
  enum class Part {
    kLive,
    /// Of what is before a known background, such as a person: seen where no sensor sees the near
    /// side, for example a leg's side between the sensors in front of and behind it. Without them
    /// one sees through the leg.
    kBacks,
    kBackground,  // with a lower weight than live surfaces
  };

  SensorId sensor;
  RigidTransform world_from_depth;
  const CleanSurface* surface = nullptr;
  const GlTexture* rays = nullptr;
  const SurfaceFlow* flow = nullptr;
  Part part = Part::kLive;
  float ahead_s = 0;  // draws what moves where it is this much later
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

  /// Draws into the bound framebuffer with the current depth test and write masks. Culls the sides
  /// that the part does not show.
  void draw(AnyLayerProgram program, const SurfaceLayer& layer, const Eyes& eyes) const;

 private:
  GlVertexArray vertices_;
};

}  // namespace roomcast::render
