// SPDX-License-Identifier: Apache-2.0
// BlendRenderer: draws the surfaces of several sensors as one. Surfaces within about 2 cm + 1.2 %
// of the nearest are mixed. Their weights are the quality of each pixel and the agreement between
// the sensor's and the eye's viewing directions (Buehler et al. 2001). Holes between surfaces, and
// surfaces whose colour no sensor saw, take the surrounding colour, in which far surfaces count
// more than near ones (push-pull, Gortler et al. 1996). Where no sensor shows anything, the room's
// model does, if there is one. Needs the GL context it was made with.
#pragma once

#include <span>
#include <vector>

#include "roomcast/render/blend/hole_map.h"
#include "roomcast/render/blend/still_model.h"
#include "roomcast/render/blend/surface_layer.h"
#include "roomcast/render/view/eyes.h"
#include "roomcast/render/view/offscreen_target.h"

namespace roomcast::render {

/// How to draw pixels without a surface, and surfaces without a colour.
enum class Unseen {
  kBackground,    // background as it was; grey surfaces
  kHolesFilled,   // holes between surfaces get the surrounding colour
  kSurroundings,  // every pixel gets the surrounding colour, smoother with distance
};

class BlendRenderer {
 public:
  /// kUnsupported with the driver's log if it rejects the shaders.
  static Result<BlendRenderer> create();

  /// Draws over the colours of `target`, which must contain no depth yet. Its size must be the
  /// eyes'.
  void draw(std::span<const SurfaceLayer> layers, StillModel& model, const Eyes& eyes,
            Unseen unseen, const OffscreenTarget& target);

 private:
  struct Programs {
    LayerProgram<shaders::nearest_vert, shaders::nearest_frag> nearest;
    LayerProgram<shaders::mix_vert, shaders::mix_frag> mix;
    ComputeProgram<shaders::shrink_picture_comp> begin;
    ComputeProgram<shaders::shrink_comp> shrink;
    ComputeProgram<shaders::grow_comp> grow;
    ComputeProgram<shaders::surroundings_comp> surroundings;
    DrawProgram<Vertex<shaders::whole_picture_vert>, Fragment<shaders::resolve_frag>> resolve;
  };
  explicit BlendRenderer(Programs programs);

  void make_room(const Eyes& eyes);
  void draw_nearest(std::span<const SurfaceLayer> layers, const Eyes& eyes,
                    const OffscreenTarget& target);
  void mix(std::span<const SurfaceLayer> layers, const Eyes& eyes, const GlTexture& nearest_depth);
  void fill(std::span<const SurfaceLayer> layers, StillModel& model, const Eyes& eyes,
            const GlTexture& nearest_depth);
  void find_holes(const GlTexture& nearest_depth);
  void find_surroundings(const Eyes& eyes, Unseen unseen, const GlTexture& nearest_depth);
  void begin_surroundings(const Eyes& eyes, const GlTexture& nearest_depth);
  void finish_surroundings(Unseen unseen);
  void resolve(const OffscreenTarget& target);

  Programs programs_;
  LayerPainter painter_;
  GlVertexArray no_vertices_;              // for full-screen passes
  int width_ = 0, height_ = 0, eyes_ = 0;  // size and count for the textures below
  GlTexture color_sum_;
  GlTexture shown_depth_;          // what sensors show, while the model is drawn
  std::vector<float> read_depth_;  // shown_depth_ on the CPU, and its holes; in software only
  HoleMap holes_;
  GlFramebuffer sum_target_, picture_target_;
  struct Level {  // one layer for each eye, so that eyes share no colours
    GlLayers color, coverage;
    int width = 0, height = 0;
  };
  std::vector<Level> levels_;  // each half the last one's size, from half an eye's part
};

}  // namespace roomcast::render
