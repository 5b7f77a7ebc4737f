// SPDX-License-Identifier: Apache-2.0
// RosStore: the messages of a ROS recording, in one of its serialisations. Single-threaded.
#pragma once

#include <string>

#include "roomcast/recording/import/message_store.h"
#include "roomcast/recording/ros/messages.h"

namespace roomcast::recording {

/// "sensor_msgs/Image" of ROS 2's "sensor_msgs/msg/Image".
[[nodiscard]] inline std::string ros1_type(const std::string& type) {
  const std::size_t at = type.find("/msg/");
  return at == std::string::npos ? type : type.substr(0, at) + type.substr(at + 4);
}

class RosStore : public MessageStore {
 public:
  [[nodiscard]] virtual ros::Serialisation serialisation() const = 0;
};

}  // namespace roomcast::recording
