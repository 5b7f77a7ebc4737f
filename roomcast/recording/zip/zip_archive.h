// SPDX-License-Identifier: Apache-2.0
// ZipArchive: the files in a ZIP file, stored or deflated, also larger than 4 GB (PKWARE's
// APPNOTE.TXT 6.3, sections 4.3 and 4.5.3). Not read: encrypted files, archives in several parts.
// Bytes are untrusted. Any number of threads may read.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/recording/bytes/byte_source.h"

namespace roomcast::recording {

/// More files are kTooLarge: 12 hours at 30 frames/s of three files each are 3.9 million.
inline constexpr std::size_t kMaxZipEntries = 4U << 20U;

struct ZipEntry {
  std::uint64_t head_offset = 0, packed_size = 0, size = 0;
  std::uint32_t crc = 0;
  bool is_deflated = false;
  bool is_readable = true;  // not encrypted, and of a known compression
};

class ZipArchive {
 public:
  /// kMalformed: not a ZIP file, or damaged; kTooLarge. Errors do not name the file.
  static Result<ZipArchive> read(std::unique_ptr<ByteSource> source);

  /// By name, as in the file: "rgbd/0.jpg".
  [[nodiscard]] const std::map<std::string, ZipEntry>& entries() const { return entries_; }
  /// Null if there is none.
  [[nodiscard]] const ZipEntry* find(const std::string& name) const;

  /// Replaces `out`. kTooLarge: more than `limit` bytes; kUnsupported; kMalformed: damaged.
  [[nodiscard]] Status extract(const ZipEntry& entry, std::size_t limit,
                               std::vector<std::uint8_t>& out) const;

 private:
  explicit ZipArchive(std::unique_ptr<ByteSource> source) : source_(std::move(source)) {}
  [[nodiscard]] Status read_directory();

  std::unique_ptr<ByteSource> source_;
  std::map<std::string, ZipEntry> entries_;
};

}  // namespace roomcast::recording
