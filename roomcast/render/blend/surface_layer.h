// SPDX-License-Identifier: Apache-2.0
// A cleaned surface where it stands in the room, and the drawing of its triangles. Needs the GL
// context it was made with.
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
  bool is_background = false;  // stands back, and counts little beside a live one
};

/// A program for LayerPainter: both shaders are preceded by shaders/blend/blend_surface.glsl, the
/// vertex shader by whatever puts points in view, too. Errors as make_program.
[[nodiscard]] Result<GlProgram> make_layer_program(std::string_view vertex_shader,
                                                   std::string_view fragment_shader);

class LayerPainter {
 public:
  LayerPainter() : vertices_(GlVertexArray::create()) {}

  /// Into the bound framebuffer, with the tests and masks that are set.
  void draw(const GlProgram& program, const SurfaceLayer& layer, const Eyes& eyes) const;

 private:
  GlVertexArray vertices_;
};

}  // namespace roomcast::render
