// SPDX-License-Identifier: Apache-2.0
// Parses the start of a VP9 frame, enough to refuse illegal frames of a colour section before a
// decoder allocates for them. Source: VP9 Bitstream & Decoding Process Specification v0.6, sections
// 6.2 and 7.2.
#pragma once

#include <cstdint>
#include <span>

#include "roomcast/core/result.h"

namespace roomcast::codec {

struct Vp9Header {
  bool key = false;
  int width = 0, height = 0;  // 0 if the frame takes the size of a reference
};

/// Returns kMalformed for bytes that are no VP9 frame; kUnsupported for a frame that
/// docs/spec/codec.md §3.1 excludes: another profile, not shown, or only a pointer to an earlier
/// frame.
[[nodiscard]] Result<Vp9Header> parse_vp9_header(std::span<const std::uint8_t> frame);

}  // namespace roomcast::codec
