// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/surface_layer.h"

#include "roomcast/render/gl/shader_sources.h"
#include "roomcast/render/view/surface_view.h"

namespace roomcast::render {
namespace {

constexpr float kBackgroundSetback_m = 0.03F;

// As in shaders/blend/.
enum SurfaceTexture : GLuint { kDepth = 0, kRays = 1, kColor = 2, kQuality = 4 };
constexpr GLint kSetback = 5;  // uniform

}  // namespace

Result<GlProgram> make_layer_program(std::string_view vertex_shader,
                                     std::string_view fragment_shader) {
  return make_program({{GL_VERTEX_SHADER,
                        {shaders::eyes_glsl, shaders::surface_view_glsl,
                         shaders::blend_surface_glsl, shaders::blend_in_view_glsl, vertex_shader}},
                       {GL_FRAGMENT_SHADER, {shaders::blend_surface_glsl, fragment_shader}}});
}

void LayerPainter::draw(const GlProgram& program, const SurfaceLayer& layer,
                        const Eyes& eyes) const {
  const AdaptiveMesh& mesh = layer.surface->mesh;
  const SurfaceView view = surface_view(layer.sensor, layer.world_from_depth, eyes);
  set_surface_view(program, view);
  glProgramUniform1f(program.name(), kSetback, layer.is_background ? kBackgroundSetback_m : 0);
  glBindTextureUnit(kDepth, layer.surface->depth_m.name());
  glBindTextureUnit(kRays, layer.rays->name());
  glBindTextureUnit(kColor, layer.surface->weighted_color.name());
  glBindTextureUnit(kQuality, layer.surface->quality.name());
  glUseProgram(program.name());
  glVertexArrayElementBuffer(vertices_.name(), mesh.indices.name());
  glBindVertexArray(vertices_.name());
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, mesh.commands.name());
  const GLintptr command = (eyes.count() - 1) * AdaptiveMesh::kCommandBytes;
  glDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, reinterpret_cast<const void*>(command));
}

}  // namespace roomcast::render
