// SPDX-License-Identifier: Apache-2.0
// The end of an MCAP file: what stands after the last chunk, so that readers find their way from
// there. Thread-safe (no state).
#pragma once

#include <cstdint>
#include <map>

#include "roomcast/core/result.h"
#include "roomcast/recording/mcap/record_codec.h"

namespace roomcast::recording::mcap {

/// Data end, summary, summary offsets, footer and magic, for a file that is `offset` bytes long.
void append_end(Bytes& out, const Summary& summary, std::uint64_t offset);

/// Counts a chunk and its messages.
void add_to_summary(Summary& summary, ChunkIndex index,
                    const std::map<ChannelId, MessageOffsets>& offsets);

struct Footer {
  std::uint64_t summary_start = 0;  // 0: there is none
  std::uint32_t summary_crc = 0;    // 0: not given
};
/// From the last bytes of a file. kMalformed when they are no footer with the magic after it.
[[nodiscard]] Result<Footer> read_footer(ByteView last_bytes);

/// `section` reaches from the footer's summary_start to just before the footer's CRC. kMalformed
/// when the CRC or a record is wrong.
[[nodiscard]] Result<Summary> read_summary(ByteView section, const Footer& footer);

}  // namespace roomcast::recording::mcap
