// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/zip/zip_archive.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include <zlib.h>

#include "roomcast/core/little_endian.h"

namespace roomcast::recording {
namespace {

constexpr std::uint32_t kEndMagic = 0x06054B50, kEnd64Magic = 0x06064B50;
constexpr std::uint32_t kLocator64Magic = 0x07064B50, kEntryMagic = 0x02014B50;
constexpr std::uint32_t kHeadMagic = 0x04034B50;
constexpr std::size_t kEndBytes = 22, kEnd64Bytes = 56, kLocator64Bytes = 20;
constexpr std::size_t kEntryBytes = 46, kHeadBytes = 30, kMaxComment = 65'535;
constexpr std::uint64_t kMaxDirectoryBytes = 1U << 30U;
constexpr std::uint32_t kIn64 = 0xFFFFFFFF;  // the number is in the extra field
constexpr std::uint16_t kStored = 0, kDeflated = 8, kExtra64 = 1, kEncrypted = 1;
/// Deflate packs at most 1032 : 1 (zlib, "Maximum compression factor").
constexpr std::uint64_t kMaxRatio = 1100;

Error damaged_zip() {
  return malformed("it is not a ZIP file, or its end is missing");
}

struct Directory {
  std::uint64_t offset = 0, size = 0, entries = 0;
};

/// The record at the end of the file, behind which there may be a comment.
Result<std::pair<std::uint64_t, Directory>> find_end(const ByteSource& source) {
  const std::uint64_t size = std::min<std::uint64_t>(source.size(), kEndBytes + kMaxComment);
  if (size < kEndBytes) return damaged_zip();
  std::vector<std::uint8_t> tail(static_cast<std::size_t>(size));
  const std::uint64_t begin = source.size() - size;
  if (Status status = source.read(begin, tail); !status) return status.error();
  for (std::size_t at = tail.size() - kEndBytes + 1; at-- > 0;) {
    const std::uint8_t* const end = tail.data() + at;
    if (read_u32(end) != kEndMagic || at + kEndBytes + read_u16(end + 20) != tail.size()) continue;
    return std::pair(begin + at,
                     Directory{read_u32(end + 16), read_u32(end + 12), read_u16(end + 10)});
  }
  return damaged_zip();
}

Result<Directory> find_directory(const ByteSource& source) {
  const auto end = find_end(source);
  if (!end) return end.error();
  Directory directory = end->second;
  std::array<std::uint8_t, kLocator64Bytes> locator{};
  const bool has_64 = end->first >= kLocator64Bytes &&
                      source.read(end->first - kLocator64Bytes, locator).ok() &&
                      read_u32(locator.data()) == kLocator64Magic;
  if (has_64) {
    std::array<std::uint8_t, kEnd64Bytes> large{};
    if (!source.read(read_u64(locator.data() + 8), large) || read_u32(large.data()) != kEnd64Magic)
      return damaged_zip();
    directory = {read_u64(large.data() + 48), read_u64(large.data() + 40),
                 read_u64(large.data() + 32)};
  }
  const bool fits = directory.offset <= source.size() &&
                    directory.size <= source.size() - directory.offset &&
                    directory.entries <= directory.size / kEntryBytes;
  if (!fits) return damaged_zip();
  if (directory.size > kMaxDirectoryBytes || directory.entries > kMaxZipEntries)
    return Error{ErrorCode::kTooLarge, "it has too many files"};
  return directory;
}

/// Replaces the numbers that did not fit into 32 bits. False: damaged.
bool take_64(std::span<const std::uint8_t> extra, ZipEntry& entry) {
  while (extra.size() >= 4) {
    const std::size_t size = read_u16(extra.data() + 2);
    if (size > extra.size() - 4) return false;
    std::span<const std::uint8_t> field = extra.subspan(4, size);
    if (read_u16(extra.data()) == kExtra64) {
      for (std::uint64_t* number : {&entry.size, &entry.packed_size, &entry.head_offset}) {
        if (*number != kIn64) continue;
        if (field.size() < 8) return false;
        *number = read_u64(field.data());
        field = field.subspan(8);
      }
      return true;
    }
    extra = extra.subspan(4 + size);
  }
  return true;
}

bool inflate_raw(std::span<const std::uint8_t> packed, std::span<std::uint8_t> out) {
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) return false;
  stream.next_in = const_cast<Bytef*>(packed.data());  // zlib only reads
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = out.data();
  stream.avail_out = static_cast<uInt>(out.size());
  const int code = inflate(&stream, Z_FINISH);
  const bool is_complete = code == Z_STREAM_END && stream.avail_out == 0;
  inflateEnd(&stream);
  return is_complete;
}

}  // namespace

Result<ZipArchive> ZipArchive::read(std::unique_ptr<ByteSource> source) {
  ZipArchive archive(std::move(source));
  if (Status status = archive.read_directory(); !status) return status.error();
  return archive;
}

Status ZipArchive::read_directory() {
  const auto place = find_directory(*source_);
  if (!place) return place.error();
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(place->size));
  if (Status status = source_->read(place->offset, bytes); !status) return status;
  std::span<const std::uint8_t> rest = bytes;
  for (std::uint64_t i = 0; i < place->entries; ++i) {
    if (rest.size() < kEntryBytes || read_u32(rest.data()) != kEntryMagic) return damaged_zip();
    const std::uint8_t* const at = rest.data();
    const std::size_t name_size = read_u16(at + 28), extra_size = read_u16(at + 30);
    const std::size_t whole = kEntryBytes + name_size + extra_size + read_u16(at + 32);
    if (whole > rest.size()) return damaged_zip();
    const std::uint16_t method = read_u16(at + 10);
    ZipEntry entry{
        read_u32(at + 42),
        read_u32(at + 20),
        read_u32(at + 24),
        read_u32(at + 16),
        method == kDeflated,
        (read_u16(at + 8) & kEncrypted) == 0 && (method == kStored || method == kDeflated)};
    if (!take_64(rest.subspan(kEntryBytes + name_size, extra_size), entry)) return damaged_zip();
    entries_[std::string(reinterpret_cast<const char*>(at) + kEntryBytes, name_size)] = entry;
    rest = rest.subspan(whole);
  }
  return {};
}

const ZipEntry* ZipArchive::find(const std::string& name) const {
  const auto found = entries_.find(name);
  return found == entries_.end() ? nullptr : &found->second;
}

Status ZipArchive::extract(const ZipEntry& entry, std::size_t limit,
                           std::vector<std::uint8_t>& out) const {
  const Error damaged = malformed("a file in it is damaged");
  if (!entry.is_readable)
    return Error{ErrorCode::kUnsupported,
                 "a file in it is encrypted, or compressed in a way that is not supported"};
  if (entry.size > limit || entry.packed_size > limit)
    return Error{ErrorCode::kTooLarge, "a file in it is too large"};
  const bool is_possible = entry.is_deflated ? entry.size <= kMaxRatio * (entry.packed_size + 1)
                                             : entry.size == entry.packed_size;
  std::array<std::uint8_t, kHeadBytes> head{};
  if (!is_possible || entry.head_offset > source_->size() ||
      !source_->read(entry.head_offset, head) || read_u32(head.data()) != kHeadMagic)
    return damaged;
  const std::uint64_t begin =
      entry.head_offset + kHeadBytes + read_u16(head.data() + 26) + read_u16(head.data() + 28);
  if (begin > source_->size() || entry.packed_size > source_->size() - begin) return damaged;
  std::vector<std::uint8_t> packed(static_cast<std::size_t>(entry.packed_size));
  if (Status status = source_->read(begin, packed); !status) return status;
  if (entry.is_deflated) {
    out.resize(static_cast<std::size_t>(entry.size));
    if (!inflate_raw(packed, out)) return damaged;
  } else {
    out = std::move(packed);
  }
  const uLong crc = crc32(0, out.data(), static_cast<uInt>(out.size()));
  return crc == entry.crc ? Status() : Status(damaged);
}

}  // namespace roomcast::recording
