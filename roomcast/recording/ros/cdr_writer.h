// SPDX-License-Identifier: Apache-2.0
// Writes the fields of a ROS 2 message: CDR, little-endian (OMG DDS-XTypes 1.3, 7.4, XCDR1), the
// counterpart of MessageReader. Single-threaded.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "roomcast/core/clock.h"

namespace roomcast::recording::ros {

class CdrWriter {
 public:
  /// `expected_bytes` of the whole message saves allocations.
  explicit CdrWriter(std::size_t expected_bytes = 0);

  CdrWriter& u8(std::uint8_t value) { return integer(value, 1); }
  CdrWriter& u32(std::uint64_t value) { return integer(value, 4); }
  CdrWriter& f64(double value);
  CdrWriter& text(std::string_view value);
  /// `stamp` since 1970-01-01 UTC.
  CdrWriter& header(nanoseconds stamp, std::string_view frame_id);
  /// The length of an array of `size` bytes, for the caller to fill. Valid until the
  /// next call.
  std::span<std::uint8_t> bytes(std::size_t size);

  /// Part of an array of bytes, whose length was written as u32 before its first part.
  CdrWriter& part(std::span<const std::uint8_t> bytes) {
    out_.insert(out_.end(), bytes.begin(), bytes.end());
    return *this;
  }

  /// The message, filled up to a multiple of four bytes as DDS sends it.
  [[nodiscard]] std::vector<std::uint8_t> done();

 private:
  CdrWriter& integer(std::uint64_t value, std::size_t size);

  std::vector<std::uint8_t> out_;
};

}  // namespace roomcast::recording::ros
