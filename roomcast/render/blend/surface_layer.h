// SPDX-License-Identifier: Apache-2.0
// A cleaned surface where it stands in the room, and the drawing of its triangles with a program
// whose vertex shader begins with shaders/blend/blend_surface.glsl. Needs the GL context it was
// made with.
#pragma once

#include "roomcast/core/ids.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/render/blend/clean_surface.h"
#include "roomcast/render/view_camera.h"

namespace roomcast {

struct SurfaceLayer {
  SensorId sensor;
  RigidTransform world_from_depth;
  const CleanSurface* surface = nullptr;
  const GlTexture* rays = nullptr;
  bool is_background = false;  // stands back, and counts little beside a live one
};

class LayerPainter {
 public:
  LayerPainter() : vertices_(GlVertexArray::create()) {}

  /// Into the bound framebuffer, with the tests and masks that are set.
  void draw(const GlProgram& program, const SurfaceLayer& layer, const ViewCamera& camera) const;

 private:
  GlVertexArray vertices_;
};

}  // namespace roomcast
