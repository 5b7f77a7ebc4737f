// SPDX-License-Identifier: Apache-2.0
// The end of an MCAP file after the last chunk: summary, summary offsets and footer, which readers
// use as an index. Thread-safe (no state).
#pragma once

#include <cstdint>
#include <map>

#include "roomcast/core/result.h"
#include "roomcast/recording/mcap/record_codec.h"

namespace roomcast::recording::mcap {

/// Appends data end, summary, summary offsets, footer and magic to a file that is `offset` bytes
/// long.
void append_end(Bytes& out, const Summary& summary, std::uint64_t offset);

/// Adds a chunk and its messages to the counts and the index.
void add_to_summary(Summary& summary, ChunkIndex index,
                    const std::map<ChannelId, MessageOffsets>& offsets);

struct Footer {
  std::uint64_t summary_start = 0;  // 0: no summary
  std::uint32_t summary_crc = 0;    // 0: not available
};
/// Parses the last bytes of a file. kMalformed if they are not a footer followed by the magic.
[[nodiscard]] Result<Footer> read_footer(ByteView last_bytes);

/// `section`: bytes from the footer's summary_start to just before the footer's CRC. kMalformed if
/// the CRC or a record is invalid.
[[nodiscard]] Result<Summary> read_summary(ByteView section, const Footer& footer);

}  // namespace roomcast::recording::mcap
