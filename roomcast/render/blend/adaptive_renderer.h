// SPDX-License-Identifier: Apache-2.0
// AdaptiveRenderer: draws the cleaned surfaces of all sensors; the nearest wins. Takes one pass
// over few triangles, the quickest of the modes without holes. Needs the GL context it was made
// with.
#pragma once

#include <span>

#include "roomcast/render/blend/surface_layer.h"
#include "roomcast/render/view/offscreen_target.h"

namespace roomcast::render {

class AdaptiveRenderer {
 public:
  /// kUnsupported with the driver's log if it rejects the shaders.
  static Result<AdaptiveRenderer> create();

  /// Draws over the content of `target`. Its size must be the eyes'.
  void draw(std::span<const SurfaceLayer> layers, const Eyes& eyes,
            const OffscreenTarget& target) const;

 private:
  using Program = LayerProgram<shaders::adaptive_vert, shaders::adaptive_frag>;

  explicit AdaptiveRenderer(Program program) : program_(std::move(program)) {}

  Program program_;
  LayerPainter painter_;
};

}  // namespace roomcast::render
