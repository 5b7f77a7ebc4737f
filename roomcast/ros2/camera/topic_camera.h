// SPDX-License-Identifier: Apache-2.0
// A camera of a running ROS 2 system, for CameraSource: depth (16UC1, 32FC1), and colour if a topic
// of it is given, sensor_msgs/Image or, where the topic ends in "compressed" or "compressedDepth",
// CompressedImage. The cameras are described by the CameraInfo beside the pictures, in
// "camera_info" of the same namespace; the transform between the two comes from /tf_static. Stamps
// of the messages are the device's time. Metres, millimetres of depth.
#pragma once

#include <memory>
#include <stop_token>
#include <string>

#include "roomcast/ros2/dds/participant.h"
#include "roomcast/source/camera/camera.h"

namespace roomcast::ros2 {

struct TopicCameraOptions {
  std::chrono::milliseconds patience{5000};  // for the messages that describe a camera
  std::stop_token stop = {};                 // ends the waiting
};

/// Places: "DEPTH" or "DEPTH,COLOR", names of topics. Opening: kInvalidArgument, not such names;
/// kNotFound, what did not come in time; kUnsupported, an encoding or lens; errors of
/// options_of_environment() and Participant::open().
[[nodiscard]] std::unique_ptr<source::CameraBackend> topic_camera_backend(
    TopicCameraOptions options = {});

/// A sensor's name made of the topic's namespace: "camera" of "/camera/depth/image_raw".
[[nodiscard]] std::string camera_name_of_topic(const std::string& place);

}  // namespace roomcast::ros2
