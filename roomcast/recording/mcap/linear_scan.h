// SPDX-License-Identifier: Apache-2.0
// Reads an MCAP file from its beginning up to the first damage, for files without a summary. Reads
// every chunk, one at a time. Thread-safe (no state).
#pragma once

#include <cstdint>

#include "roomcast/recording/bytes/byte_source.h"
#include "roomcast/recording/mcap/records.h"

namespace roomcast::recording::mcap {

struct LinearScan {
  Summary summary;
  std::uint64_t sound_bytes = 0;  // end of the last valid record
};

/// Requires that the source begins with kMagic.
[[nodiscard]] LinearScan scan_from_start(const ByteSource& source);

}  // namespace roomcast::recording::mcap
