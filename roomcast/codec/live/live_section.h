// SPDX-License-Identifier: Apache-2.0
// The head of a live depth section. docs/spec/codec.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "roomcast/codec/live/depth_domain.h"
#include "roomcast/core/result.h"

namespace roomcast::codec {

struct LiveSectionHead {
  bool key = false;
  bool reference = false;     // changes the state that later frames build on
  std::uint8_t step = 0;      // quantiser of surfaces, levels
  std::uint8_t key_step = 0;  // the same for the first pass of a key frame
  SigmaCodes sigma{};         // of key frames
};

/// The hash of the state is written when it is known, at this offset from the
/// section's begin.
inline constexpr std::size_t kLiveHashOffset = 2;

/// kMalformed, or kUnsupported for flags of a later version. `bytes` is left at
/// the coded blocks.
Result<LiveSectionHead> read_live_head(std::span<const std::uint8_t>& bytes, std::uint32_t& hash);
/// Appends; the hash is left 0.
void write_live_head(const LiveSectionHead& head, std::vector<std::uint8_t>& out);

}  // namespace roomcast::codec
