// SPDX-License-Identifier: Apache-2.0
// PointRenderer: draws a sensor's surface as points, of one pixel each (as in the paper), or as
// squares sized by the screen distance between neighbouring readings, which leaves few holes. Draws
// into the bound framebuffer; needs the GL context it was made with.
#pragma once

#include <array>

#include "roomcast/render/gl/gl_program.h"
#include "roomcast/render/surface/sensor_surface.h"
#include "roomcast/render/view/surface_view.h"

namespace roomcast::render {

enum class PointSize { kOnePixel, kAsSurface };

class PointRenderer {
 public:
  /// kUnsupported with the driver's log if it rejects the shaders.
  static Result<PointRenderer> create();

  void draw(const SensorSurface& surface, const SurfaceView& view, PointSize size) const;

 private:
  PointRenderer(GlProgram for_one_eye, GlProgram for_two);

  std::array<GlProgram, kMaxEyes> programs_;  // for one eye, for two
  GlVertexArray no_attributes_;               // the core profile requires one
};

}  // namespace roomcast::render
