// SPDX-License-Identifier: Apache-2.0
// OutputFile: a file that only grows, by whole pieces: a piece that the disk has no room for leaves
// no trace. What append() has taken survives the end of this program, also a sudden one.
// Single-threaded.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "roomcast/core/result.h"

namespace roomcast::recording::mcap {

class OutputFile {
 public:
  /// kUnavailable when there is such a file already (nothing is overwritten) or it cannot be made.
  static Result<OutputFile> create(const std::filesystem::path& path);
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

  /// kUnavailable with the reason, a full disk for instance; the file then ends where it ended
  /// before.
  [[nodiscard]] Status append(std::span<const std::uint8_t> piece);
  /// The same for two pieces that belong together.
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
