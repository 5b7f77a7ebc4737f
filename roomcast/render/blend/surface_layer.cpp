// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/surface_layer.h"

#include "roomcast/render/gl/gl_state.h"
#include "roomcast/render/view/surface_view.h"

namespace roomcast::render {
namespace {

/// How far behind its place a part is drawn, so that live front sides there hide it.
float setback_m(SurfaceLayer::Part part) {
  using Part = SurfaceLayer::Part;
  if (part == Part::kLive) return 0;
  return part == Part::kBacks ? 0.04F : 0.03F;
}

}  // namespace

void LayerPainter::draw(AnyLayerProgram program, const SurfaceLayer& layer,
                        const Eyes& eyes) const {
  using shaders::blend_surface_glsl;
  const CleanSurface& surface = *layer.surface;
  set_surface_view(program, surface_view(layer.sensor, layer.world_from_depth, eyes));
  const bool backs = layer.part == SurfaceLayer::Part::kBacks;
  const AdaptiveMesh& mesh = backs ? surface.foreground : surface.mesh;
  program.set(shaders::blend_in_view_glsl::setback_m, setback_m(layer.part));
  program.set(shaders::blend_in_view_glsl::ahead_s, layer.ahead_s);
  program.bind(shaders::blend_in_view_glsl::velocities, layer.flow->velocities());
  program.bind(blend_surface_glsl::depth_m, surface.depth_m);
  program.bind(blend_surface_glsl::rays, *layer.rays);
  program.bind(blend_surface_glsl::weighted_color, surface.weighted_color);
  program.bind(blend_surface_glsl::quality, surface.quality);
  program.use();
  const Enabled culling(GL_CULL_FACE);
  glCullFace(backs ? GL_FRONT : GL_BACK);
  glVertexArrayElementBuffer(vertices_.name(), mesh.indices.name());
  glBindVertexArray(vertices_.name());
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, mesh.commands.name());
  const GLintptr command = (eyes.count() - 1) * AdaptiveMesh::kCommandBytes;
  glDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, reinterpret_cast<const void*>(command));
  glCullFace(GL_BACK);
}

}  // namespace roomcast::render
