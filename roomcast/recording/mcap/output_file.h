// SPDX-License-Identifier: Apache-2.0
// OutputFile: an append-only file. A piece that does not fit on the disk is removed completely.
// Appended data survives a crash of this program. Single-threaded.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "roomcast/core/result.h"

namespace roomcast::recording::mcap {

class OutputFile {
 public:
  /// kUnavailable if the file exists already (nothing is overwritten) or cannot be created.
  static Result<OutputFile> create(const std::filesystem::path& path);
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

  /// kUnavailable with the reason, for instance a full disk; the file then keeps its previous size.
  [[nodiscard]] Status append(std::span<const std::uint8_t> piece);
  /// Appends two pieces as one.
  [[nodiscard]] Status append(std::span<const std::uint8_t> first,
                              std::span<const std::uint8_t> second);

  [[nodiscard]] std::uint64_t size() const { return size_; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  OutputFile(std::filesystem::path path, int descriptor)
      : path_(std::move(path)), descriptor_(descriptor) {}
  [[nodiscard]] bool write_all(std::span<const std::uint8_t> piece);
  [[nodiscard]] Error take_back();

  std::filesystem::path path_;
  int descriptor_;
  std::uint64_t size_ = 0;
};

}  // namespace roomcast::recording::mcap
