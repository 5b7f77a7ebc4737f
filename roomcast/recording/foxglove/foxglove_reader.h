// SPDX-License-Identifier: Apache-2.0
// FoxgloveReader: reads messages of Foxglove's schemas in Protobuf (foxglove.proto), as the ROS
// messages of the same content (ros/messages.h). Bytes are untrusted; views into them or into the
// reader hold until its next call. Its memory is reused from message to message. A stamp is zero
// where the message has none, or one outside the years 1970 to 2106. Single-threaded.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "roomcast/recording/ros/messages.h"

namespace roomcast::recording {

class FoxgloveReader {
 public:
  FoxgloveReader();
  ~FoxgloveReader();

  /// Nothing if the message is damaged.
  [[nodiscard]] std::optional<ros::ImageMessage> raw_image(ros::ByteView message);
  [[nodiscard]] std::optional<ros::CompressedImageMessage> compressed_image(ros::ByteView message);
  [[nodiscard]] std::optional<ros::CompressedImageMessage> compressed_video(ros::ByteView message);
  [[nodiscard]] std::optional<ros::CameraInfoMessage> calibration(ros::ByteView message);
  /// Of foxglove.FrameTransform and foxglove.FrameTransforms.
  [[nodiscard]] std::optional<std::vector<ros::StampedTransform>> transform(ros::ByteView message);
  [[nodiscard]] std::optional<std::vector<ros::StampedTransform>> transforms(ros::ByteView message);

 private:
  struct Parsed;
  std::unique_ptr<Parsed> parsed_;
};

}  // namespace roomcast::recording
