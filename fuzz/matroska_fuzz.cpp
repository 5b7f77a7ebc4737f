// SPDX-License-Identifier: Apache-2.0
// Indexes an untrusted Matroska file: any bytes are refused or read, and no block is outside them.
#include <cstddef>
#include <cstdint>

#include "roomcast/recording/matroska/file_index.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace roomcast::recording;
  const auto index = matroska::read_file_index(*bytes_in_memory({data, data + size}));
  if (!index) return index.error().message.empty() ? (__builtin_trap(), 0) : 0;
  for (const matroska::Block& block : index->blocks) {
    if (block.offset > size || block.size > size - block.offset) __builtin_trap();
    if (block.track >= index->tracks.size()) __builtin_trap();
  }
  return 0;
}
