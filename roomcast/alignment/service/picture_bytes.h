// SPDX-License-Identifier: Apache-2.0
// Depth pictures <-> bytes of messages: lossless key frames without colour (docs/spec/codec.md).
// Thread-safe (no state).
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"

namespace roomcast::alignment {

[[nodiscard]] std::span<const std::uint8_t> bytes_of(const std::string& text);

/// kInvalidArgument: the codec takes no picture of this size.
[[nodiscard]] Result<std::string> lossless_bytes(DepthView picture);

/// kMalformed: the bytes are not a picture of this size.
[[nodiscard]] Result<DepthImage> picture_of_bytes(const std::string& bytes, int width, int height);

}  // namespace roomcast::alignment
