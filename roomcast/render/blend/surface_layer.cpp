// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/surface_layer.h"

#include "roomcast/render/view/surface_view.h"

namespace roomcast::render {
namespace {

constexpr float kBackgroundSetback_m = 0.03F;

}  // namespace

void LayerPainter::draw(AnyLayerProgram program, const SurfaceLayer& layer,
                        const Eyes& eyes) const {
  using shaders::blend_surface_glsl;
  const CleanSurface& surface = *layer.surface;
  set_surface_view(program, surface_view(layer.sensor, layer.world_from_depth, eyes));
  program.set(shaders::blend_in_view_glsl::setback_m,
              layer.is_background ? kBackgroundSetback_m : 0);
  program.bind(blend_surface_glsl::depth_m, surface.depth_m);
  program.bind(blend_surface_glsl::rays, *layer.rays);
  program.bind(blend_surface_glsl::weighted_color, surface.weighted_color);
  program.bind(blend_surface_glsl::quality, surface.quality);
  program.use();
  glVertexArrayElementBuffer(vertices_.name(), surface.mesh.indices.name());
  glBindVertexArray(vertices_.name());
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, surface.mesh.commands.name());
  const GLintptr command = (eyes.count() - 1) * AdaptiveMesh::kCommandBytes;
  glDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, reinterpret_cast<const void*>(command));
}

}  // namespace roomcast::render
