// SPDX-License-Identifier: Apache-2.0
// RosStore: the messages of a ROS recording, whatever file they are in. Messages are read one at a
// time. Single-threaded.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/recording/ros/messages.h"

namespace roomcast::recording {

struct RosTopic {
  std::string name;  // "/camera/depth/image_raw"
  std::string type;  // as ROS 1 names it: "sensor_msgs/Image"
};

/// Times of messages and stamps outside 0 to this (the year 2106) are no times.
inline constexpr nanoseconds kMaxRosTime = std::chrono::seconds(4'294'967'296);

struct RosMessage {
  std::uint32_t topic = 0;  // index in topics()
  nanoseconds time{};       // at which it was recorded
};

/// "sensor_msgs/Image" of ROS 2's "sensor_msgs/msg/Image".
[[nodiscard]] inline std::string ros1_type(const std::string& type) {
  const std::size_t at = type.find("/msg/");
  return at == std::string::npos ? type : type.substr(0, at) + type.substr(at + 4);
}

class RosStore {
 public:
  virtual ~RosStore() = default;
  [[nodiscard]] virtual ros::Serialisation serialisation() const = 0;
  [[nodiscard]] virtual const std::vector<RosTopic>& topics() const = 0;
  /// In the order in which they are read fastest.
  [[nodiscard]] virtual const std::vector<RosMessage>& messages() const = 0;
  /// The serialised message, valid until the next call. Errors of the file, which they do not name.
  [[nodiscard]] virtual Result<ros::ByteView> data(std::size_t message) = 0;
  /// Why the end of the recording cannot be read; nothing if it is complete.
  [[nodiscard]] virtual std::optional<std::string> damage() const = 0;
};

}  // namespace roomcast::recording
