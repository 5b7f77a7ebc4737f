// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/adaptive_renderer.h"

#include <utility>

#include "roomcast/render/shader_sources.h"

namespace roomcast {

Result<AdaptiveRenderer> AdaptiveRenderer::create() {
  auto program =
      make_program({{GL_VERTEX_SHADER, {shaders::blend_surface_glsl, shaders::adaptive_vert}},
                    {GL_FRAGMENT_SHADER, {shaders::blend_surface_glsl, shaders::adaptive_frag}}});
  if (!program) return std::move(program).error();
  return AdaptiveRenderer(*std::move(program));
}

void AdaptiveRenderer::draw(std::span<const SurfaceLayer> layers, const ViewCamera& camera,
                            const OffscreenTarget& target) const {
  target.bind();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glEnable(GL_CULL_FACE);
  for (const SurfaceLayer& layer : layers) painter_.draw(program_, layer, camera);
  glDisable(GL_CULL_FACE);
}

}  // namespace roomcast
