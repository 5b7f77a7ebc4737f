// SPDX-License-Identifier: Apache-2.0
// Reads an untrusted ZIP file: any bytes are refused or read, within memory limits.
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "roomcast/recording/zip/zip_archive.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace roomcast::recording;
  constexpr std::size_t kMaxBytes = 1U << 20U;
  const auto archive = ZipArchive::read(bytes_in_memory({data, data + size}));
  if (!archive) return 0;
  std::vector<std::uint8_t> out;
  std::size_t tried = 0;
  for (const auto& [name, entry] : archive->entries()) {
    if (++tried > 64) break;
    const auto status = archive->extract(entry, kMaxBytes, out);
    if (status && (out.size() > kMaxBytes || out.size() != entry.size)) __builtin_trap();
  }
  return 0;
}
