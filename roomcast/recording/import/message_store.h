// SPDX-License-Identifier: Apache-2.0
// MessageStore: the messages of a recording with topics, whatever file they are in. Messages are
// read one at a time. Single-threaded.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/result.h"

namespace roomcast::recording {

struct StoredTopic {
  std::string name;  // "/camera/depth/image_raw"
  std::string type;  // "foxglove.RawImage"; that of ROS as ROS 1 names it: "sensor_msgs/Image"
  std::map<std::string, std::string> metadata = {};  // of an MCAP file's channel
};

/// Times of messages and stamps outside 0 to this (the year 2106) are no times.
inline constexpr nanoseconds kLatestStamp = std::chrono::seconds(4'294'967'296);

struct StoredMessage {
  std::uint32_t topic = 0;  // index in topics()
  nanoseconds time{};       // at which it was recorded
};

class MessageStore {
 public:
  virtual ~MessageStore() = default;
  [[nodiscard]] virtual const std::vector<StoredTopic>& topics() const = 0;
  /// In the order in which they are read fastest.
  [[nodiscard]] virtual const std::vector<StoredMessage>& messages() const = 0;
  /// The serialised message, valid until the next call. Errors of the file, which they do not name.
  [[nodiscard]] virtual Result<std::span<const std::uint8_t>> data(std::size_t message) = 0;
  /// Why the end of the recording cannot be read; nothing if it is complete.
  [[nodiscard]] virtual std::optional<std::string> damage() const = 0;
};

}  // namespace roomcast::recording
