// SPDX-License-Identifier: Apache-2.0
// LostDepth: what stands before a remembered background without giving a reading is drawn in its
// live colour, not as that background. Told apart by what the colour camera sees there; needs
// pictures whose colour says that (geometry/hole_registration.h). Needs the GL context it was made
// with.
#pragma once

#include "roomcast/core/result.h"
#include "roomcast/render/blend/compute_pass.h"
#include "roomcast/render/surface/sensor_surface.h"

namespace roomcast::render {

class LostDepth {
 public:
  /// kUnsupported with the driver's log when it does not take the shaders.
  static Result<LostDepth> create();

  /// As BackgroundModel keeps it.
  struct Known {
    const GlTexture &newest_m, &readings, &color, &steadiness;
  };
  /// All of the depth grid's size.
  struct Out {
    const GlTexture &verdict, &depth_m, &seen;
  };
  /// Writes the newest readings and where they have a colour, and beside them what was covered.
  void cover(const SensorSurface& sensor, const Known& known, const Out& out) const;

 private:
  LostDepth(ComputePass judge, ComputePass cover)
      : judge_(std::move(judge)), cover_(std::move(cover)) {}

  ComputePass judge_, cover_;
};

}  // namespace roomcast::render
