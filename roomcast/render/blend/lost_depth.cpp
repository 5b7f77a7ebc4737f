// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/lost_depth.h"

#include <bit>
#include <utility>

namespace roomcast::render {

Result<LostDepth> LostDepth::create() {
  auto programs = create_parts(&Programs::judge, &Programs::cover);
  if (!programs) return std::move(programs).error();
  return LostDepth(*std::move(programs));
}

void LostDepth::cover(const SensorSurface& sensor, const Known& known, const Out& out) const {
  using shaders::cover_lost_comp;
  using shaders::judge_lost_comp;
  const int width = sensor.intrinsics().width, height = sensor.intrinsics().height;
  const auto& [judge, cover] = programs_;
  judge.bind(judge_lost_comp::newest_m, known.newest_m);
  judge.bind(judge_lost_comp::color, sensor.color());
  judge.bind(judge_lost_comp::background_color, known.color);
  judge.bind(judge_lost_comp::background, known.readings);
  judge.bind(judge_lost_comp::steadiness, known.steadiness);
  judge.set(judge_lost_comp::color_shift,
            std::countr_zero(static_cast<unsigned>(sensor.color_scale())));
  judge.bind(judge_lost_comp::verdict, out.verdict);
  judge.run(width, height);

  cover.bind(cover_lost_comp::newest_m, known.newest_m);
  cover.bind(cover_lost_comp::seen, sensor.seen());
  cover.bind(cover_lost_comp::verdict, out.verdict);
  cover.bind(cover_lost_comp::background, known.readings);
  cover.bind(cover_lost_comp::depth_out, out.depth_m);
  cover.bind(cover_lost_comp::seen_out, out.seen);
  cover.run(width, height);
}

}  // namespace roomcast::render
