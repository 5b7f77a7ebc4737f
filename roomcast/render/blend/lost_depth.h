// SPDX-License-Identifier: Apache-2.0
// LostDepth: finds objects that give no depth readings in front of a remembered background, and
// draws them in their live colour instead of the background's. Finds them by comparing the live
// colour with the background's; needs pictures with colour where depth is missing
// (geometry/hole_registration.h). Needs the GL context it was made with.
#pragma once

#include <utility>

#include "roomcast/core/result.h"
#include "roomcast/render/surface/sensor_surface.h"

namespace roomcast::render {

class LostDepth {
 public:
  /// kUnsupported with the driver's log if it rejects the shaders.
  static Result<LostDepth> create();

  /// As in BackgroundModel.
  struct Known {
    const GlTexture &newest_m, &readings, &color, &steadiness;
  };
  /// All of the depth grid's size.
  struct Out {
    const GlTexture &verdict, &depth_m, &seen;
  };
  /// Writes the newest readings and their colour mask, plus the depth of objects without readings.
  void cover(const SensorSurface& sensor, const Known& known, const Out& out) const;

 private:
  struct Programs {
    ComputeProgram<shaders::judge_lost_comp> judge;
    ComputeProgram<shaders::cover_lost_comp> cover;
  };
  explicit LostDepth(Programs programs) : programs_(std::move(programs)) {}

  Programs programs_;
};

}  // namespace roomcast::render
