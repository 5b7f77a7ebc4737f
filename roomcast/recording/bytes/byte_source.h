// SPDX-License-Identifier: Apache-2.0
// ByteSource: random access to the bytes of a recording, or to memory in tests. Any number of
// threads may read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "roomcast/core/result.h"

namespace roomcast::recording {

class ByteSource {
 public:
  virtual ~ByteSource() = default;
  [[nodiscard]] virtual std::uint64_t size() const = 0;
  /// Fills `out` from `offset` on. kMalformed if the source ends before that or cannot be read.
  [[nodiscard]] virtual Status read(std::uint64_t offset, std::span<std::uint8_t> out) const = 0;
};

/// kNotFound if there is no such file, or it is a folder.
[[nodiscard]] Result<std::unique_ptr<ByteSource>> open_file(const std::filesystem::path& path);

[[nodiscard]] std::unique_ptr<ByteSource> bytes_in_memory(std::vector<std::uint8_t> bytes);

}  // namespace roomcast::recording
