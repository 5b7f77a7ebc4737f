// SPDX-License-Identifier: Apache-2.0
// Reads an MCAP file from its beginning as far as it is sound, for files that end without a
// summary. Every chunk is read, one at a time. Thread-safe (no state).
#pragma once

#include <cstdint>

#include "roomcast/recording/mcap/byte_source.h"
#include "roomcast/recording/mcap/records.h"

namespace roomcast::recording::mcap {

struct LinearScan {
  Summary summary;
  std::uint64_t sound_bytes = 0;  // where the last sound record ends
};

/// The source begins with kMagic.
[[nodiscard]] LinearScan scan_from_start(const ByteSource& source);

}  // namespace roomcast::recording::mcap
