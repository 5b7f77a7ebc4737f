// SPDX-License-Identifier: Apache-2.0
// The head of a live depth section. docs/spec/codec.md §2.4.
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
  bool reference = false;     // changes the state that later frames depend on
  std::uint8_t step = 0;      // quantiser of surfaces, levels
  std::uint8_t key_step = 0;  // the same for the first pass of a key frame
  SigmaCodes sigma{};         // of key frames
};

/// Offset of the state's hash in the section. The encoder writes the hash after the blocks.
inline constexpr std::size_t kLiveHashOffset = 2;

/// Returns kMalformed, or kUnsupported for flags of a later version. Advances `bytes` to the coded
/// blocks.
Result<LiveSectionHead> read_live_head(std::span<const std::uint8_t>& bytes, std::uint32_t& hash);
/// Appends the head with 0 as the hash.
void write_live_head(const LiveSectionHead& head, std::vector<std::uint8_t>& out);

}  // namespace roomcast::codec
