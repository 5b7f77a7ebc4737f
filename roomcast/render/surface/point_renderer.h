// SPDX-License-Identifier: Apache-2.0
// PointRenderer: draws a sensor's surface as points, of one pixel each (as in the paper), or as
// squares sized by the screen distance between neighbouring readings, which leaves few holes. Draws
// into the bound framebuffer; needs the GL context it was made with.
#pragma once

#include <string_view>

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
  struct ForOneEye {
    static constexpr std::string_view text = "const bool kTwoEyes = false;\n";
  };
  struct ForTwoEyes {
    static constexpr std::string_view text = "const bool kTwoEyes = true;\n";
  };
  template <class Eyes>
  using Program = DrawProgram<
      Vertex<shaders::eyes_glsl, shaders::surface_view_glsl, shaders::sensor_surface_glsl,
             shaders::newest_in_view_glsl, shaders::points_vert>,
      Fragment<Eyes, shaders::points_frag>>;
  using AnyProgram =
      ProgramWith<shaders::eyes_glsl, shaders::surface_view_glsl, shaders::sensor_surface_glsl,
                  shaders::points_vert, shaders::points_frag>;
  struct Programs {
    Program<ForOneEye> for_one_eye;
    Program<ForTwoEyes> for_two_eyes;
  };

  explicit PointRenderer(Programs programs);
  [[nodiscard]] AnyProgram program_for(const Eyes& eyes) const;

  Programs programs_;
  GlVertexArray no_attributes_;  // the core profile requires one
};

}  // namespace roomcast::render
