// SPDX-License-Identifier: Apache-2.0
// Reads the fields of serialised ROS messages, in both of their serialisations:
//   ROS 1  packed little-endian; a header has a sequence number
//   ROS 2  CDR (OMG DDS-XTypes 1.3, 7.4, XCDR1): four bytes that name the byte order, then fields
//          aligned to their size; texts end with a zero
// Reading never leaves the given bytes: after the first field that does not fit, all fields read as
// zero or empty, and ok() returns false. Single-threaded.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "roomcast/core/clock.h"

namespace roomcast::recording::ros {

enum class Serialisation { kRos1, kRos2 };

class MessageReader {
 public:
  MessageReader(std::span<const std::uint8_t> message, Serialisation serialisation);

  [[nodiscard]] bool ok() const { return ok_; }

  std::uint8_t u8() { return static_cast<std::uint8_t>(integer(1)); }
  std::uint32_t u32() { return static_cast<std::uint32_t>(integer(4)); }
  double f64();
  std::string text();
  /// An array of bytes with its length, in the message.
  std::span<const std::uint8_t> bytes();
  /// The length of an array whose elements have at least `least_bytes` each; 0 if it cannot fit.
  std::uint32_t count(std::size_t least_bytes);

  struct Header {
    nanoseconds stamp{};
    std::string frame_id;
  };
  Header header();

 private:
  std::uint64_t integer(std::size_t size);
  void align(std::size_t size);
  bool need(std::uint64_t size);

  std::span<const std::uint8_t> all_;
  std::size_t at_ = 0;
  std::size_t origin_ = 0;  // from which CDR aligns
  Serialisation serialisation_;
  bool big_endian_ = false;
  bool ok_ = true;
};

}  // namespace roomcast::recording::ros
