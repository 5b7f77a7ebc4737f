// SPDX-License-Identifier: Apache-2.0
// Draws the cleaned surfaces of all sensors; the nearest wins. One pass over few triangles: the
// quickest of the solid modes. Needs the GL context it was made with.
#pragma once

#include <span>

#include "roomcast/render/blend/surface_layer.h"
#include "roomcast/render/view/offscreen_target.h"

namespace roomcast::render {

class AdaptiveRenderer {
 public:
  /// kUnsupported with the driver's log when it does not take the shaders.
  static Result<AdaptiveRenderer> create();

  /// Over what `target` holds. Its size must be the eyes'.
  void draw(std::span<const SurfaceLayer> layers, const Eyes& eyes,
            const OffscreenTarget& target) const;

 private:
  explicit AdaptiveRenderer(GlProgram program) : program_(std::move(program)) {}

  GlProgram program_;
  LayerPainter painter_;
};

}  // namespace roomcast::render
