// SPDX-License-Identifier: Apache-2.0
// Records of ROS 1 bags, version 2.0 (http://wiki.ros.org/Bags/Format/2.0): a header of named
// fields, then data; both with their length. Nothing is read outside the given bytes. Thread-safe
// (no state).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "roomcast/core/clock.h"

namespace roomcast::recording::rosbag {

using ByteView = std::span<const std::uint8_t>;

/// Named fields of a header; the values point into the bytes that were read.
class Fields {
 public:
  /// Nothing if a field does not fit, or has no name.
  [[nodiscard]] static std::optional<Fields> read(ByteView header);

  [[nodiscard]] std::optional<std::uint8_t> u8(std::string_view name) const;
  [[nodiscard]] std::optional<std::uint32_t> u32(std::string_view name) const;
  [[nodiscard]] std::string text(std::string_view name) const;  // empty if it is absent

 private:
  std::map<std::string_view, ByteView> values_;
};

enum class Op : std::uint8_t {
  kMessage = 2,
  kBagHeader = 3,
  kIndex = 4,
  kChunk = 5,
  kChunkInfo = 6,
  kConnection = 7,
};

struct Record {
  Fields fields;
  ByteView data;
};

/// Removes the first record from `bytes`; nothing, and `bytes` unchanged, if it is incomplete or
/// damaged.
[[nodiscard]] std::optional<Record> take_record(ByteView& bytes);

/// Seconds and nanoseconds, 32 bits each.
[[nodiscard]] nanoseconds ros_time(const std::uint8_t* bytes);

}  // namespace roomcast::recording::rosbag
