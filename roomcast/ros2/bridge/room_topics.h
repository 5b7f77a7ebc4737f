// SPDX-License-Identifier: Apache-2.0
// RoomTopics: a room's frame sets as topics of ROS 2:
//   /roomcast/NAME/depth/image_raw, .../depth/camera_info    sensor_msgs/Image, CameraInfo
//   /roomcast/NAME/color/image_raw, .../color/camera_info    the same, in the depth grid
//   /roomcast/NAME/points                                    sensor_msgs/PointCloud2, organised
//   /roomcast/points                                         PointCloud2, merged, in `world`
//   /tf_static                                               tf2_msgs/TFMessage
// NAME is the sensor's, of letters, digits and "_". A picture is sent once, and only what somebody
// reads is made. Single-threaded.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/recording/export/foxglove_messages.h"
#include "roomcast/recording/export/merged_cloud.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"
#include "roomcast/ros2/bridge/messages.h"
#include "roomcast/ros2/dds/participant.h"

namespace roomcast::ros2 {

struct RoomTopicsOptions {
  std::string prefix = "/roomcast";  // of all topics but /tf_static
  recording::UpAxis up = recording::UpAxis::kZ;
  recording::MergedCloudOptions cloud = {};
  bool is_reliable = false;  // of pictures and points; else as ROS 2's sensor data

  /// kInvalidArgument.
  [[nodiscard]] Status check() const;
};

class RoomTopics {
 public:
  /// `options` pass their check(). kUnavailable.
  static Result<std::unique_ptr<RoomTopics>> open(Participant& participant,
                                                  RoomTopicsOptions options);

  /// The sensors of the room from now on.
  [[nodiscard]] Status set_sensors(const std::vector<recording::SetSensor>& sensors);
  /// How often names() has changed, the first ones included.
  [[nodiscard]] std::uint64_t changes() const { return changes_; }
  /// Names of the topics, sorted.
  [[nodiscard]] std::vector<std::string> names() const;

  /// Frames of `set` belong to the sensors of the last set_sensors(); times are UTC.
  [[nodiscard]] Status publish(const recording::FrameSet& set);

 private:
  struct SensorTopics {
    std::string part, frame;  // of names; in ROS
    CameraIntrinsics camera;
    Image<Eigen::Vector2f> rays;
    std::unique_ptr<Writer> depth, depth_info, color, color_info, points;
    std::shared_ptr<const codec::DecodedFrame> last;
  };

  RoomTopics(Participant& participant, RoomTopicsOptions options)
      : participant_(participant), options_(std::move(options)) {}

  [[nodiscard]] Result<std::unique_ptr<Writer>> writer(const std::string& name,
                                                       const std::string& type) const;
  [[nodiscard]] Result<SensorTopics> new_topics(const std::string& sensor) const;
  [[nodiscard]] std::string unused_part(const std::string& sensor) const;
  [[nodiscard]] Status publish_sensor(const recording::SetFrame& frame,
                                      const SensorTopics& topics) const;
  [[nodiscard]] Status publish_poses(const recording::FrameSet& set);

  Participant& participant_;
  const RoomTopicsOptions options_;
  std::unique_ptr<Writer> points_, transforms_;
  std::vector<recording::SetSensor> sensors_;
  std::uint64_t changes_ = 0;
  std::map<std::string, SensorTopics> topics_;  // by the sensor's name
  std::vector<FramePose> poses_;                // as published
  std::unique_ptr<recording::MergedCloud> merged_;
  recording::PointCloud cloud_;
};

}  // namespace roomcast::ros2
