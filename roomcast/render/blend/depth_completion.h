// SPDX-License-Identifier: Apache-2.0
// DepthCompletion: finds objects that give no depth readings in front of a remembered background,
// and draws them in their live colour instead of the background's. Finds them by comparing the live
// colour with the background's; needs pictures with colour where depth is missing
// (geometry/hole_registration.h). Needs the GL context it was made with.
#pragma once

#include <utility>

#include "roomcast/core/result.h"
#include "roomcast/render/surface/sensor_surface.h"

namespace roomcast::render {

class DepthCompletion {
 public:
  /// kUnsupported with the driver's log if it rejects the shaders.
  static Result<DepthCompletion> create();

  /// As in BackgroundModel.
  struct Known {
    const GlTexture &newest_m, &readings, &color, &steadiness;
  };
  /// All of the depth grid's size.
  struct Out {
    const GlTexture &classes, &depth_m, &seen;
  };
  /// Writes the newest readings and their colour mask, plus the depth of objects without readings.
  void complete(const SensorSurface& sensor, const Known& known, const Out& out) const;

 private:
  struct Programs {
    ComputeProgram<shaders::classify_foreground_comp> classify;
    ComputeProgram<shaders::complete_depth_comp> complete;
  };
  explicit DepthCompletion(Programs programs) : programs_(std::move(programs)) {}

  Programs programs_;
};

}  // namespace roomcast::render
