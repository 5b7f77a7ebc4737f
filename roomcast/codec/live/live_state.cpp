// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/live/live_state.h"

#include <algorithm>

#include "roomcast/codec/live/state_hash.h"

namespace roomcast::codec {

void LiveState::resize(int width, int height) {
  grid = BlockGrid(width, height);
  for (auto* plane : {&picture, &picture_mm, &background}) plane->resize(grid.pixel_count());
  static_age.resize(grid.block_count());
  trace.resize(grid.block_count());
  begin_anew({});
}

void LiveState::begin_anew(const SigmaCodes& sigma) {
  for (auto* plane : {&picture, &picture_mm, &background}) {
    std::fill(plane->begin(), plane->end(), std::uint16_t{0});
  }
  std::fill(static_age.begin(), static_age.end(), std::uint8_t{0});
  std::fill(trace.begin(), trace.end(), BlockTrace{});
  contexts = LiveContexts{};
  domain.set(sigma);
  StateHash mixed(0);
  for (const std::uint8_t code : sigma) mixed.add(code);
  hash = mixed.value();
}

}  // namespace roomcast::codec
