// SPDX-License-Identifier: Apache-2.0
#include "bench/render/drawing_cost.h"

#include <ctime>

namespace roomcast::bench {
namespace {

constexpr double kHalfEyeDistance_m = 0.032;

render::ViewCamera aside(const render::ViewCamera& camera, double right_m) {
  render::ViewCamera moved = camera;
  moved.world_from_view.translation_m += right_m * camera.world_from_view.rotation.col(0);
  return moved;
}

/// Adds the cost of drawing each of `drawings` in turn. An uncounted drawing precedes them, in
/// which the renderer allocates targets for as many eyes.
Status add_cost(render::RoomRenderer& room, std::span<const render::Eyes> drawings,
                const render::OffscreenTarget& target, render::RenderMode mode,
                double& sum_cpu_ms) {
  if (auto first = drawing_cpu_ms(room, drawings.front(), target, mode); !first) {
    return first.error();
  }
  for (const render::Eyes& eyes : drawings) {
    const auto cost = drawing_cpu_ms(room, eyes, target, mode);
    if (!cost) return cost.error();
    sum_cpu_ms += *cost;
  }
  return {};
}

}  // namespace

double process_cpu_ms() {
  timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

Result<double> drawing_cpu_ms(render::RoomRenderer& room, const render::Eyes& eyes,
                              const render::OffscreenTarget& target, render::RenderMode mode) {
  glFinish();
  const double before = process_cpu_ms();
  const Status status = room.draw(eyes, target, mode);
  glFinish();
  if (!status) return status.error();
  return process_cpu_ms() - before;
}

Result<StereoCost> stereo_cost(render::RoomRenderer& room, const render::ViewCamera& between,
                               render::RenderMode mode, int times) {
  const auto for_one = render::OffscreenTarget::create(between.width, between.height);
  if (!for_one) return for_one.error();
  const auto for_both = render::OffscreenTarget::create(between.width, between.height, 2);
  if (!for_both) return for_both.error();
  const render::ViewCamera left = aside(between, -kHalfEyeDistance_m);
  const render::ViewCamera right = aside(between, kHalfEyeDistance_m);
  const std::array<render::Eyes, 2> one_by_one = {left, right};
  const std::array<render::Eyes, 1> at_once = {render::Eyes(left, right)};
  StereoCost cost;
  for (int i = 0; i < times; ++i) {
    auto status = add_cost(room, one_by_one, *for_one, mode, cost.one_by_one_cpu_ms);
    if (status) status = add_cost(room, at_once, *for_both, mode, cost.at_once_cpu_ms);
    if (!status) return status.error();
  }
  return cost;
}

}  // namespace roomcast::bench
