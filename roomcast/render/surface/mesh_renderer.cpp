// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/surface/mesh_renderer.h"

#include "roomcast/render/gl/shader_sources.h"

namespace roomcast::render {

Result<MeshRenderer> MeshRenderer::create() {
  Result<GlProgram> program =
      make_program({{GL_VERTEX_SHADER,
                     {shaders::eyes_glsl, shaders::surface_view_glsl, shaders::sensor_surface_glsl,
                      shaders::newest_in_view_glsl, shaders::mesh_vert}},
                    {GL_FRAGMENT_SHADER, {shaders::mesh_frag}}});
  if (!program) return std::move(program).error();
  return MeshRenderer(std::move(program).value());
}

MeshRenderer::MeshRenderer(GlProgram program)
    : program_(std::move(program)), vertices_(GlVertexArray::create()) {}

void MeshRenderer::draw(const SensorSurface& surface, const SurfaceMesh& mesh,
                        const SurfaceView& view) const {
  if (mesh.count == 0) return;
  set_surface_view(program_, view);
  surface.bind();
  glUseProgram(program_.name());
  glVertexArrayElementBuffer(vertices_.name(), mesh.indices.name());
  glBindVertexArray(vertices_.name());
  glEnable(GL_CULL_FACE);
  glDrawElementsInstanced(GL_TRIANGLES, mesh.count, GL_UNSIGNED_INT, nullptr, view.eyes.count());
  glDisable(GL_CULL_FACE);
}

}  // namespace roomcast::render
