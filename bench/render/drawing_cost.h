// SPDX-License-Identifier: Apache-2.0
// CPU cost of drawing: all threads of the process, because a software driver draws on threads of
// its own.
#pragma once

#include "roomcast/core/result.h"
#include "roomcast/render/room_renderer.h"
#include "roomcast/render/view/eyes.h"
#include "roomcast/render/view/offscreen_target.h"

namespace roomcast::bench {

/// CPU time of all threads of the process so far.
[[nodiscard]] double process_cpu_ms();

/// CPU time of one drawing, from the first call until it is finished. Errors as RoomRenderer::draw.
[[nodiscard]] Result<double> drawing_cpu_ms(render::RoomRenderer& room, const render::Eyes& eyes,
                                            const render::OffscreenTarget& target,
                                            render::RenderMode mode);

/// Cost of drawing both eyes of a viewer at `between`, at once and one after the other, in turns so
/// that other load on the machine slows both. Sums over `times` drawings. Errors as
/// RoomRenderer::draw.
struct StereoCost {
  double at_once_cpu_ms = 0, one_by_one_cpu_ms = 0;
};
[[nodiscard]] Result<StereoCost> stereo_cost(render::RoomRenderer& room,
                                             const render::ViewCamera& between,
                                             render::RenderMode mode, int times);

}  // namespace roomcast::bench
