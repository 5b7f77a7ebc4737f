// SPDX-License-Identifier: Apache-2.0
// Opens a chunk: decompresses it (none or zstd), checks its CRC-32 and locates its records.
// Thread-safe (no state).
#pragma once

#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/recording/mcap/record_codec.h"

namespace roomcast::recording::mcap {

/// Move-only, because `messages` refer to `bytes`.
struct ChunkContents {
  ChunkContents() = default;
  ChunkContents(ChunkContents&&) = default;
  ChunkContents& operator=(ChunkContents&&) = default;

  Bytes bytes;
  std::vector<Schema> schemas;
  std::vector<Channel> channels;
  std::vector<Message> messages;  // in file order
};

/// `record`: content of a chunk record, whose memory is taken over. kMalformed if any part is
/// invalid, kTooLarge above kMaxChunkBytes, kUnsupported for another compression.
[[nodiscard]] Result<ChunkContents> open_chunk(Bytes record);

}  // namespace roomcast::recording::mcap
