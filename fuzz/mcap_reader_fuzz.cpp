// SPDX-License-Identifier: Apache-2.0
// Reads an untrusted MCAP file: any bytes are refused or read, within memory limits.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "roomcast/recording/mcap/reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace roomcast::recording::mcap;
  const auto reader =
      Reader::read(roomcast::recording::bytes_in_memory({data, data + size}), "fuzz");
  if (!reader) return 0;
  const std::size_t chunks = std::min<std::size_t>(reader->summary().chunks.size(), 16);
  for (std::size_t i = 0; i < chunks; ++i) {
    const auto chunk = reader->chunk(i);
    if (!chunk) continue;
    std::size_t sum = 0;  // reads every byte, so that the sanitizer detects bytes out of bounds
    for (const Message& message : chunk->messages)
      sum = std::accumulate(message.data.begin(), message.data.end(), sum);
    if (sum > 255 * kMaxChunkBytes) __builtin_trap();
  }
  for (const auto& entry : reader->summary().metadata) (void)reader->metadata(entry.name);
  return 0;
}
