// SPDX-License-Identifier: Apache-2.0
// Decompresses the chunks of ROS 1 bags: none, bz2, lz4 (frames of LZ4). Thread-safe (no state).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/recording/rosbag/record.h"

namespace roomcast::recording::rosbag {

/// Of a chunk, stored and decompressed. A bag begins a new one after 768 KB or a larger message.
inline constexpr std::size_t kMaxChunkBytes = 256U << 20U;

/// Replaces `plain` by the `size` bytes that `stored` contains. kMalformed; kTooLarge;
/// kUnsupported: another compression.
[[nodiscard]] Status decompress_chunk(const std::string& compression, ByteView stored,
                                      std::size_t size, std::vector<std::uint8_t>& plain);

}  // namespace roomcast::recording::rosbag
