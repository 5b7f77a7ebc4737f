// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/surface/mesh_renderer.h"

#include <utility>

#include "roomcast/render/gl/gl_state.h"

namespace roomcast::render {

Result<MeshRenderer> MeshRenderer::create() {
  Result<Program> program = Program::create();
  if (!program) return std::move(program).error();
  return MeshRenderer(*std::move(program));
}

MeshRenderer::MeshRenderer(Program program)
    : program_(std::move(program)), vertices_(GlVertexArray::create()) {}

void MeshRenderer::draw(const SensorSurface& surface, const SurfaceMesh& mesh,
                        const SurfaceView& view) const {
  if (mesh.count == 0) return;
  set_surface_view(program_, view);
  surface.bind_to(program_);
  program_.use();
  glVertexArrayElementBuffer(vertices_.name(), mesh.indices.name());
  glBindVertexArray(vertices_.name());
  const Enabled culling(GL_CULL_FACE);
  glDrawElementsInstanced(GL_TRIANGLES, mesh.count, GL_UNSIGNED_INT, nullptr, view.eyes.count());
}

}  // namespace roomcast::render
