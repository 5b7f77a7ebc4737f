// SPDX-License-Identifier: Apache-2.0
// Draws the surfaces of several sensors as one: those that lie within about 2 cm + 1.2 % of the
// nearest are mixed, weighted by how well each was seen and by how alike the sensor's and the eye's
// directions are (Buehler et al. 2001). Holes among surfaces, and surfaces whose colour nobody saw,
// take the colour of what surrounds them, the far more than the near (push-pull, Gortler et al.
// 1996). Needs the GL context it was made with.
#pragma once

#include <span>
#include <vector>

#include "roomcast/render/blend/compute_pass.h"
#include "roomcast/render/blend/surface_layer.h"
#include "roomcast/render/view/eyes.h"
#include "roomcast/render/view/offscreen_target.h"

namespace roomcast::render {

/// What is shown where no sensor sees anything, or a surface without its colour.
enum class Unseen {
  kBackground,    // what was there before; a grey surface
  kHolesFilled,   // in holes among surfaces the colour of what surrounds them
  kSurroundings,  // everywhere the colour of what surrounds it, the smoother the farther
};

class BlendRenderer {
 public:
  /// kUnsupported with the driver's log when it does not take the shaders.
  static Result<BlendRenderer> create();

  /// Over the colours that `target` holds; nothing may have drawn depth there. Its size must be the
  /// eyes'.
  void draw(std::span<const SurfaceLayer> layers, const Eyes& eyes, Unseen unseen,
            const OffscreenTarget& target);

 private:
  struct Programs {
    GlProgram nearest, mix, resolve;
    ComputePass begin, shrink, grow, surroundings;
  };
  explicit BlendRenderer(Programs programs);

  void make_room(const Eyes& eyes);
  void draw_nearest(std::span<const SurfaceLayer> layers, const Eyes& eyes,
                    const OffscreenTarget& target);
  void mix(std::span<const SurfaceLayer> layers, const Eyes& eyes, const GlTexture& nearest_depth);
  void find_surroundings(const Eyes& eyes, Unseen unseen, const GlTexture& nearest_depth);
  void begin_surroundings(const Eyes& eyes, const GlTexture& nearest_depth);
  void finish_surroundings(Unseen unseen);
  void resolve(const OffscreenTarget& target);

  Programs programs_;
  LayerPainter painter_;
  GlVertexArray no_vertices_;              // of whole pictures
  int width_ = 0, height_ = 0, eyes_ = 0;  // of what follows
  GlTexture color_sum_;
  GlFramebuffer sum_target_, picture_target_;
  struct Level {  // a layer for each eye, so that neither takes colours from the other
    GlLayers color, coverage;
    int width = 0, height = 0;
  };
  std::vector<Level> levels_;  // each half of the one before, the first half of an eye's picture
};

}  // namespace roomcast::render
