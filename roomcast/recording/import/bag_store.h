// SPDX-License-Identifier: Apache-2.0
// A ROS 1 bag as a RosStore. Single-threaded.
#pragma once

#include <memory>

#include "roomcast/recording/bytes/byte_source.h"
#include "roomcast/recording/import/ros_store.h"

namespace roomcast::recording {

/// Errors of rosbag::Bag::read.
[[nodiscard]] Result<std::shared_ptr<RosStore>> read_bag_store(std::unique_ptr<ByteSource> source);

}  // namespace roomcast::recording
