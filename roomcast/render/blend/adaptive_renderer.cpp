// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/adaptive_renderer.h"

#include <utility>

namespace roomcast::render {

Result<AdaptiveRenderer> AdaptiveRenderer::create() {
  Result<Program> program = Program::create();
  if (!program) return std::move(program).error();
  return AdaptiveRenderer(*std::move(program));
}

void AdaptiveRenderer::draw(std::span<const SurfaceLayer> layers, const Eyes& eyes,
                            const OffscreenTarget& target) const {
  target.bind();
  const EyeBorders borders(eyes);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  for (const SurfaceLayer& layer : layers) painter_.draw(program_, layer, eyes);
}

}  // namespace roomcast::render
