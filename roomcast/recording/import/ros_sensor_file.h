// SPDX-License-Identifier: Apache-2.0
// RosSensorFile: one camera in a RosStore. Sensors of the same recording share its store, so all of
// them are used by one thread. Single-threaded.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/io/depth_values.h"
#include "roomcast/recording/import/ros_picture.h"
#include "roomcast/recording/import/ros_store.h"
#include "roomcast/recording/import/sensor_file.h"

namespace roomcast::recording {

/// One stream of pictures: its messages in order of their stamps, each stamp once.
struct RosStream {
  std::vector<std::size_t> messages;  // in the store
  std::vector<nanoseconds> stamps;    // of their headers
  bool is_compressed = false;         // sensor_msgs/CompressedImage
  std::string encoding;               // of the first picture, or its compressed format
  std::string frame_id;
};

/// `topic`: index in store.topics(). Messages that cannot be read are left out. Errors: kMalformed
/// if none can be.
[[nodiscard]] Result<RosStream> read_ros_stream(RosStore& store, std::uint32_t topic);

struct RosCameraParts {
  SensorFileInfo info;
  RosStream depth;
  std::optional<RosStream> color;
  std::vector<std::optional<std::size_t>> color_of_depth;  // position in `color`
  double depth_scale_to_metre = 0.001;
  bool yuv422_is_yuyv = false;
};

/// `name`: of the file, for messages.
[[nodiscard]] std::unique_ptr<SensorFile> make_ros_sensor(std::shared_ptr<RosStore> store,
                                                          RosCameraParts parts, std::string name);

}  // namespace roomcast::recording
