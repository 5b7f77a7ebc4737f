// SPDX-License-Identifier: Apache-2.0
// Draws a sensor's surface as points: of one pixel each (the paper's rendering), or as squares as
// large on the screen as the surface between a reading and its neighbours, so that there are few
// holes. Draws into the bound framebuffer; needs the GL context it was made with.
#pragma once

#include <array>

#include "roomcast/render/gl/gl_program.h"
#include "roomcast/render/surface/sensor_surface.h"
#include "roomcast/render/view/surface_view.h"

namespace roomcast::render {

enum class PointSize { kOnePixel, kAsSurface };

class PointRenderer {
 public:
  /// kUnsupported with the driver's log when it does not take the shaders.
  static Result<PointRenderer> create();

  void draw(const SensorSurface& surface, const SurfaceView& view, PointSize size) const;

 private:
  PointRenderer(GlProgram for_one_eye, GlProgram for_two);

  std::array<GlProgram, kMaxEyes> programs_;  // for one eye, for two
  GlVertexArray no_attributes_;               // a core context draws nothing without one
};

}  // namespace roomcast::render
