// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/live/live_state.h"

#include <algorithm>

#include "roomcast/codec/live/state_hash.h"

namespace roomcast::codec {

void LiveState::resize(int new_width, int new_height) {
  width = new_width;
  height = new_height;
  blocks_wide = (width + kBlockSide - 1) / kBlockSide;
  blocks_high = (height + kBlockSide - 1) / kBlockSide;
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  for (auto* plane : {&picture, &picture_mm, &background}) plane->resize(pixels);
  static_age.resize(block_count());
  trace.resize(block_count());
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
