// SPDX-License-Identifier: Apache-2.0
// What drawing costs: CPU time of all threads of the process, for a software driver draws there.
#pragma once

#include "roomcast/core/result.h"
#include "roomcast/render/room_renderer.h"
#include "roomcast/render/view/eyes.h"
#include "roomcast/render/view/offscreen_target.h"

namespace roomcast::bench {

/// Of all threads of the process, so far.
[[nodiscard]] double process_cpu_ms();

/// Of one drawing, from the first call until all is drawn. Errors as RoomRenderer::draw.
[[nodiscard]] Result<double> drawing_cpu_ms(render::RoomRenderer& room, const render::Eyes& eyes,
                                            const render::OffscreenTarget& target, render::RenderMode mode);

/// Both eyes of somebody who stands at `between`: drawn at once, and one after the other, in turns
/// so that whatever else runs slows both. Sums over `times` drawings. Errors as RoomRenderer::draw.
struct StereoCost {
  double at_once_cpu_ms = 0, one_by_one_cpu_ms = 0;
};
[[nodiscard]] Result<StereoCost> stereo_cost(render::RoomRenderer& room, const render::ViewCamera& between,
                                             render::RenderMode mode, int times);

}  // namespace roomcast::bench
