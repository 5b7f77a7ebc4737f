// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/depth_completion.h"

#include <bit>
#include <utility>

namespace roomcast::render {

Result<DepthCompletion> DepthCompletion::create() {
  auto programs = create_parts(&Programs::classify, &Programs::complete);
  if (!programs) return std::move(programs).error();
  return DepthCompletion(*std::move(programs));
}

void DepthCompletion::complete(const SensorSurface& sensor, const Known& known,
                               const Out& out) const {
  using shaders::classify_foreground_comp;
  using shaders::complete_depth_comp;
  const int width = sensor.intrinsics().width, height = sensor.intrinsics().height;
  const auto& [classify, complete] = programs_;
  classify.bind(classify_foreground_comp::newest_m, known.newest_m);
  classify.bind(classify_foreground_comp::color, sensor.color());
  classify.bind(classify_foreground_comp::background_color, known.color);
  classify.bind(classify_foreground_comp::background, known.readings);
  classify.bind(classify_foreground_comp::steadiness, known.steadiness);
  classify.set(classify_foreground_comp::color_shift,
               std::countr_zero(static_cast<unsigned>(sensor.color_scale())));
  classify.bind(classify_foreground_comp::classes, out.classes);
  classify.run(width, height);

  complete.bind(complete_depth_comp::newest_m, known.newest_m);
  complete.bind(complete_depth_comp::seen, sensor.seen());
  complete.bind(complete_depth_comp::classes, out.classes);
  complete.bind(complete_depth_comp::background, known.readings);
  complete.bind(complete_depth_comp::depth_out, out.depth_m);
  complete.bind(complete_depth_comp::seen_out, out.seen);
  complete.run(width, height);
}

}  // namespace roomcast::render
