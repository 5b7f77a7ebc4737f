// SPDX-License-Identifier: Apache-2.0
// The inside of a chunk: decompressed (none or zstd), its CRC-32 checked, its records found.
// Thread-safe (no state).
#pragma once

#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/recording/mcap/record_codec.h"

namespace roomcast::recording::mcap {

/// Moved, not copied: `messages` refer to `bytes`.
struct ChunkContents {
  ChunkContents() = default;
  ChunkContents(ChunkContents&&) = default;
  ChunkContents& operator=(ChunkContents&&) = default;

  Bytes bytes;
  std::vector<Schema> schemas;
  std::vector<Channel> channels;
  std::vector<Message> messages;  // in the order of the file
};

/// `record` is the content of a chunk record, whose memory is used. kMalformed when anything in it
/// is wrong, kTooLarge above kMaxChunkBytes, kUnsupported for another compression.
[[nodiscard]] Result<ChunkContents> open_chunk(Bytes record);

}  // namespace roomcast::recording::mcap
