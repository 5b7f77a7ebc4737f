// SPDX-License-Identifier: Apache-2.0
// Names of ROS 2: of topics and types in DDS, and of things of ours in ROS. Thread-safe (no state).
#pragma once

#include <string>
#include <string_view>

#include "roomcast/core/result.h"

namespace roomcast::ros2 {

/// kInvalidArgument unless it is an absolute name of ROS 2: "/camera/depth/image_raw".
[[nodiscard]] Status check_topic_name(std::string_view name);

/// "rt/camera/depth/image_raw".
[[nodiscard]] std::string dds_topic_name(std::string_view name);
/// "sensor_msgs::msg::dds_::Image_" of "sensor_msgs/msg/Image".
[[nodiscard]] std::string dds_type_name(std::string_view type);

/// A part of a topic's name made of any text: letters, digits and "_"; "s_2" of "s/2", "_2" of "2".
[[nodiscard]] std::string name_part(std::string_view text);

}  // namespace roomcast::ros2
