// SPDX-License-Identifier: Apache-2.0
// Reads and writes the fields of MCAP records: little-endian integers, and strings and maps
// prefixed with their length. Reading never leaves the given bytes: after the first field that does
// not fit, all fields read as zero or empty, and ok() returns false.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/recording/mcap/records.h"

namespace roomcast::recording::mcap {

class FieldReader {
 public:
  explicit FieldReader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  [[nodiscard]] bool ok() const { return ok_; }
  [[nodiscard]] std::span<const std::uint8_t> rest() const { return rest_; }

  std::uint8_t u8() { return static_cast<std::uint8_t>(integer(1)); }
  std::uint16_t u16() { return static_cast<std::uint16_t>(integer(2)); }
  std::uint32_t u32() { return static_cast<std::uint32_t>(integer(4)); }
  std::uint64_t u64() { return integer(8); }
  nanoseconds time() { return nanoseconds(static_cast<std::int64_t>(u64())); }
  std::span<const std::uint8_t> bytes(std::uint64_t count);
  std::string string();
  StringMap string_map();
  std::map<ChannelId, std::uint64_t> channel_map();

 private:
  std::uint64_t integer(std::size_t bytes);

  std::span<const std::uint8_t> rest_;
  bool ok_ = true;
};

/// Appends to `out`.
class FieldWriter {
 public:
  explicit FieldWriter(std::vector<std::uint8_t>& out) : out_(out) {}

  void u8(std::uint8_t value) { out_.push_back(value); }
  void u16(std::uint16_t value) { integer(value, 2); }
  void u32(std::uint32_t value) { integer(value, 4); }
  void u64(std::uint64_t value) { integer(value, 8); }
  void time(nanoseconds value) { u64(static_cast<std::uint64_t>(value.count())); }
  void bytes(std::span<const std::uint8_t> bytes) {
    out_.insert(out_.end(), bytes.begin(), bytes.end());
  }
  void string(std::string_view text);
  void string_map(const StringMap& map);
  void channel_map(const std::map<ChannelId, std::uint64_t>& map);

 private:
  void integer(std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) out_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
  std::vector<std::uint8_t>& out_;
};

/// Appends a record; `write_fields(FieldWriter&)` writes its content.
template <class WriteFields>
void append_record(std::vector<std::uint8_t>& out, Opcode opcode, WriteFields write_fields) {
  FieldWriter fields(out);
  fields.u8(static_cast<std::uint8_t>(opcode));
  const std::size_t length_at = out.size();
  fields.u64(0);
  write_fields(fields);
  const std::uint64_t length = out.size() - length_at - 8;
  for (std::size_t i = 0; i < 8; ++i)
    out[length_at + i] = static_cast<std::uint8_t>(length >> (8 * i));
}

}  // namespace roomcast::recording::mcap
